"""What the words of a line say of size and place: every slot with its words."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from ...model import Token
from ...model.slots import Distance
from .patterns import PatternMatch, find, number_of, possible, vocabulary_of
from .table import LENGTH, NOUN, Pattern, SlotPhrase, SlotTable

Value = str | int | float
NEAR_M = 3.0
"""The length up to which a distance is near: a person's reach with a step."""

MOST_FINGERS = 10


@dataclass(frozen=True, slots=True)
class Finding:
    """Words `first` to `last` give `slot` a value; None: they only look as if they did. `length_m` is a length that was
    said in units."""

    slot: str
    value: Value | None
    first: int
    last: int
    length_m: float | None = None

    def overlap(self, first: int, last: int) -> int:
        """The number of words shared with words `first` to `last`."""
        return min(self.last, last) - max(self.first, first) + 1


def findings(table: SlotTable, tokens: Sequence[Token]) -> tuple[Finding, ...]:
    """What the words say, in order; where words of one slot overlap the longest win, then what stands first in the
    file."""
    found: dict[str, list[Finding]] = {}
    vocabulary = vocabulary_of(tokens)
    for phrase in table.phrases:
        if phrase.line and not _is_anywhere(table, phrase.line, tokens, vocabulary):
            continue
        found.setdefault(phrase.slot, []).extend(_said(table, phrase, tokens, vocabulary))
    kept = (each for ranked in found.values() for each in _longest(ranked) if each.value is not None)
    return tuple(sorted(kept, key=lambda each: (each.first, each.last, each.slot)))


def _is_anywhere(
    table: SlotTable, patterns: Iterable[Pattern], tokens: Sequence[Token], vocabulary: frozenset[str]
) -> bool:
    """Whether one of the patterns is in the line."""
    return any(possible(each, vocabulary) and any(find(each, tokens, table.numbers)) for each in patterns)


def _said(
    table: SlotTable, phrase: SlotPhrase, tokens: Sequence[Token], vocabulary: frozenset[str]
) -> Iterator[Finding]:
    for pattern in phrase.words:
        if not possible(pattern, vocabulary):
            continue
        for match in find(pattern, tokens, table.numbers):
            found = _finding(table, phrase, match, tokens)
            if found is not None:
                yield found


def _finding(table: SlotTable, phrase: SlotPhrase, match: PatternMatch, tokens: Sequence[Token]) -> Finding | None:
    """The finding of a match; None if it has a length or number that cannot be shown."""
    value: Value | None = phrase.value
    length_m: float | None = None
    if value == LENGTH:
        length_m = _length_m(table, match, tokens)
        if length_m is None:
            return None
        value = _class_of(table, phrase.slot, length_m)
    elif value == NOUN:
        value = None if match.named is None else tokens[match.named].lemma.lower()
    elif value is not None and phrase.slot == "count":
        value = _count(table, str(value), match, tokens)
    elif value is not None and phrase.slot == "elevation_deg":
        value = float(value)
    first, last = tokens[match.first].word, tokens[match.last].word
    return Finding(phrase.slot, value, first, last, length_m)


def _count(table: SlotTable, value: str, match: PatternMatch, tokens: Sequence[Token]) -> int | None:
    """The number if fingers can show it."""
    if value != "number":
        return int(value)
    said = None if match.number is None else number_of(tokens[match.number], table.numbers)
    return int(said) if said is not None and 1 <= said <= MOST_FINGERS else None


def _length_m(table: SlotTable, match: PatternMatch, tokens: Sequence[Token]) -> float | None:
    """The length in a match: its number times the first unit after it."""
    if match.number is None:
        return None
    number = number_of(tokens[match.number], table.numbers)
    units = (table.units_m.get(token.text.lower()) for token in tokens[match.number + 1 : match.last + 1])
    unit_m = next((each for each in units if each is not None), None)
    return None if number is None or unit_m is None else round(number * unit_m, 3)


def _class_of(table: SlotTable, slot: str, length_m: float) -> str:
    if slot == "height":
        return table.height(length_m)
    if slot == "size":
        return table.size(length_m)
    return Distance.NEAR if length_m <= NEAR_M else Distance.FAR


def _longest(ranked: Iterable[Finding]) -> Iterator[Finding]:
    """Those that are left where the longest of overlapping ones win."""
    kept: list[Finding] = []
    for each in sorted(ranked, key=lambda found: found.first - found.last):
        if not any(each.overlap(other.first, other.last) > 0 for other in kept):
            kept.append(each)
            yield each
