"""Characters: overlays on the one behaviour table, so that what a character does not say stays as the table has it.

`lexicon/characters/NAME.yaml` gives the character NAME. Every mistake in the table and in all characters is reported
at once.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import chain
from pathlib import Path
from types import MappingProxyType
from typing import Literal, TypeVar

from pydantic import Field

from app.authored import Entry, Source, all_or_every_mistake
from app.bml.table import (
    BehaviorChange,
    BehaviorEntry,
    BehaviorTable,
    changed,
    did_you_mean,
    load_table,
    mistakes_of,
)
from app.errors import AuthoringError, InputError, Mistake
from app.model import Hand

Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class Character:
    """How one character moves: its own entries of the table, the hand it prefers, strokes a minute of speech."""

    name: str
    description: str
    handedness: Hand
    gestures_per_minute: float
    strokes_per_unit: int
    entries: Mapping[str, BehaviorEntry]


@dataclass(frozen=True, slots=True)
class Characters:
    """All characters by name, in alphabetical order."""

    by_name: Mapping[str, Character]
    behavior_names: frozenset[str]

    @classmethod
    def load(cls, lexicon: Path) -> "Characters":
        """The table and the characters of a lexicon folder. Raises AuthoringError with every mistake."""
        table = _attempt(partial(load_table, lexicon / "behaviors.yaml"))
        sheets = [_attempt(partial(_Sheet.read, path)) for path in sorted((lexicon / "characters").glob("*.yaml"))]
        if isinstance(table, AuthoringError):
            mistakes = (sheet.mistakes for sheet in sheets if isinstance(sheet, AuthoringError))
            raise AuthoringError(tuple(chain(table.mistakes, *mistakes)))
        characters = all_or_every_mistake(
            sheet if isinstance(sheet, AuthoringError) else _attempt(partial(sheet.overlaid, table)) for sheet in sheets
        )
        by_name = {character.name: character for character in characters}
        return cls(MappingProxyType(by_name), frozenset(table.lines))

    def named(self, name: str) -> Character:
        """The character of that name; raises InputError `unknown_character`."""
        if name not in self.by_name:
            raise InputError(
                "unknown_character",
                f"there is no character {name!r}{did_you_mean(name, self.by_name)}; "
                f"there are {', '.join(self.by_name) or 'none'}",
                field="character",
            )
        return self.by_name[name]


class _CharacterFile(Entry):
    description: str = Field(min_length=1)
    handedness: Literal["left", "right"]
    gestures_per_minute: float = Field(ge=0, le=60)
    strokes_per_unit: int = Field(default=3, ge=1, le=20)
    behaviors: dict[str, BehaviorChange] = Field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _Sheet:
    """A character's file, valid by itself."""

    source: Source
    file: _CharacterFile

    @classmethod
    def read(cls, path: Path) -> "_Sheet":
        if not _NAME.fullmatch(path.stem):
            raise AuthoringError(
                (Mistake(path, 1, 1, "a character's file is named in letters, digits and _, a letter first"),)
            )
        source = Source(path)
        return cls(source, source.validated(_CharacterFile))

    def overlaid(self, table: BehaviorTable) -> Character:
        """The character over `table`; raises AuthoringError for changes of what is not there or makes no sense."""
        mistakes = [self.source.mistake(("behaviors", *place), message) for *place, message in self._mistakes(table)]
        if mistakes:
            raise AuthoringError(tuple(mistakes))
        entries = {name: table.entry(name, self.file.behaviors.get(name)) for name in table.lines}
        return Character(
            name=self.source.path.stem,
            description=self.file.description,
            handedness=Hand(self.file.handedness),
            gestures_per_minute=self.file.gestures_per_minute,
            strokes_per_unit=self.file.strokes_per_unit,
            entries=MappingProxyType(entries),
        )

    def _mistakes(self, table: BehaviorTable) -> Iterator[tuple[str, ...]]:
        for name, change in self.file.behaviors.items():
            if name not in table.lines:
                yield name, f"the table has no behaviour {name!r}{did_you_mean(name, table.lines)}"
                continue
            for key, message in mistakes_of(changed(table.lines[name], change), table.timings):
                yield name, key, message


_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


def _attempt(load: Callable[[], Value]) -> Value | AuthoringError:
    try:
        return load()
    except AuthoringError as error:
        return error
