"""How well an attempt suits what is already kept (the paper's heuristics, §3.4). It prefers whole alternatives to
parts, usual length to shortened, gestures that join the one before to gestures that just miss it; it avoids repetition
and switching hands."""

from collections.abc import Iterator

from ...model import Alternative, Behavior, Channel
from ..timing.conflicts import Kept
from ..timing.time_index import KeptByTime
from .attempts import Attempt, Line
from .hands import HAND_SWITCH_S, stroke_s, switches

REPEAT_S = 5.0
"""A gesture repeated within this time, from stroke to stroke, is less suitable."""

HEAD_REPEAT_S = 2.0
"""A head movement, face or gaze repeated within this time is less suitable."""

IN_PART = 0.4
SHORTENED = 0.7
REPEATED = 0.5
HAND_SWITCHED = 0.3
MISSING_THE_UNIT = 0.5
UNIT_TOO_LONG = 0.3
HANDS_IDLE = 0.05
"""Factors on suitability, see `suitability`."""

NEAR_UNIT_S = 1.0
"""A gesture that begins this soon after the end of another could have joined it."""


def suitability(attempt: Attempt, line: Line) -> float:
    """How well an alternative suits what is kept, in [0, 1]; 0 if no part of it fits."""
    suits = 1.0 if not attempt.lost else IN_PART * len(attempt.own) / (len(attempt.own) + len(attempt.lost))
    for each in attempt.own:
        behavior = each.candidate.behavior
        if each.shortened:
            suits *= SHORTENED
        if behavior.kind is Channel.GESTURE:
            suits *= _unity(behavior, attempt.kept, line.character.strokes_per_unit)
            suits *= _habit(behavior, attempt.kept)
        elif any(_repeats(behavior, other.behavior) for other in _begun_around(behavior, attempt.kept)):
            suits *= REPEATED
    with_gesture = any(each.candidate.behavior.kind is Channel.GESTURE for each in attempt.own)
    return suits if with_gesture or not has_idle_hands(attempt.kept, line) else suits * HANDS_IDLE


def most_suitable(alternative: Alternative, line: Line, *, hands_idle: bool) -> float:
    """The upper bound of an alternative's suitability, given whether the character usually gestures more
    (`hands_idle`)."""
    entries = line.character.entries
    by_hand = any(entries[movement.name].channel is Channel.GESTURE for movement in alternative.movements)
    return HANDS_IDLE if hands_idle and not by_hand else 1.0


def has_idle_hands(kept: KeptByTime, line: Line) -> bool:
    """Whether the character usually gestures more than is kept."""
    return kept.gestures < line.most_gestures


def _begun_around(behavior: Behavior, kept: KeptByTime) -> Kept:
    return kept.near(behavior.sync.start - HEAD_REPEAT_S, behavior.sync.start + HEAD_REPEAT_S)


def _repeats(behavior: Behavior, other: Behavior) -> bool:
    if other.id == behavior.id or form(other) != form(behavior):
        return False
    return abs(other.sync.start - behavior.sync.start) < HEAD_REPEAT_S


def _habit(gesture: Behavior, kept: KeptByTime) -> float:
    """How well a gesture suits the others around it (paper §3.4: against inordinate switching of hands and repeating a
    gesture). The worth of planned gestures takes account of what was shown just before, and switching is refused."""
    if gesture.moment:
        return 1.0
    at_s = stroke_s(gesture)
    others = (each for each in kept.gestures_near(at_s - REPEAT_S, at_s + REPEAT_S) if each.id != gesture.id)
    apart = [(other, abs(at_s - stroke_s(other))) for other in others]
    repeated = any(other.lexeme == gesture.lexeme and apart_s < REPEAT_S for other, apart_s in apart)
    switched = any(switches(gesture, other) and apart_s < HAND_SWITCH_S for other, apart_s in apart)
    return (REPEATED if repeated else 1.0) * (HAND_SWITCHED if switched else 1.0)


def _unity(gesture: Behavior, kept: KeptByTime, strokes_per_unit: int) -> float:
    """How well a gesture suits its neighbours: single or joined, in units no longer than the character's."""
    strokes = 1 + sum(1 for _ in _joined_before(gesture, kept)) + sum(1 for _ in _joined_after(gesture, kept))
    if strokes > strokes_per_unit:
        return UNIT_TOO_LONG
    others = list(kept.gestures_near(gesture.sync.start - NEAR_UNIT_S, gesture.sync.end + NEAR_UNIT_S))
    near = any(0 < gesture.sync.start - other.sync.end < NEAR_UNIT_S for other in others) or any(
        0 < other.sync.start - gesture.sync.end < NEAR_UNIT_S for other in others
    )
    return MISSING_THE_UNIT if near and strokes == 1 else 1.0


def _joined_before(gesture: Behavior, kept: KeptByTime) -> Iterator[Behavior]:
    at_s = gesture.sync.start
    for other in kept.gestures_near(at_s - NEAR_UNIT_S, at_s + NEAR_UNIT_S):
        if other.sync.end == at_s:
            yield other
            yield from _joined_before(other, kept)


def _joined_after(gesture: Behavior, kept: KeptByTime) -> Iterator[Behavior]:
    at_s = gesture.sync.end
    for other in kept.gestures_near(at_s - NEAR_UNIT_S, at_s + NEAR_UNIT_S):
        if other.sync.start == at_s:
            yield other
            yield from _joined_after(other, kept)


def form(behavior: Behavior) -> tuple[Channel, str]:
    return behavior.kind, behavior.lexeme
