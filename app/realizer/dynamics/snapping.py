"""Shortens strokes: the same path in less time, around the same emphasis, so that the accent is the fastest movement.

People's strokes peak at 1.1 to 1.4 m/s, about as fast as their retractions, and their durations vary; clips have only
a few durations. A stroke is shortened until its mean speed reaches a random value that depends on the level of
agitation, and never lengthened; gestures that are slow by their meaning stay slow. What limits the speed of the usual
stroke limits that of a bigger or quicker voice at as much more, and of a smaller or slower one at as much less, so that
strokes that are all at a limit still differ. The time of the emphasis is unchanged; preparation and hold fill the
remaining time. Gestures are still planned with the speed of the clip, so that movements between gestures do not become
faster.
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations, pairwise, starmap
from typing import TypeAlias

import numpy as np

from ...model import FloatArray, Hand, Level
from ..arms.wrist_paths import amplitude, distance_m, stroke_end_m, stroke_start_m, wrist_m
from ..body.movement_style import Strokes
from ..gestures.brief_strokes import in_less_time
from ..gestures.gesture import ArmKey, Clip, Markers, TrackForm
from ..gestures.gesture_plan import PlacedGesture
from ..gestures.gesture_space import sector_m

_LEAST_TENSION = 0.75
_LEAST_S = 0.17
_WOUND_UP_M_S = 1.1
"""The fastest mean speed of a stroke that is wound up, in its own time."""
_USUAL_POWER = 0.5
"""The maximum power of a quickened stroke, which stops abruptly anyway; more would make its middle even faster."""
_SLOWEST = 2.0
"""The largest factor by which a stroke may be slowed."""
_LEAST_SIZE = 0.5
"""Gestures with a smaller requested size are not wound up."""
_SHORTEST_M = 0.05
"""Strokes of the wrist or the fingers alone are neither wound up nor quickened."""
_COMES_BACK = 1.75
"""How much longer than its widest distance the way of a hand is that comes back: twice, to and fro; thrice, round."""
_NOT_NEARER_M: FloatArray = np.array([0.02, -0.02, 0.19])
"""The limits of drawing back one hand: it stays on its side, above the hips and in front of the body."""
_NOT_NEARER_BOTH_M: FloatArray = np.array([0.11, -0.02, 0.19])
"""The limits of drawing back both hands, which also stay apart by a hand's length."""
_HEAD_M, _BODY_M, _CAREFUL = 0.52, 0.18, 0.9
"""Strokes that end above the shoulders or before the body are hardly quickened."""
_HIGHEST_M = 0.36
"""Gestures whose strokes end above this, at the head, are not lifted."""

_LEVELS = (Level.LOW, Level.MEDIUM, Level.HIGH)

_Way: TypeAlias = Sequence[FloatArray]
"""The positions of a wrist at the keys of a stroke."""


def snapped(placed: PlacedGesture, strokes: Strokes, rng: np.random.Generator) -> PlacedGesture:
    """The gesture with its stroke at a random speed, or of the requested duration; unchanged if it is already as
    fast."""
    clip = placed.clip
    level = _LEVELS.index(clip.level)
    if placed.request.asked.stroke_s is not None:
        return _lasting(placed, placed.request.asked.stroke_s, strokes.fastest_m_s[level])
    pace, quickness = float(rng.uniform(*strokes.variety)), _quickness(placed)
    most_m_s = min(quickness * strokes.fastest_m_s[level], max(strokes.fastest_m_s))
    wanted_m_s = min(most_m_s, pace * quickness * strokes.speed_m_s[level])
    ways = _stroke_ways(placed)
    way_m, fastest_m_s = _stroke_m(clip, ways)
    if not wanted_m_s or clip.category in strokes.unhurried or way_m < _SHORTEST_M or _to_and_fro(clip, ways):
        return placed
    stroke_s = clip.markers.stroke_end - clip.markers.stroke_start
    shortest_s = _shortest_s(strokes, pace, placed.request.manner.speed)
    share = max(way_m / stroke_s / wanted_m_s, shortest_s / stroke_s, fastest_m_s / most_m_s)
    share = max(share, _CAREFUL) if _is_close(placed) else share
    return placed if share >= 1 else replace(placed, clip=quickened(clip, share))


def _lasting(placed: PlacedGesture, length_s: float, most_m_s: float) -> PlacedGesture:
    """The gesture with a stroke of this duration, within the range of plausible speeds of a stroke."""
    stroke_s = placed.clip.markers.stroke_end - placed.clip.markers.stroke_start
    fastest = max(_stroke_m(placed.clip, _stroke_ways(placed))[1] / most_m_s, min(1.0, _LEAST_S / stroke_s))
    return replace(placed, clip=quickened(placed.clip, min(max(length_s / stroke_s, fastest), _SLOWEST)))


def _to_and_fro(clip: Clip, ways: Sequence[_Way]) -> bool:
    """Whether an arm waves, circles or comes back during the stroke, which is lost in less time."""
    if clip.waves or any(track.form is TrackForm.CIRCLING for track in clip.tracks):
        return True
    return any(_length_m(way) > _COMES_BACK * max(starmap(distance_m, combinations(way, 2))) for way in ways)


def _is_close(placed: PlacedGesture) -> bool:
    """Whether a stroke ends at the head or at the body, which the hand should not hit."""
    ends_m = (stroke_end_m(placed, side) for side in placed.arms)
    return any(end_m[1] > _HEAD_M or end_m[2] < _BODY_M for end_m in ends_m)


def _quickness(placed: PlacedGesture) -> float:
    """The factor by which the voice makes a stroke faster than usual: by its tension, and by the amplitude and speed
    that the gesture has from it already, so that differences between voices remain visible after quickening."""
    manner = placed.request.manner
    return float(np.sqrt(max(manner.tension, _LEAST_TENSION))) * manner.amplitude * manner.speed


def _shortest_s(strokes: Strokes, pace: float, speed: float) -> float:
    """The shortest stroke at a pace: a slow voice has even its short strokes slow, a fast one may hurry them, though
    not beyond what a hand can."""
    return max(_LEAST_S / min(speed, 1.0), strokes.shortest_s / (pace * speed))


def _stroke_m(clip: Clip, ways: Sequence[_Way]) -> tuple[float, float]:
    """The longest path of a hand in the stroke, along straight lines between its keys, and its highest speed between
    two keys."""
    lengths_s = [to_s - from_s for from_s, to_s in pairwise(_stroke_times_s(clip))]
    longest_m = fastest_m_s = 0.0
    for way in ways:
        steps_m = list(starmap(distance_m, pairwise(way)))
        speeds = (step_m / length_s for step_m, length_s in zip(steps_m, lengths_s, strict=True))
        longest_m, fastest_m_s = max(longest_m, sum(steps_m)), max(fastest_m_s, *speeds)
    return longest_m, fastest_m_s


def _stroke_times_s(clip: Clip) -> list[float]:
    """The times of a stroke's keys."""
    markers = clip.markers
    inner_s = {key.time_s for key in clip.keys if markers.stroke_start < key.time_s < markers.stroke_end}
    return [markers.stroke_start, *sorted(inner_s), markers.stroke_end]


def _stroke_ways(placed: PlacedGesture) -> list[_Way]:
    """Where the wrist of each arm is at these times."""
    times_s = _stroke_times_s(placed.clip)
    return [[wrist_m(placed, side, time_s) for time_s in times_s] for side in placed.arms]


def _length_m(way: _Way) -> float:
    return sum(starmap(distance_m, pairwise(way)))


def lifted(placed: PlacedGesture, strokes: Strokes) -> PlacedGesture:
    """The gesture raised or lowered a little by its level of agitation, unless it is at the head or shows a place."""
    clip, up_m = placed.clip, strokes.lift_m[_LEVELS.index(placed.clip.level)]
    ends_m = [stroke_end_m(placed, side) for side in placed.arms]
    if not up_m or placed.placed_by_words or max(float(end_m[1]) for end_m in ends_m) > _HIGHEST_M:
        return placed
    keys = tuple(key.of(_raised(key.left, up_m), _raised(key.right, up_m)) for key in clip.keys)
    return replace(placed, clip=replace(clip, keys=keys))


def _raised(arm: ArmKey | None, up_m: float) -> ArmKey | None:
    if arm is None or arm.place is None:
        return arm
    out, up, away = arm.place.offset_m
    return arm.at(arm.place.offset_by((out, up + up_m, away)))


def wound_up(placed: PlacedGesture, strokes: Strokes) -> PlacedGesture:
    """The gesture with short strokes begun farther from their ends, unless it shows a place or is at the head: a hand
    draws back before it strikes, the farther the bigger the voice makes the gesture."""
    clip, manner, level = placed.clip, placed.request.manner, _LEVELS.index(placed.clip.level)
    farther = 1 + _more(manner.amplitude) * (strokes.wind_up[level] - 1)
    if farther <= 1 or not _is_free(placed) or amplitude(placed) < _LEAST_SIZE:
        return placed
    ends_m = {side: stroke_end_m(placed, side) for side in placed.arms}
    way_m = max(distance_m(stroke_start_m(placed, side), end_m) for side, end_m in ends_m.items())
    stroke_s = clip.markers.stroke_end - clip.markers.stroke_start
    longest_m = manner.amplitude * min(strokes.longest_m[level], _WOUND_UP_M_S * stroke_s * manner.speed)
    factor = min(farther, longest_m / max(way_m, _SHORTEST_M))
    high = max(end_m[1] for end_m in ends_m.values()) > _HIGHEST_M
    if high or factor <= 1 or way_m < _SHORTEST_M or _to_and_fro(clip, _stroke_ways(placed)):
        return placed
    begins = clip.markers.ready, clip.markers.stroke_start
    nearest_m = _NOT_NEARER_M if len(ends_m) == 1 else _NOT_NEARER_BOTH_M
    back = partial(_drawn_back, factor=factor, size=amplitude(placed), nearest_m=nearest_m)
    keys = tuple(
        key.of(back(key.left, ends_m.get(Hand.LEFT)), back(key.right, ends_m.get(Hand.RIGHT)))
        if begins[0] <= key.time_s <= begins[1]
        else key
        for key in clip.keys
    )
    return replace(placed, clip=replace(clip, keys=keys))


def _is_free(placed: PlacedGesture) -> bool:
    """Whether it is open from where a stroke comes: also one that points, if nobody says at what."""
    pointing_ahead = placed.clip.aimed and placed.aim_m is None
    return not placed.placed_by_words or (pointing_ahead and not placed.request.slots and not placed.request.way)


def _more(amplitude: float) -> float:
    """How much more than usual a hand draws back in a gesture of that size: not at all at half the usual one."""
    return max(2 * amplitude - 1, 0.0)


def _drawn_back(
    arm: ArmKey | None, end_m: FloatArray | None, *, factor: float, size: float, nearest_m: FloatArray
) -> ArmKey | None:
    if arm is None or arm.place is None or end_m is None:
        return arm
    start_m = sector_m(arm.place, size)
    farther_m = end_m + factor * (start_m - end_m)
    farther_m = np.maximum(farther_m, np.minimum(start_m, nearest_m))
    moved = (farther_m - start_m) / size
    out, up, away = (float(part + more) for part, more in zip(arm.place.offset_m, moved, strict=True))
    return arm.at(arm.place.offset_by((out, up, away)))


def quickened(clip: Clip, share: float) -> Clip:
    """The clip with its stroke shortened to that share; the phases before and after keep their durations."""
    markers = clip.markers
    times_s = (in_less_time(markers, getattr(markers, name), share) for name in Markers.__slots__)
    keys = tuple(key.at(in_less_time(markers, key.time_s, share)) for key in clip.keys)
    smooth = replace(clip.expressivity, power=min(clip.expressivity.power, _USUAL_POWER))
    return replace(clip, markers=Markers(*times_s), keys=keys, expressivity=smooth)
