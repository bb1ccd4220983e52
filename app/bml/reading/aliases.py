"""Others' names of head movements and faces, by the nearest lexeme of ours, from `lexicon/bml_aliases.yaml`.

Gestures are named to the realizer as the document has them, whose library knows their aliases.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import MappingProxyType

from ...authored_folders import lexicon_folder
from ...errors import AuthoringError, Mistake
from ...yaml_files import Entry, Source

FILE = "bml_aliases.yaml"

_NOT_IN_NAMES = re.compile(r"[^A-Z0-9]+")


class AliasFile(Entry):
    """The file's schema: for each lexeme of ours, the other names."""

    heads: dict[str, list[str]]
    faces: dict[str, list[str]]


@dataclass(frozen=True, slots=True)
class LexemeAliases:
    """Our lexeme by every name that has one, its own among them."""

    heads: Mapping[str, str]
    faces: Mapping[str, str]

    @classmethod
    def load(cls, path: Path) -> "LexemeAliases":
        """The aliases of a file. Raises AuthoringError for names that stand twice."""
        source = Source(path)
        written = source.validated(AliasFile)
        parts = {"heads": written.heads, "faces": written.faces}
        mistakes = tuple(each for part, names in parts.items() for each in _mistakes(source, part, names))
        if mistakes:
            raise AuthoringError(mistakes)
        return cls(*(MappingProxyType(_by_name(names)) for names in parts.values()))

    def head(self, lexeme: str) -> str:
        """The lexeme of a head movement, unchanged where nothing is known of it."""
        return self.heads.get(_spelt(lexeme), lexeme)

    def face(self, lexeme: str) -> str:
        """The lexeme of a face, unchanged where nothing is known of it."""
        return self.faces.get(_spelt(lexeme), lexeme)


@cache
def shipped_aliases() -> LexemeAliases:
    """The aliases in the package."""
    return LexemeAliases.load(lexicon_folder() / FILE)


def _by_name(names: Mapping[str, list[str]]) -> dict[str, str]:
    return {name: lexeme for lexeme, others in names.items() for name in (lexeme, *others)}


def _mistakes(source: Source, part: str, names: Mapping[str, list[str]]) -> Iterator[Mistake]:
    seen = set(names)
    for lexeme, others in names.items():
        for position, name in enumerate(others):
            where = (part, lexeme, position)
            if _spelt(name) != name:
                yield source.mistake(where, f"{name!r}: names are written in capitals, words joined by one underscore")
            elif name in seen:
                yield source.mistake(where, f"{name} is listed already")
            seen.add(name)


def _spelt(name: str) -> str:
    return _NOT_IN_NAMES.sub("_", name.upper()).strip("_")
