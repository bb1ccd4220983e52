"""Stroke expansion (Gesture Engine §5.1): on further emphases of the phrase the hand keeps its shape and the arm
repeats part of the stroke, smaller each time, ending on the emphasis.

It applies to gestures whose expressivity includes repetition and to beats, until the next gesture or the phrase's end.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import inf

from ..gestures.gesture_plan import PlacedGesture, Repeat
from .transitions import TransitionContext, transition_s

AMPLITUDES = (0.6, 0.4, 0.25)
"""Of the first, second and third repetition, as shares of the stroke."""
SHORTEST_SPACING_S = 0.35
"""Between the ends of two strokes: enough to move back and forth at a human speed."""
LONGEST_SPACING_S = 1.5
"""A later emphasis is not part of the gesture any more."""
AFTER_S = 0.1
"""The hold after the last repetition."""
BEATS = frozenset({"BEAT", "BEAT_HIGH", "RHYTHM", "PRECISION", "CHOP", "PALM_BEAT"})
BEAT_REPEATS = 2


def with_repeats(placed: PlacedGesture, emphases_s: Iterable[float], until_s: float) -> PlacedGesture:
    """The gesture with its stroke repeated on the emphases before `until_s`, and its relax time after the last one."""
    repeats = tuple(_repeats(placed, sorted(emphases_s), until_s))
    if not repeats:
        return placed
    return replace(placed, repeats=repeats, relax_s=max(placed.relax_s, min(repeats[-1].end_s + AFTER_S, until_s)))


def most_repeats(placed: PlacedGesture) -> int:
    """The maximum number of repetitions: none at a `repetition` of 0, three at 1."""
    wanted = round(len(AMPLITUDES) * placed.clip.expressivity.repetition)
    return max(wanted, BEAT_REPEATS) if placed.clip.category in BEATS else wanted


def _repeats(placed: PlacedGesture, emphases_s: list[float], until_s: float) -> Iterator[Repeat]:
    amplitudes = iter(AMPLITUDES[: most_repeats(placed)])
    stroke_s = placed.clip.markers.stroke_end - placed.clip.markers.stroke_start
    last_s = placed.stroke_end_s
    for emphasis_s in emphases_s:
        spacing_s = emphasis_s - last_s
        if spacing_s < SHORTEST_SPACING_S:
            continue
        if spacing_s > LONGEST_SPACING_S or emphasis_s > until_s:
            return
        amplitude = next(amplitudes, None)
        if amplitude is None:
            return
        yield Repeat(emphasis_s - min(spacing_s, max(stroke_s, SHORTEST_SPACING_S)), emphasis_s, amplitude)
        last_s = emphasis_s


def repeats_until_s(placed: PlacedGesture, later: Iterable[PlacedGesture], setting: TransitionContext) -> float:
    """How long a gesture may be repeated: until the end of its phrase, or until an arm leaves for its next gesture."""
    phrase = setting.phrase_of(placed.request.stroke_s)
    ends_s = [inf if phrase is None else setting.phrases[phrase].end_s]
    following = list(later)
    for side in placed.arms:
        second = next((each for each in following if side in each.arms), None)
        if second is not None:
            ends_s.append(second.stroke_start_s - transition_s(placed, second, side))
    return min(ends_s)
