"""The files that an author edits through the service: which ones can be edited and what new ones may be called; reading
those saved in the author's folder, else those in use; and saving them, under a temporary name that is then renamed, and
only if they are still what the author read.

Files are named by their place in a checkout (`app/rules/functions/lists.rules`, `lexicon/gestures/wag.gesture`) or, in
requests, shorter as in an author's folder (`rules/functions/lists.rules`, `gestures/wag.gesture`; docs/authoring.md).
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import blake2b
from pathlib import Path

from ..authored_folders import AUTHORED, checkout_name, lexicon_folder, name_in_checkout, origin, rules_folder
from ..errors import ChangedError, ForbiddenError, InputError, did_you_mean, shown
from ..files import replace_file

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
            message = f"{shown(name)} is not a {self.kind}{hint}; a new one is {where}"
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


@dataclass(frozen=True, slots=True)
class SavedText:
    """A file's text, and whether it is the author's own, saved in the author's folder."""

    name: str
    text: str
    saved: bool

    @property
    def version(self) -> str:
        """Another for each text."""
        return blake2b(self.text.encode(), digest_size=12).hexdigest()


def read_text(kind: EditableFiles, name: str, folder: Path | None = None) -> SavedText:
    """The text of the file of that name, from `folder` if it is there; none of a new file. Raises InputError
    `unknown_file`, `rules_unreadable`."""
    name = kind.required(name)
    path = kind.files().get(name)
    own = _own(folder, name, path) if folder is not None else None
    if own is not None and own.is_file():
        return SavedText(name, _text(kind, own, name), saved=path is None or own.resolve() != path.resolve())
    return SavedText(name, "" if path is None else path.read_text(encoding="utf-8"), saved=False)


def saved_names(kind: EditableFiles, folder: Path | None) -> tuple[str, ...]:
    """The names of the files of a kind that are saved in `folder`."""
    if folder is None:
        return ()
    files = kind.files()
    inside = sorted(path for path in folder.rglob("*.*") if path.is_file())
    own = {path.relative_to(folder).as_posix(): path for path in inside}
    return tuple(
        name
        for name, path in own.items()
        if kind.is_new(name) or (name in files and path.resolve() != files[name].resolve())
    )


def write_text(
    kind: EditableFiles, name: str, text: str, folder: Path | None, *, version: str | None = None
) -> SavedText:
    """Saves the text as the file of that name in `folder`; `version` is that of the text which the author read, if that
    is to be replaced alone.

    Raises ForbiddenError `rules_read_only` if there is no folder or it cannot be written to,
    ChangedError `file_changed` if it holds another text meanwhile, InputError `unknown_file`.
    """
    require_folder(kind, folder)
    name = kind.required(name)
    if version is not None and read_text(kind, name, folder).version != version:
        message = f"{name} has changed since it was read; read it again, then save"
        raise ChangedError("file_changed", message, field=kind.field)
    assert folder is not None
    _replace(kind, _own(folder, name, kind.files().get(name)), name, text)
    return read_text(kind, name, folder)


def require_folder(kind: EditableFiles, folder: Path | None) -> None:
    """Raises ForbiddenError `rules_read_only` if there is none."""
    if folder is None:
        message = "no folder to save in; start `understudy studio --lexicon DIR` to save files in DIR"
        raise ForbiddenError("rules_read_only", message, field=kind.field)


def _own(folder: Path, name: str, in_use: Path | None) -> Path:
    """Where the author's file is: the one in use if it is in the author's folder, which may call it shorter."""
    used = origin(in_use) if in_use is not None else None
    return used if used is not None and used.resolve().is_relative_to(folder.resolve()) else folder / name


def _replace(kind: EditableFiles, target: Path, name: str, text: str) -> None:
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        replace_file(target, text.encode())
    except OSError as error:
        message = f"{name}: cannot be saved: {error.strerror}"
        raise ForbiddenError("rules_read_only", message, field=kind.field) from None


def _text(kind: EditableFiles, file: Path, name: str) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else f"it is not UTF-8 at byte {error.start}"
        message = f"{name}, as it was saved, cannot be read: {reason}"
        raise InputError("rules_unreadable", message, field=kind.field) from None
