"""Which files of rules, words, gestures, characters, profiles and weights can be edited through the service, and what
new ones may be called.

Files are named by their place in a checkout (`app/rules/functions/lists.rules`, `lexicon/gestures/wag.gesture`) or, in
requests, shorter as in an author's folder (`rules/functions/lists.rules`, `gestures/wag.gesture`; docs/authoring.md).
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from ..authored_folders import AUTHORED, checkout_name, lexicon_folder, name_in_checkout, rules_folder
from ..errors import InputError, did_you_mean, shown

_OWN_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")

_HEARD = "abbreviations.yaml"
"""Not editable here, because the aligner reads it when it starts."""


@dataclass(frozen=True, slots=True)
class EditableFiles:
    """Files of one kind: `field` names them in errors, `kind` in messages; `places` are where a new one may be, the
    suffix by the folder."""

    field: str
    kind: str
    places: tuple[tuple[str, str], ...]
    others: tuple[str, ...] = ()
    """Patterns below the rules or the lexicon of further files, which are there and cannot be added."""

    def files(self) -> Mapping[str, Path]:
        """The files that there are, by their names."""
        found = {path for path in self._found() if path.suffix in AUTHORED and path.name != _HEARD and path.is_file()}
        return {name_in_checkout(path): path for path in sorted(found)}

    def is_new(self, name: str) -> bool:
        """Whether a file of that name does not exist yet, and would be read."""
        folder, _, own = name.rpartition("/")
        suffix = {name_in_checkout(_root(place)): suffix for place, suffix in self.places}.get(folder)
        is_named = suffix is not None and own.endswith(suffix) and _OWN_NAME.fullmatch(own.removesuffix(suffix))
        return bool(is_named) and own != _HEARD and name not in self.files()

    def known(self, name: str) -> str | None:
        """The name in a checkout of a file that exists or may be added, by that or its shorter name; None of others."""
        names = (name, checkout_name(name))
        return next((each for each in names if each and (each in self.files() or self.is_new(each))), None)

    def required(self, name: str) -> str:
        """As `known`; raises InputError `unknown_file` for a name of no such file."""
        full = self.known(name)
        if full is None:
            hint = did_you_mean(name, self.files()) or f"; GET /{self.field}/files lists those that are"
            where = ", ".join(f"{name_in_checkout(_root(place))}/NAME{suffix}" for place, suffix in self.places)
            message = f"{shown(name)} is no {self.kind}{hint}; a new one is {where}"
            raise InputError("unknown_file", message, field=self.field)
        return full

    def _found(self) -> Iterator[Path]:
        for place, suffix in self.places:
            yield from _root(place).rglob(f"*{suffix}")
        for pattern in self.others:
            kind, _, inside = pattern.partition("/")
            yield from _root(kind).glob(inside)


def _root(place: str) -> Path:
    """The folder of a place such as rules/functions or lexicon/en, as it is read."""
    kind, _, inside = place.partition("/")
    return (rules_folder() if kind == "rules" else lexicon_folder()) / inside


RULE_FILES = EditableFiles(
    "rules",
    "file of rules or words",
    (("rules/functions", ".rules"), ("rules/behaviors", ".rules"), ("lexicon/en", ".yaml")),
    ("rules/*.rules", "rules/*/*.yaml"),
)
LEXICON_FILES = EditableFiles(
    "lexicon",
    "file of gestures, a character, a profile or weights",
    (("lexicon/gestures", ".gesture"), ("lexicon/characters", ".yaml"), ("lexicon/profiles", ".yaml")),
    ("lexicon/acting/weights.yaml",),
)
