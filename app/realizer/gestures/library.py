"""The gesture library: every definition under a folder, as clips by category, level of agitation and hand.

A folder holds `*.gesture` files, in subfolders as well, and may hold `aliases.yaml`: lexemes that other BML speaks,
by the category of ours that shows them.
"""

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from types import MappingProxyType

from ...errors import AuthoringError, InputError, Mistake
from ...model import Hand, Level
from .aliases import ALIASES, read_aliases
from .checking import names_twice
from .clips import clip
from .definitions import definition
from .gesture import Clip, Definition
from .language import mistake_in, read_gestures
from .statements import GestureFile, Located

SUFFIX = ".gesture"
LAST_RESORT = "BEAT"
"""Gesture Engine §5: requests that no prototype matches are shown by a generic beat."""


@dataclass(frozen=True, slots=True)
class Library:
    """Definitions in the order of their files, by category, and the aliases of categories."""

    definitions: tuple[Definition, ...]
    by_category: Mapping[str, tuple[Definition, ...]]
    aliases: Mapping[str, str]

    @classmethod
    def load(cls, folder: Path) -> "Library":
        """Everything under `folder`; raises AuthoringError with every mistake in all of it."""
        definitions = read_definitions(gesture_files([folder]))
        library = cls.of(definitions)
        path = folder / ALIASES
        return cls.of(definitions, read_aliases(path, library.categories)) if path.is_file() else library

    @classmethod
    def of(cls, definitions: Iterable[Definition], aliases: Mapping[str, str] = MappingProxyType({})) -> "Library":
        """The library of these definitions."""
        listed = tuple(definitions)
        found: dict[str, list[Definition]] = defaultdict(list)
        for one in listed:
            for category in one.categories:
                found[category].append(one)
        by_category = {category: tuple(found[category]) for category in sorted(found)}
        return cls(listed, MappingProxyType(by_category), MappingProxyType(dict(aliases)))

    @property
    def categories(self) -> tuple[str, ...]:
        """The lexemes that have a gesture, in alphabetical order."""
        return tuple(self.by_category)

    def clips(self, category: str, level: Level, hand: Hand) -> tuple[Clip, ...]:
        """Every way to show `category` at `level` with `hand`, in the order of the files; none when there is none.

        Definitions for as many hands as are asked for come alone. Where there are none, both hands make a one-handed
        gesture each, as mirror images, or one hand makes the leading hand's part of one for both. A definition for the
        left hand, or the right, is for that hand only.
        """
        fit = [one for one in self.by_category.get(category, ()) if level in one.levels]
        either, both = [one for one in fit if one.hand is None], [one for one in fit if one.hand is Hand.BOTH]
        same = both if hand is Hand.BOTH else [one for one in fit if one.hand in {None, hand}]
        otherwise = either if hand is Hand.BOTH else both
        return tuple(clip(one, level, hand, category) for one in same or otherwise)

    def definition(self, name: str) -> Definition:
        """The definition of that name; raises InputError `unknown_name`."""
        named = {one.name: one for one in self.definitions}
        if name not in named:
            close = get_close_matches(name, named, n=3)
            hint = f"; did you mean {' or '.join(close)}?" if close else "; see gestures list"
            raise InputError("unknown_name", f"no gesture is called {name!r}{hint}", field="name")
        return named[name]

    def nearest(self, lexeme: str) -> str | None:
        """The category that shows `lexeme` of whatever BML: its own, in whatever case and with whatever between its
        words, that of which it is an alias, or a beat. None when the library has no beat either."""
        spelt = re.sub(r"[^A-Z0-9]+", "_", lexeme.upper()).strip("_")
        for category in (lexeme, spelt, self.aliases.get(spelt), LAST_RESORT):
            if category in self.by_category:
                return category
        return None


def gesture_files(paths: Iterable[Path]) -> tuple[Path, ...]:
    """The gesture files among these and in these folders, in the order of their names within a folder."""
    inside = (sorted(path.rglob(f"*{SUFFIX}")) if path.is_dir() else [path] for path in paths)
    return tuple(file for files in inside for file in files if file.suffix == SUFFIX)


def read_definitions(paths: Sequence[Path]) -> tuple[Definition, ...]:
    """The definitions in these files; raises AuthoringError with every mistake, by file and line."""
    definitions: list[Definition] = []
    files: list[GestureFile] = []
    mistakes: list[Mistake] = []
    for path in paths:
        file, found = read_gestures(path)
        wrong: list[Located] = []
        read = [definition(tree, path, wrong) for tree in file.gestures]
        definitions += [one for one in read if one is not None]
        mistakes += [*found, *(mistake_in(file, one) for one in wrong)]
        files.append(file)
    mistakes += names_twice(files)
    if mistakes:
        order = {path: number for number, path in enumerate(paths)}
        raise AuthoringError(tuple(sorted(mistakes, key=lambda one: (order[one.path], one.line, one.column))))
    return tuple(definitions)
