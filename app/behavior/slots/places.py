"""Keeps things of a line in their places: contrasted things lie on opposite sides, and a thing that was named before is
where it was."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from ...model import Function, Token
from ...model.slots import Side
from .findings import Finding
from .patterns import find
from .table import Pattern, SlotTable

LOCUS = "locus"
"""The class of functions that give what is contrasted a place in gesture space (paper §3.3)."""

PLACE = ("side", "distance", "elevation_deg")
MOST_APART = 2
"""How many words may lie between a thing and the words that say where it is."""

_SIDES = (Side.LEFT, Side.RIGHT)


def contrasted(
    table: SlotTable, tokens: Sequence[Token], functions: Iterable[Function], found: Sequence[Finding]
) -> tuple[Finding, ...]:
    """The findings, with opposite sides for what is contrasted and has none of its own: by the authors' pairs, else by
    functions of class `locus`."""
    sides = [each for each in found if each.slot == "side"]
    for placed in (*_paired(table, tokens, sides), *_loci(functions)):
        if not any(placed.overlap(each.first, each.last) > 0 for each in sides):
            sides.append(placed)
    others = (each for each in found if each.slot != "side")
    return tuple(sorted((*others, *sides), key=lambda each: (each.first, each.last, each.slot)))


def _paired(table: SlotTable, tokens: Sequence[Token], sides: Sequence[Finding]) -> Iterator[Finding]:
    """The sides of pairs: the second opposite to what the words say of the first, else left and right."""
    for pair in table.pairs:
        one = _first(table, pair.one, tokens, 0)
        other = None if one is None else _first(table, pair.other, tokens, one[0] + 1)
        if one is None or other is None:
            continue
        words = [(tokens[first].word, tokens[last].word) for first, last in (one, other)]
        words[0] = words[0][0], min(words[0][1], words[1][0] - 1)
        said = next((each.value for each in sides if each.overlap(*words[0]) > 0), Side.LEFT)
        opposite = Side.LEFT if said == Side.RIGHT else Side.RIGHT
        yield Finding("side", Side.LEFT if opposite is Side.RIGHT else Side.RIGHT, *words[0])
        yield Finding("side", opposite, *words[1])


def _first(
    table: SlotTable, patterns: Iterable[Pattern], tokens: Sequence[Token], start: int
) -> tuple[int, int] | None:
    """The tokens of the first match of any of the patterns from `start` on."""
    matches = (next(find(each, tokens, table.numbers, start), None) for each in patterns)
    return min(((each.first, each.last) for each in matches if each), default=None)


def _loci(functions: Iterable[Function]) -> Iterator[Finding]:
    loci = sorted({(each.first, each.last, each.subtype) for each in functions if each.class_name == LOCUS})
    for one, other in pairwise(each for each in loci if each[2] in _SIDES):
        if one[2] != other[2]:
            yield from (Finding("side", Side(subtype), first, last) for first, last, subtype in (one, other))


def placed(found: Sequence[Finding], tokens: Sequence[Token]) -> tuple[Finding, ...]:
    """The findings, with the place of each thing that was named before on its later mentions; what is said to be
    elsewhere is another thing of that name (`wall_2`)."""
    kept = [each for each in found if each.slot != "referent"]
    known: dict[str, list[tuple[str, dict[str, Finding]]]] = {}
    for mention in (each for each in found if each.slot == "referent"):
        own = _place(mention, kept, tokens)
        things = known.setdefault(str(mention.value), [])
        name, place = _thing(str(mention.value), things, own)
        kept.append(replace(mention, value=name))
        kept += (replace(each, first=mention.first, last=mention.last) for each in place.values())
    return tuple(sorted(kept, key=lambda each: (each.first, each.last, each.slot)))


def _thing(
    name: str, things: list[tuple[str, dict[str, Finding]]], own: dict[str, Finding]
) -> tuple[str, dict[str, Finding]]:
    """The thing of this name that is where the mention has it, the last named first; it is new if there is none."""
    for known, place in reversed(things):
        if all(place.get(slot, each).value == each.value for slot, each in own.items()):
            place.update(own)
            return known, place
    things.append((name if not things else f"{name}_{len(things) + 1}", dict(own)))
    return things[-1]


def _place(mention: Finding, found: Iterable[Finding], tokens: Sequence[Token]) -> dict[str, Finding]:
    """What is said of the place of a mention, by words of it or close after it in the same clause."""
    stops = {token.word for token in tokens if token.part_of_speech == "PUNCT"}
    near: dict[str, Finding] = {}
    for each in found:
        joined = each.overlap(mention.first, mention.last) > 0 or (
            0 < each.first - mention.last <= MOST_APART + 1 and stops.isdisjoint(range(mention.last, each.first))
        )
        if each.slot in PLACE and joined:
            near.setdefault(each.slot, each)
    return near


def addressed(tokens: Sequence[Token], listeners: Iterable[str]) -> Iterator[Finding]:
    """Which listener is spoken to: each that is named, and the last named one wherever "you" follows."""
    names = {name.lower(): name for name in listeners}
    last: str | None = None
    for token in tokens:
        word = token.text.lower()
        last = names.get(word, last)
        if last is not None and (word in names or token.lemma.lower() in ("you", "your", "yours")):
            yield Finding("listener", last, token.word, token.word)
