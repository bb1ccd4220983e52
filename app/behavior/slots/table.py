"""Loads what words say of size and place: `lexicon/acting/slots.yaml`, with every mistake at its line and column."""

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, TypeVar

from pydantic import Field

from ...errors import AuthoringError, Mistake, did_you_mean
from ...model.slots import Distance, Height, Side, Size, Slots, Which
from ...yaml_files import Entry, Source
from .patterns import PatternElement, read_pattern

NOTHING = "none"
"""The value of words that look as if they said something and do not."""

LENGTH, NOUN = "length", "noun"
"""The values that the words themselves have: a length in units, the noun that names a thing."""

Pattern = tuple[PatternElement, ...]
_CLASSES = MappingProxyType({"height": Height, "size": Size, "side": Side, "distance": Distance, "which": Which})


@dataclass(frozen=True, slots=True)
class SlotPhrase:
    """Words that give a slot a value (None: none), if one of the patterns of `line` is anywhere in the line."""

    slot: str
    value: str | None
    words: tuple[Pattern, ...]
    line: tuple[Pattern, ...] = ()


@dataclass(frozen=True, slots=True)
class ContrastPair:
    """Words that put one thing against another: the first to the left, the second to the right."""

    one: tuple[Pattern, ...]
    other: tuple[Pattern, ...]


@dataclass(frozen=True, slots=True)
class SlotTable:
    """The file: what words say, which lengths the classes usually have; `shown` are the slots that each gesture lexeme
    can show."""

    phrases: tuple[SlotPhrase, ...]
    pairs: tuple[ContrastPair, ...]
    numbers: Mapping[str, float]
    units_m: Mapping[str, float]
    heights_m: Mapping[Height, float]
    sizes_m: Mapping[Size, float]
    shown: Mapping[str, frozenset[str]]

    @classmethod
    def load(cls, path: Path, shows: Mapping[str, Sequence[str]]) -> "SlotTable":
        """The table in a file; `shows` are the families as which each lexeme may be read. Raises AuthoringError with
        every mistake, among them families that do not exist."""
        source = Source(path)
        file = source.validated(_SlotsFile)
        mistakes = [
            *_mistakes(source, file),
            *_family_mistakes(source, file, {name for each in shows.values() for name in each}),
        ]
        if mistakes:
            raise AuthoringError(tuple(mistakes))
        sets = file.sets

        def read(patterns: Sequence[str]) -> tuple[Pattern, ...]:
            return tuple(read_pattern(each, sets) for each in patterns)

        return cls(
            phrases=tuple(_slot_phrases(file, read)),
            pairs=tuple(ContrastPair(read(each.one), read(each.other)) for each in file.contrasts),
            numbers=MappingProxyType({word: number for number, words in file.numbers.items() for word in words}),
            units_m=MappingProxyType({word: metres for metres, words in file.units_m.items() for word in words}),
            heights_m=MappingProxyType(file.heights_m),
            sizes_m=MappingProxyType(file.sizes_m),
            shown=MappingProxyType({lexeme: frozenset(_shown(file, families)) for lexeme, families in shows.items()}),
        )

    def height(self, length_m: float) -> Height:
        """The highest class that a length reaches."""
        return _reached(self.heights_m, length_m)

    def size(self, length_m: float) -> Size:
        """The biggest class that a length reaches."""
        return _reached(self.sizes_m, length_m)


_COUNTS = frozenset(map(str, range(1, 11)))
_DEGREES = re.compile(r"-?\d{1,2}", re.ASCII)

_Patterns = Annotated[tuple[str, ...], Field(min_length=1)]
_Words = Annotated[tuple[str, ...], Field(min_length=1)]
_Metres = Annotated[float, Field(gt=0, le=1e6)]


class _SlotLine(Entry):
    value: str = Field(alias="is")
    words: _Patterns
    line: _Patterns = ()


class _Pair(Entry):
    one: _Patterns
    other: _Patterns


class _SlotsFile(Entry):
    sets: dict[str, _Words]
    numbers: dict[float, _Words]
    units_m: dict[_Metres, _Words]
    heights_m: dict[Height, _Metres]
    sizes_m: dict[Size, _Metres]
    shown_by: dict[str, _Words]
    contrasts: tuple[_Pair, ...]
    slots: dict[str, tuple[_SlotLine, ...]]


def _slot_phrases(file: _SlotsFile, read: Callable[[Sequence[str]], tuple[Pattern, ...]]) -> Iterator[SlotPhrase]:
    for slot, lines in file.slots.items():
        for line in lines:
            yield SlotPhrase(slot, None if line.value == NOTHING else line.value, read(line.words), read(line.line))


def _shown(file: _SlotsFile, families: Sequence[str]) -> Iterator[str]:
    """The slots that a lexeme of these families can show."""
    for slot, shown_by in file.shown_by.items():
        if not set(families).isdisjoint(shown_by):
            yield slot


def _mistakes(source: Source, file: _SlotsFile) -> Iterator[Mistake]:
    for kind in ("slots", "shown_by"):
        for slot in getattr(file, kind):
            if slot not in Slots.__slots__:
                yield source.mistake((kind, slot), f"no slot is called {slot!r}{did_you_mean(slot, Slots.__slots__)}")
    for slot, place, line in ((slot, *each) for slot, lines in file.slots.items() for each in enumerate(lines)):
        message = _value_mistake(slot, line.value)
        if message:
            yield source.mistake(("slots", slot, place, "is"), message)
        for part in ("words", "line"):
            yield from _pattern_mistakes(source, file, ("slots", slot, place, part), getattr(line, part))
    for place, pair in enumerate(file.contrasts):
        for part in ("one", "other"):
            yield from _pattern_mistakes(source, file, ("contrasts", place, part), getattr(pair, part))
    yield from _missing_lengths(source, file)


def _missing_lengths(source: Source, file: _SlotsFile) -> Iterator[Mistake]:
    for name, missing in (("heights_m", set(Height) - set(file.heights_m)), ("sizes_m", set(Size) - set(file.sizes_m))):
        if missing:
            yield source.mistake((name,), f"{', '.join(sorted(missing))} is missing")


def _pattern_mistakes(
    source: Source, file: _SlotsFile, where: tuple[str | int, ...], patterns: Sequence[str]
) -> Iterator[Mistake]:
    for place, pattern in enumerate(patterns):
        try:
            read_pattern(pattern, file.sets)
        except ValueError as error:
            yield source.mistake((*where, place), str(error))


def _family_mistakes(source: Source, file: _SlotsFile, families: Collection[str]) -> Iterator[Mistake]:
    for slot, shown in file.shown_by.items():
        for place, family in enumerate(shown):
            if family not in families:
                message = f"{family!r} is not a family of gestures{did_you_mean(family, families)}"
                yield source.mistake(("shown_by", slot, place), message)


def _value_mistake(slot: str, value: str) -> str | None:
    """What is wrong with the value of a slot; None if nothing is."""
    allowed: set[str] = {NOTHING, *map(str, _CLASSES.get(slot, ()))}
    allowed |= {LENGTH} if slot in ("height", "size", "distance") else {NOUN} if slot == "referent" else set()
    if value in allowed or (slot == "count" and (value == "number" or value in _COUNTS)):
        return None
    if slot == "elevation_deg" and _DEGREES.fullmatch(value) and abs(int(value)) <= 90:
        return None
    return f"{value!r} is not a value of {slot}{did_you_mean(value, allowed)}"


_Class = TypeVar("_Class", Height, Size)


def _reached(lengths_m: Mapping[_Class, float], length_m: float) -> _Class:
    """The class with the greatest length that is reached; the least if none is."""
    rising = sorted(lengths_m, key=lambda each: lengths_m[each])
    return next((each for each in reversed(rising) if lengths_m[each] <= length_m), rising[0])
