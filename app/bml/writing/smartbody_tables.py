"""What SmartBody's shipped characters have, gestures, action units and visemes, and our names for it, from
`lexicon/smartbody.yaml`.

SmartBody plays a gesture only if its character's gesture map has an entry with exactly this type, mode and style, and a
viseme only if the face has a shape of that name.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Annotated

from pydantic import Field

from ...authored_folders import lexicon_folder
from ...errors import AuthoringError, Mistake
from ...model import Hand
from ...model.formats import VisemeNames
from ...model.tables import OPENINGS, SILENCE
from ...yaml_files import Entry, Source

FILE = "smartbody.yaml"


class SmartBodyMouthShape(Entry):
    """A mouth shape of the face, and the share of it that corresponds to ours."""

    name: Annotated[str, Field(min_length=1)]
    share: Annotated[float, Field(gt=0, le=1)] = 1.0


class UnitShown(Entry):
    """The action unit that is shown for another, and the share of its amount."""

    unit: Annotated[int, Field(ge=1)]
    share: Annotated[float, Field(gt=0, le=1)] = 1.0


Styles = Annotated[list[str], Field(min_length=1)]


class SmartBodyFile(Entry):
    """The file's schema; its comments explain the keys."""

    gesture_map: dict[str, Annotated[dict[Hand, Styles], Field(min_length=1)]]
    lexemes: dict[str, str]
    action_units: dict[int, UnitShown]
    visemes: dict[VisemeNames, dict[str, SmartBodyMouthShape]]


@dataclass(frozen=True, slots=True)
class GestureName:
    """The attributes that select a gesture; `hand` and `style` are None if no entry of the map has them."""

    type: str
    hand: Hand | None = None
    style: str | None = None


@dataclass(frozen=True, slots=True)
class SmartBodyTables:
    """The gesture map as hands and styles of every type, the types of our lexemes, the units that are shown for those
    that the face lacks, and mouth shapes."""

    gesture_map: Mapping[str, Mapping[Hand, frozenset[str]]]
    types: Mapping[str, str]
    units_shown: Mapping[int, UnitShown]
    visemes: Mapping[VisemeNames, Mapping[str, SmartBodyMouthShape]]

    @classmethod
    def load(cls, path: Path) -> "SmartBodyTables":
        """The tables of a file. Raises AuthoringError with every mistake."""
        source = Source(path)
        written = source.validated(SmartBodyFile)
        mistakes = tuple(_mistakes(source, written))
        if mistakes:
            raise AuthoringError(mistakes)
        return cls(
            gesture_map={
                name: {hand: frozenset(styles) for hand, styles in hands.items()}
                for name, hands in written.gesture_map.items()
            },
            types={lexeme: name for name, lexemes in written.lexemes.items() for lexeme in lexemes.split()},
            units_shown=MappingProxyType(written.action_units),
            visemes={names: MappingProxyType(shapes) for names, shapes in written.visemes.items()},
        )

    def unit_shown(self, unit: int) -> UnitShown:
        """The action unit of the face that shows this one: itself, or the nearest that it has."""
        return self.units_shown.get(unit, UnitShown(unit=unit))

    def knows(self, lexeme: str | None) -> bool:
        """Whether this is a lexeme of ours or a type of the map."""
        return lexeme in self.types or lexeme in self.gesture_map

    def gesture(self, lexeme: str, hand: Hand | None, style: str | None) -> GestureName:
        """The nearest gesture in the map: always of the lexeme's type, with hand and style if there is such an
        entry."""
        name = self.types.get(lexeme, lexeme)
        if name not in self.gesture_map:
            return GestureName(name, hand)
        hands = self.gesture_map[name]
        if hand not in hands:
            hand = None
        styles = hands[hand] if hand else frozenset().union(*hands.values())
        return GestureName(name, hand, style if style in styles else None)


@cache
def shipped_tables() -> SmartBodyTables:
    """The tables in the package."""
    return SmartBodyTables.load(lexicon_folder() / FILE)


def _mistakes(source: Source, written: SmartBodyFile) -> Iterator[Mistake]:
    for name in written.lexemes.keys() - written.gesture_map.keys():
        yield source.mistake(("lexemes", name), f"the map has no type {name}")
    lexemes = [lexeme for listed in written.lexemes.values() for lexeme in listed.split()]
    for lexeme in {one for one in lexemes if lexemes.count(one) > 1 or one in written.gesture_map}:
        yield source.mistake(("lexemes",), f"{lexeme} has more than one type")
    for unit, shown in written.action_units.items():
        if shown.unit in written.action_units:
            yield source.mistake(("action_units", str(unit)), f"the face lacks unit {shown.unit} too")
    for names in VisemeNames:
        shapes = written.visemes.get(names, {})
        if shapes.keys() != OPENINGS.keys() - {SILENCE}:
            known = ", ".join(sorted(OPENINGS.keys() - {SILENCE}))
            yield source.mistake(("visemes", names.value), f"the shapes of {names} are {known}, each once")
