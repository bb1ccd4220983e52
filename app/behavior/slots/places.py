"""Keeps things of a line in their places: contrasted things lie on opposite sides, and a thing that was named before is
where it was."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise, takewhile

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
    """Which listener is spoken to: each that is named; the one called by name on all words of the clause; and the last
    named one wherever "you" follows."""
    names = {name.lower(): name for name in listeners}
    last: str | None = None
    for clause in _clauses(tokens, frozenset(names)):
        named = [token for token in clause if token.text.lower() in names]
        called = [token for token in named if _is_called(token, tokens)]
        yield from (Finding("listener", names[each.text.lower()], each.word, each.word) for each in named)
        last = names[(called or named)[-1].text.lower()] if named else last
        if called:
            yield Finding("listener", last, clause[0].word, clause[-1].word)
        elif last is not None:
            you = (token.word for token in clause if token.lemma.lower() in _YOU)
            yield from (Finding("listener", last, word, word) for word in you)


_YOU = frozenset({"you", "your", "yours"})
_ENDS = frozenset(".?!;:…")


def _clauses(tokens: Sequence[Token], names: frozenset[str]) -> Iterator[Sequence[Token]]:
    """The sentences, each ended too by a name after which another is called within it."""
    clause: list[Token] = []
    for number, token in enumerate(tokens):
        clause.append(token)
        ended = token.text[-1:] in _ENDS or number == len(tokens) - 1
        if ended or (token.text == "," and _is_last_called(clause, tokens[number + 1 :], names)):
            yield clause
            clause = []
    if clause:
        yield clause


def _is_last_called(clause: Sequence[Token], following: Sequence[Token], names: frozenset[str]) -> bool:
    """Whether a clause that began with other words ends with a name, and a further name is called in its sentence."""
    if len(clause) < 3 or clause[-2].text.lower() not in names:
        return False
    sentence = takewhile(lambda token: token.text[-1:] not in _ENDS, following)
    return any(token.text.lower() in names for token in sentence)


def _is_called(name: Token, tokens: Sequence[Token]) -> bool:
    """Whether a name stands by itself, between marks or the ends of the line, as in calling somebody."""
    before, after = tokens[: name.index][-1:], tokens[name.index + 1 :][:1]
    return all(each.part_of_speech == "PUNCT" for each in (*before, *after))
