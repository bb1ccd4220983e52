"""Computes the times of a behaviour's phases (paper §3.8, Table 3).

They depend on two times of the speech: `at_s`, when the stressed vowel of its word begins, and `until_s`, when the last
of its words ends. A share `alignment` of the stroke is before `at_s`; with alignment 1 it ends there, since a gesture's
stroke comes at or before the stressed syllable and never after (McNeill 1992). The hold lasts until `until_s`. A
behaviour without a stroke reaches its peak at `at_s`. Times are seconds, whole milliseconds.

How big, fast and tense a gesture is comes from the voice at its stroke, once that is timed (`with_manner`).
"""

from dataclasses import dataclass, replace
from math import inf

from ...model import Behavior, Channel, SyncPoints, Utterance
from ..table.behavior_table import PhaseDuration, Timing

_SLACK_S = 1e-6
"""Tolerance for rounding."""


@dataclass(frozen=True, slots=True)
class Window:
    """The time available to a behaviour, seconds."""

    from_s: float = 0.0
    to_s: float = inf


@dataclass(frozen=True, slots=True)
class TimingBasis:
    """The basis of a behaviour's timing; only `stroked` behaviours have the inner sync points."""

    timing: Timing
    at_s: float
    until_s: float
    stroked: bool


def placed(basis: TimingBasis, window: Window) -> SyncPoints | None:
    """The phases at their usual length, as far as the window permits; None if even the shortest do not fit.

    Before the vowel the preparation is shortened first, then the stroke; after it the retraction, then the hold.
    """
    timing, at_s = basis.timing, basis.at_s
    before = _taken(at_s - window.from_s, timing.preparation, timing.stroke, timing.alignment)
    if before is None:
        return None
    preparation_s, stroke_s = before
    stroke_start_s = at_s - timing.alignment * stroke_s
    stroke_end_s = stroke_start_s + stroke_s
    hold_s = min(max(basis.until_s - stroke_end_s, timing.hold.shortest_s), timing.hold.usual_s)
    after = _taken(window.to_s - stroke_end_s, timing.retraction, PhaseDuration(timing.hold.shortest_s, hold_s))
    if after is None:
        return None
    retraction_s, hold_s = after
    start_s, relax_s = stroke_start_s - preparation_s, stroke_end_s + hold_s
    ends = {"start": _rounded(start_s), "relax": _rounded(relax_s), "end": _rounded(relax_s + retraction_s)}
    ready_s = _rounded(stroke_start_s)
    if not basis.stroked:
        return SyncPoints(ready=ready_s, **ends)
    return SyncPoints(
        ready=ready_s,
        stroke_start=ready_s,
        stroke=_rounded(stroke_start_s + timing.emphasis * stroke_s),
        stroke_end=_rounded(stroke_end_s),
        **ends,
    )


def underway(basis: TimingBasis) -> TimingBasis:
    """The basis for a gesture whose word comes too soon to prepare for it: its hand is raised already when the
    performance begins. If there is no time for the stroke either, it ends as soon after the vowel as it can."""
    raised = replace(basis.timing, preparation=PhaseDuration(0.0, 0.0))
    return replace(basis, timing=raised, at_s=max(basis.at_s, raised.alignment * raised.stroke.shortest_s))


def soonest(basis: TimingBasis) -> TimingBasis:
    """The basis for a start as soon as possible after the performance begins, a little late for its word."""
    timing = basis.timing
    earliest_s = timing.preparation.shortest_s + timing.alignment * timing.stroke.shortest_s
    return replace(basis, at_s=max(basis.at_s, earliest_s))


def _taken(room_s: float, outer: PhaseDuration, inner: PhaseDuration, part: float = 1.0) -> tuple[float, float] | None:
    """The durations of `outer` and `inner` if `outer` and `part` of `inner` share `room_s`; the outer is shortened
    first."""
    outer_s = min(outer.usual_s, room_s - part * inner.usual_s)
    if outer_s >= outer.shortest_s - _SLACK_S:
        return outer_s, inner.usual_s
    inner_s = (room_s - outer.shortest_s) / part if part else 0.0
    if inner_s < inner.shortest_s - _SLACK_S:
        return None
    return outer.shortest_s, inner_s


def _rounded(time_s: float) -> float:
    """Whole milliseconds, and no negative zero."""
    return round(time_s, 3) + 0.0


def with_manner(behaviors: tuple[Behavior, ...], utterance: Utterance) -> tuple[Behavior, ...]:
    """The behaviours, those gestures with a manner that are stroked while words are spoken whose manner is known."""
    if not utterance.manners:
        return behaviors
    return tuple(_in_manner(each, utterance) if each.kind is Channel.GESTURE else each for each in behaviors)


def _in_manner(gesture: Behavior, utterance: Utterance) -> Behavior:
    """The gesture with the manner of the word that is nearest to its stroke."""
    stroke_s = next(
        time_s for time_s in (gesture.sync.stroke, gesture.sync.stroke_end, gesture.sync.start) if time_s is not None
    )
    timed = [(word.index, word.interval) for word in utterance.words if word.interval]
    if not timed:
        return gesture
    nearest, _ = min(timed, key=lambda each: max(each[1].start_s - stroke_s, stroke_s - each[1].end_s, 0.0))
    return replace(gesture, manner=utterance.manners[nearest])
