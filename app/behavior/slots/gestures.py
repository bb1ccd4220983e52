"""Gives each gesture the slots that its words fill, of those that it can show."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from ...model import Analysis, Behavior, Channel, Function, Moment, Utterance
from ...model.slots import Distance, Height, Side, Size, Slots, Which
from ..reading.strokes import NEAR
from .findings import Finding, findings
from .places import addressed, contrasted, placed
from .table import SlotTable

PLACES = MappingProxyType({"PLACE_LEFT": Side.LEFT, "PLACE_RIGHT": Side.RIGHT})
"""Gestures that show one side of a contrast: the choice has decided which."""

SIDED = MappingProxyType({
    lexeme: (side, lexeme.replace(side.upper(), other.upper()))
    for side, other in ((Side.LEFT, Side.RIGHT), (Side.RIGHT, Side.LEFT))
    for lexeme in (side.upper(), f"POINT_{side.upper()}", f"PALM_{side.upper()}")
})  # fmt: skip
"""Gestures to one side: that side, and the gesture to the other."""


def slots_said(
    table: SlotTable, utterance: Utterance, functions: Iterable[Function] = (), listeners: Sequence[str] = ()
) -> tuple[Finding, ...]:
    """All that the words of a line say of size and place."""
    tokens = utterance.parse.tokens
    found = contrasted(table, tokens, [each for each in functions if each.kept], findings(table, tokens))
    return (*placed(found, tokens), *addressed(tokens, listeners))


def slots_of(table: SlotTable, said: Iterable[Finding], first: int, last: int, stroke: int | None = None) -> Slots:
    """The slots of words `first` to `last`: of several values of a slot the one with most of these words, then the one
    nearest to the `stroke` (by default `last`)."""
    stroke = last if stroke is None else stroke
    best: dict[str, tuple[tuple[int, int, int], Finding]] = {}
    for each in said:
        shared = each.overlap(first, last)
        if shared > 0:
            apart = max(each.first - stroke, stroke - each.last, 0)
            rank = (-apart, shared, -each.first)
            best[each.slot] = max(best.get(each.slot, (rank, each)), (rank, each), key=lambda ranked: ranked[0])
    return _slots(table, {slot: found for slot, (_rank, found) in best.items()})


def with_slots(
    behaviors: Sequence[Behavior],
    analysis: Analysis,
    moments: Iterable[Moment],
    table: SlotTable,
    listeners: Sequence[str] = (),
) -> tuple[Behavior, ...]:
    """The behaviours, each gesture that is kept with the slots of the words of its moment, else of its own words, of
    those that it can show; where these say nothing, of the words near its stroke that are no other moment's."""
    said = slots_said(table, analysis.utterance, analysis.functions, listeners)
    by_id = {moment.id: moment for moment in moments if moment.channel is Channel.GESTURE}

    def filled(gesture: Behavior) -> Behavior:
        moment = by_id.get(gesture.moment or "")
        words = (moment.first, moment.last, moment.stroke) if moment else (gesture.first, gesture.last, None)
        shown = table.shown.get(gesture.lexeme, frozenset())
        can_show = [each for each in said if each.slot in shown]
        slots = slots_of(table, can_show, *words)
        if moment and not slots:
            slots = slots_of(table, can_show, *_about(moment, by_id.values()), moment.stroke)
        slots = replace(slots, side=PLACES.get(gesture.lexeme, slots.side))
        asked = moment is not None and moment.note is not None
        lexeme = gesture.lexeme if asked else _to_the_side(gesture.lexeme, slots.side)
        return replace(gesture, lexeme=lexeme, slots=slots) if slots else gesture

    return tuple(filled(each) if each.kept and each.kind is Channel.GESTURE else each for each in behaviors)


def _about(moment: Moment, moments: Iterable[Moment]) -> tuple[int, int]:
    """The first and the last word near a stroke that belong to no other moment."""
    others = [each for each in moments if each.id != moment.id]
    after = max((each.last + 1 for each in others if each.last < moment.first), default=0)
    before = min((each.first - 1 for each in others if each.first > moment.last), default=moment.stroke + NEAR)
    return max(after, moment.stroke - NEAR), min(before, moment.stroke + NEAR)


def _to_the_side(lexeme: str, side: Side | None) -> str:
    """The gesture to the side that the words name: what is on your left is on the right of who speaks."""
    own, other = SIDED.get(lexeme, (None, lexeme))
    return other if side in (Side.LEFT, Side.RIGHT) and side is not own else lexeme


def _slots(table: SlotTable, best: Mapping[str, Finding]) -> Slots:
    height = Height(value) if (value := _value(best, "height")) else None
    size = Size(value) if (value := _value(best, "size")) else None
    return Slots(
        height=height,
        height_m=None if height is None else best["height"].length_m or table.heights_m[height],
        size=size,
        size_m=None if size is None else best["size"].length_m or table.sizes_m[size],
        count=int(best["count"].value or 0) if "count" in best else None,
        side=Side(value) if (value := _value(best, "side")) else None,
        distance=Distance(value) if (value := _value(best, "distance")) else None,
        elevation_deg=float(best["elevation_deg"].value or 0.0) if "elevation_deg" in best else None,
        which=Which(value) if (value := _value(best, "which")) else None,
        referent=_value(best, "referent"),
        listener=_value(best, "listener"),
    )


def _value(best: Mapping[str, Finding], slot: str) -> str | None:
    return str(best[slot].value) if slot in best else None
