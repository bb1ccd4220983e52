"""Stroke expansion (Gesture Engine §5.1): on further emphases of the phrase the hand keeps its shape and the arm
repeats part of the stroke, smaller each time, ending on the emphasis.

It applies to gestures whose expressivity includes repetition and to beats, until the next gesture or the phrase's end.
A hold that would last too long becomes repetitions too, of a size that shows, or the hand retracts where the body is to
be still: a person's hand does not stand in the air (`Holds`).
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain, count
from math import inf

import numpy as np

from ...model import Hand
from ...model.limits import shortest_transition_s
from ..body.motion import Decision
from ..body.movement_style import Holds
from ..gestures.gesture_plan import ArmGesture, GestureRequest, PlacedGesture, Repeat
from .transitions import TransitionContext, stroke_speed_m_s, transition_s, way_m

AMPLITUDES = (0.6, 0.4, 0.25)
"""Of the first, second and third repetition, as shares of the stroke; of later ones each is `FADING` of the one before
("with diminishing amplitudes")."""
FADING = 0.65
SHORTEST_SPACING_S = 0.35
"""Between the ends of two strokes: enough to move back and forth at a human speed."""
LONGEST_SPACING_S = 1.5
"""A later emphasis is not part of the gesture any more."""
LONGEST_BEAT_S = 0.7
"""How long a repetition in a hold takes at most."""
SEEN_S = 0.35
"""For which a size or a place is shown before a beat."""
AFTER_S = 0.1
"""The hold after the last repetition."""
WAVE_S = 0.4
"""In which a waving hand swings to one side and back."""
MOST_WAVES = 3
LEAST_SWINGS, AWAY_S = 1.5, 1.0
"""How often a wave swings to and fro at least, and what of the time before the emphasis of the same hand's next gesture
is for the way to it and its stroke."""
BEATS = frozenset({"BEAT", "BEAT_HIGH", "RHYTHM", "PRECISION", "CHOP", "PALM_BEAT"})
BEAT_REPEATS = 2


def with_repeats(placed: PlacedGesture, emphases_s: Iterable[float], until_s: float) -> PlacedGesture:
    """The gesture with its stroke repeated on the emphases before `until_s`, and its relax time after the last one."""
    asked_s = placed.request.after_strokes_s
    if asked_s is not None:
        repeats = tuple(_asked(placed, asked_s, until_s))
    elif placed.clip.waves:
        repeats = tuple(_waved(placed, until_s))
    else:
        repeats = tuple(_repeats(placed, sorted(emphases_s), until_s))
    if not repeats:
        return placed
    return replace(placed, repeats=repeats, relax_s=max(placed.relax_s, min(repeats[-1].end_s + AFTER_S, until_s)))


def _waved(placed: PlacedGesture, until_s: float) -> Iterator[Repeat]:
    """Further swings of a waving hand, one after the other, as long as it would be held, and one at least if there is
    time."""
    swing_s = WAVE_S / placed.clip.expressivity.tempo
    for number in range(MOST_WAVES):
        end_s = placed.stroke_end_s + (number + 1) * swing_s
        if end_s > (until_s if number == 0 else min(until_s, placed.relax_s + swing_s)):
            return
        yield Repeat(end_s - swing_s, end_s, 1.0, swings=True)


def beside_a_wave(
    request: GestureRequest, before: Sequence[PlacedGesture]
) -> tuple[GestureRequest, tuple[Decision, ...]]:
    """The request for the other hand where its own is still waving by then, and the decision about it: "Hello! Come on
    in." What shows a place, or is led to sectors, stays with its hand."""
    wave = before[-1] if before else None
    fixed = request.hand is Hand.BOTH or request.slots or request.way or request.target
    if fixed or wave is None or not wave.clip.waves or wave.arms != (request.hand,):
        return request, ()
    waved_s = wave.stroke_start_s + LEAST_SWINGS * WAVE_S / wave.clip.expressivity.tempo
    if request.stroke_s - AWAY_S >= waved_s:
        return request, ()
    other = Hand.LEFT if request.hand is Hand.RIGHT else Hand.RIGHT
    reason = f"made with the {other} hand, as the {request.hand} one is still waving"
    return replace(request, hand=other), (Decision(request.behavior, "replaced", reason),)


def most_repeats(placed: PlacedGesture) -> int:
    """The maximum number of repetitions: none at a `repetition` of 0, three at 1."""
    wanted = round(len(AMPLITUDES) * placed.clip.expressivity.repetition)
    return max(wanted, BEAT_REPEATS) if placed.clip.category in BEATS else wanted


def _repeats(placed: PlacedGesture, emphases_s: list[float], until_s: float) -> Iterator[Repeat]:
    amplitudes = iter(AMPLITUDES[: most_repeats(placed)])
    stroke_s = placed.clip.markers.stroke_end - placed.clip.markers.stroke_start
    last_s = placed.stroke_end_s + (SEEN_S if placed.request.slots else 0.0)
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


def _asked(placed: PlacedGesture, after_strokes_s: Iterable[float], until_s: float) -> Iterator[Repeat]:
    """The strokes that the schedule asks for, so far as the arm is free."""
    stroke_s = placed.clip.markers.stroke_end - placed.clip.markers.stroke_start
    amplitudes = chain(AMPLITUDES, (AMPLITUDES[-1] * FADING**number for number in count(1)))
    last_s = placed.stroke_end_s
    for after_s in after_strokes_s:
        end_s = placed.stroke_end_s + after_s
        if end_s > until_s:
            return
        if end_s - last_s >= SHORTEST_SPACING_S:
            begin_s = end_s - min(end_s - last_s, max(stroke_s, SHORTEST_SPACING_S))
            yield Repeat(begin_s, end_s, next(amplitudes))
            last_s = end_s


def told_repeats(arm: ArmGesture) -> Iterator[str]:
    """The strokes that an arm repeats, and those that are asked for and are not, in words."""
    gesture = arm.placed
    if gesture.repeats:
        what = "swings on, until" if gesture.repeats[0].swings else "strokes again on the emphases at"
        yield f"{what} {_times(repeat.end_s for repeat in gesture.repeats)} s"
    asked_s = [gesture.stroke_end_s + after_s for after_s in gesture.request.after_strokes_s or ()]
    made_s = {round(repeat.end_s, 3) for repeat in gesture.repeats}
    missing_s = [end_s for end_s in asked_s if round(end_s, 3) not in made_s]
    if late_s := [end_s for end_s in missing_s if end_s > arm.markers.relax]:
        yield f"not at {_times(late_s)} s, as asked: the arm has left by then"
    if early_s := [end_s for end_s in missing_s if end_s <= arm.markers.relax]:
        yield f"not at {_times(early_s)} s, as asked: that is too soon after the stroke before"


def _times(times_s: Iterable[float]) -> str:
    return ", ".join(f"{time_s:.2f}" for time_s in times_s)


def repeats_until_s(placed: PlacedGesture, later: Iterable[PlacedGesture], setting: TransitionContext) -> float:
    """How long a gesture may be repeated: until the end of its phrase, unless its strokes are asked for or it waves, or
    until an arm leaves for its next gesture."""
    whole = placed.request.after_strokes_s is not None or placed.clip.waves
    phrase = None if whole else setting.phrase_of(placed.request.stroke_s)
    ends_s = [inf if phrase is None else setting.phrases[phrase].end_s]
    following = list(later)
    for side in placed.arms:
        second = next((each for each in following if side in each.arms), None)
        if second is not None:
            ends_s.append(second.stroke_start_s - _way_on_s(placed, second, side))
    return min(ends_s)


def _way_on_s(placed: PlacedGesture, second: PlacedGesture, side: Hand) -> float:
    """The time in which an arm goes on to its next gesture: in no haste, but after a wave, which is nothing without its
    swings."""
    if placed.clip.waves:
        return shortest_transition_s(way_m(placed, second, side), stroke_speed_m_s(second))
    return transition_s(placed, second, side)


def let_go_in_time(placed: PlacedGesture, holds: Holds) -> PlacedGesture:
    """The gesture with its hold cut to the longest one."""
    return replace(placed, relax_s=min(placed.relax_s, _held_from_s(placed) + holds.longest_s))


def is_held_long(arm: ArmGesture, holds: Holds) -> bool:
    """Whether a hold lasts longer than the longest that stays one."""
    return arm.markers.relax - _held_from_s(arm.placed) > holds.longest_s


def with_beats(
    arm: ArmGesture, emphases_s: Iterable[float], holds: Holds, rng: np.random.Generator, *, lag_s: float
) -> ArmGesture:
    """The gesture with repetitions in its hold: on the emphases in it, or else at even steps; an arm
    that does not lead makes them `lag_s` later."""
    start_s = _held_from_s(arm.placed) + (SEEN_S if arm.placed.request.slots else 0.0)
    relax_s = arm.markers.relax
    step_s, (least_m, most_m) = max(SHORTEST_SPACING_S, float(rng.uniform(*holds.spacing_s))), holds.way_m
    ends_s = list(_spaced((each + lag_s for each in sorted(emphases_s)), start_s, relax_s - AFTER_S))
    ends_s = ends_s or list(_spaced(np.arange(start_s + step_s, relax_s, step_s), start_s, relax_s - AFTER_S))
    ways_m = arm.placed.share * np.linspace(most_m, least_m, len(ends_s))
    last_s, beats = start_s, []
    for end_s, back_m in zip(ends_s, ways_m, strict=True):
        beats.append(Repeat(max(last_s, end_s - LONGEST_BEAT_S), float(end_s), 0.0, float(back_m)))
        last_s = end_s
    return replace(arm, beats=tuple(beats))


def _held_from_s(placed: PlacedGesture) -> float:
    return max([placed.stroke_end_s, *(repeat.end_s for repeat in placed.repeats)])


def _spaced(times_s: Iterable[float], after_s: float, until_s: float) -> Iterator[float]:
    for time_s in times_s:
        if after_s + SHORTEST_SPACING_S <= time_s <= until_s:
            yield float(time_s)
            after_s = time_s
