"""Phases into phrases, phrases into units (NGS §3.1): what does not lie in its whole, and what contradicts itself.

A phrase has a preparation at most first, then holds and strokes, of which there is one at least, or one independent
hold instead. A retraction is the unit's and its last phase; it may lie in the last phrase or after it.
"""

from collections.abc import Iterator, Sequence

from ...model import Interval
from .model import Phase, PhaseKind, Phrase, Unit
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
    unknown_attributes,
)
from .tracks import Span, Track


def units_of(phases: Track, phrases: Track, units: Track, checking: Checking) -> tuple[Unit, ...]:
    """The units with their phrases and phases."""
    made = tuple(_phases(phases, checking))
    retractions = [phase for phase in made if phase.kind is PhaseKind.RETRACTION]
    wholes = list(checked_times(units, checking))
    parts = [each for span in checked_times(phrases, checking) if (each := _phrase(span, made, checking)) is not None]
    _check_inside([phase for phase in made if phase not in retractions], [part.interval for part in parts], checking)
    for part in parts:
        if not any(_within(part.interval, _interval(whole)) for whole in wholes):
            checking.wrong("phrases", part.interval.start_s, f"{part.lexeme} lies in no unit")
    for retraction in retractions:
        if not any(_within(retraction.interval, _interval(whole)) for whole in wholes):
            checking.wrong("phases", retraction.interval.start_s, "the retraction lies in no unit")
    return tuple(_unit(whole, parts, retractions, checking) for whole in wholes)


def _phases(track: Track, checking: Checking) -> Iterator[Phase]:
    for span in checked_times(track, checking):
        kind = phase_kind(span, checking)
        if kind is not None:
            yield Phase(kind, _interval(span))


def _phrase(span: Span, phases: Sequence[Phase], checking: Checking) -> Phrase | None:
    own = tuple(phase for phase in phases if _within(phase.interval, _interval(span)))
    moving = tuple(phase for phase in own if phase.kind is not PhaseKind.RETRACTION)
    message = _contradiction(moving)
    if message:
        checking.wrong("phrases", span.start_s, f"{span.label}: {message}")
        return None
    unknown_attributes(span, checking)
    return Phrase(
        interval=_interval(span),
        lexeme=lexeme_of(span, checking),
        hand=hand_of(span, checking),
        phases=moving,
        path=path_of(span, checking),
        start=position_of(span, "from", checking),
        end=position_of(span, "to", checking),
        affiliate=affiliate_of(span, checking),
        tag=span.attributes.get("tag") or None,
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


def _unit(whole: Span, phrases: Sequence[Phrase], retractions: Sequence[Phase], checking: Checking) -> Unit:
    own = tuple(phrase for phrase in phrases if _within(phrase.interval, _interval(whole)))
    if not own:
        checking.wrong("units", whole.start_s, "no gesture lies in this unit")
    back = [each.interval for each in retractions if _within(each.interval, _interval(whole))]
    if len(back) > 1:
        checking.wrong("units", whole.start_s, f"{len(back)} retractions; a unit ends in one")
    elif back and own and back[0].start_s < own[-1].main_s.end_s - TOUCHING_S:
        checking.wrong("units", whole.start_s, "the retraction comes before the last stroke ends")
    return Unit(_interval(whole), own, back[0] if back else None, whole.label or None)


def _check_inside(phases: Sequence[Phase], wholes: Sequence[Interval], checking: Checking) -> None:
    for phase in phases:
        if not any(_within(phase.interval, whole) for whole in wholes):
            checking.wrong("phases", phase.interval.start_s, f"the {phase.kind} lies in no phrase that can be used")


def _within(part: Interval, whole: Interval) -> bool:
    return part.start_s >= whole.start_s - TOUCHING_S and part.end_s <= whole.end_s + TOUCHING_S


def _interval(span: Span) -> Interval:
    return Interval(span.start_s, span.end_s)
