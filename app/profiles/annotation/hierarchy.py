"""Phases into phrases, phrases into units (NGS §3.1): what does not lie in its whole, and what contradicts itself.

A phrase has a preparation at most first, then holds and strokes, of which there is one at least, or one independent
hold instead. A retraction is the unit's and its last phase; it may lie in the last phrase or after it.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import TypeVar

from ...model import Interval
from .in_time import InTime
from .model import GesturePhrase, Phase, PhaseKind, Unit
from .spans import (
    TOUCHING_S,
    Checking,
    affiliate_of,
    checked_times,
    hand_of,
    lexeme_of,
    path_of,
    phase_kind,
    position_of,
    rest_of,
    tag_of,
    unknown_attributes,
)
from .tracks import Track, TrackSpan

Marked = TypeVar("Marked", Phase, GesturePhrase)


def units_of(phases: Track, phrases: Track, units: Track, checking: Checking) -> tuple[Unit, ...]:
    """The units with their phrases and phases."""
    every = tuple(_phases(phases, checking))
    moving = _in_time([phase for phase in every if phase.kind is not PhaseKind.RETRACTION])
    back = _in_time([phase for phase in every if phase.kind is PhaseKind.RETRACTION])
    wholes = list(checked_times(units, checking))
    _check_hands(phrases, checking)
    made = (_phrase(span, moving, checking) for span in checked_times(phrases, checking))
    parts = _in_time([phrase for phrase in made if phrase is not None])
    for phase in _outside(moving.things, [part.interval for part in parts.things]):
        checking.wrong("phases", phase.interval.start_s, f"the {phase.kind} lies in no phrase that can be used")
    for part in _outside(parts.things, map(_interval, wholes)):
        checking.wrong("phrases", part.interval.start_s, f"{part.lexeme} lies in no unit")
    for retraction in _outside(back.things, map(_interval, wholes)):
        checking.wrong("phases", retraction.interval.start_s, "the retraction lies in no unit")
    return tuple(_unit(whole, parts, back, checking) for whole in wholes)


def _in_time(things: Iterable[Marked]) -> InTime[Marked]:
    return InTime.of(things, lambda thing: (thing.interval.start_s, thing.interval.end_s))


def _within(parts: InTime[Marked], whole: TrackSpan) -> tuple[Marked, ...]:
    return parts.within(whole.start_s - TOUCHING_S, whole.end_s + TOUCHING_S)


def _outside(parts: Iterable[Marked], wholes: Iterable[Interval]) -> Iterator[Marked]:
    """The parts that lie in no whole."""
    held = InTime.of(wholes, lambda whole: (whole.start_s - TOUCHING_S, whole.end_s + TOUCHING_S))
    yield from (part for part in parts if not held.any_holds(part.interval.start_s, part.interval.end_s))


def _phases(track: Track, checking: Checking) -> Iterator[Phase]:
    for span in checked_times(track, checking):
        kind = phase_kind(span, checking)
        if kind is not None:
            yield Phase(kind, _interval(span))


def _check_hands(phrases: Track, checking: Checking) -> None:
    """Hands that are said nowhere are one mistake, of the track."""
    checking.hands_said = not phrases.spans or any(span.attributes.get("hand") for span in phrases.spans)
    if not checking.hands_said:
        told = "no phrase says its hand: give each the attribute hand, or a track phrases.hand, with RH, LH or 2H"
        checking.wrong("phrases", None, told)


def _phrase(span: TrackSpan, phases: InTime[Phase], checking: Checking) -> GesturePhrase | None:
    own = _within(phases, span)
    message = _contradiction(own)
    if message:
        checking.wrong("phrases", span.start_s, f"{span.label}: {message}")
        return None
    unknown_attributes(span, checking)
    return GesturePhrase(
        interval=_interval(span),
        lexeme=lexeme_of(span, checking),
        hand=hand_of(span, checking),
        phases=own,
        path=path_of(span, checking),
        start=position_of(span, "from", checking),
        end=position_of(span, "to", checking),
        affiliate=affiliate_of(span, checking),
        tag=tag_of(span, checking),
    )


def _contradiction(phases: Sequence[Phase]) -> str | None:
    """What is wrong with the phases of a phrase."""
    kinds = [phase.kind for phase in phases]
    if PhaseKind.PREPARATION in kinds[1:]:
        return "a preparation is the first phase of its phrase"
    holds = kinds.count(PhaseKind.INDEPENDENT_HOLD)
    if PhaseKind.STROKE not in kinds and not holds:
        return "it has neither a stroke nor an independent hold"
    if holds and (PhaseKind.STROKE in kinds or holds > 1):
        return "an independent hold takes the place of all strokes"
    return None


def _unit(whole: TrackSpan, phrases: InTime[GesturePhrase], retractions: InTime[Phase], checking: Checking) -> Unit:
    own = _within(phrases, whole)
    if not own:
        checking.wrong("units", whole.start_s, "no gesture lies in this unit")
    back = [each.interval for each in _within(retractions, whole)]
    if len(back) > 1:
        checking.wrong("units", whole.start_s, f"{len(back)} retractions; a unit ends in one")
    elif back and own and back[0].start_s < own[-1].main_s.end_s - TOUCHING_S:
        checking.wrong("units", whole.start_s, "the retraction comes before the last stroke ends")
    return Unit(_interval(whole), own, back[0] if back else None, rest_of(whole, checking))


def _interval(span: TrackSpan) -> Interval:
    return Interval(span.start_s, span.end_s)
