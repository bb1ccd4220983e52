"""Approximate wrist trajectory of a clip for planning: linear interpolation between the keys that place the wrist.

Conventions: metres as in `understudy.realizer.gestures.gesture_space`, seen from the arm's own side, so that positions
of one arm can be compared. The realized wrist may differ by some centimetres (joint limits, collisions).
"""

from bisect import bisect_right
from math import dist

import numpy as np

from ...model import FloatArray, Hand
from ..body.skeleton import HIPS_HEIGHT_M
from ..gestures.gesture import ArmKey, Clip, ClipKey, Depth, HeightSector, SectorPlace, Sideways
from ..gestures.gesture_plan import PlacedGesture
from ..gestures.gesture_space import SHOULDERS_ABOVE_HIPS_M, place_m, sector_m
from .rest_poses import RESTS

_UNPLACED = SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE)
"""The place assumed for a hand that is given by joint angles."""

_SHOULDER_M: FloatArray = np.array([0.17, SHOULDERS_ABOVE_HIPS_M, 0.0])
_SHOULDER_M.setflags(write=False)


def arm_key(key: ClipKey, side: Hand) -> ArmKey | None:
    """What a clip key defines for one arm; None if the arm takes no part."""
    return key.left if side is Hand.LEFT else key.right


def amplitude(placed: PlacedGesture) -> float:
    """The size of a gesture: its level's expressivity times the size that the schedule requests."""
    return placed.clip.expressivity.amplitude * placed.size


def wrist_m(placed: PlacedGesture, side: Hand, time_s: float) -> FloatArray:
    """The wrist's position (3,) at `time_s` of the clip; for an aimed gesture, on the line from the shoulder to its
    target; of a hand that follows, on the way there from hanging."""
    at_m = _wrist_m(placed.clip, side, time_s, amplitude(placed))
    if placed.follows:
        basis_m = np.array(RESTS[placed.basis][side is Hand.RIGHT].wrist_m)
        return np.asarray(basis_m + placed.share * (at_m - basis_m))
    if placed.aim_m is None or time_s < placed.aimed_from_s:
        return at_m
    out = 1.0 if side is Hand.LEFT else -1.0
    way_m = np.array(placed.aim_m) * [out, 1.0, 1.0] - [0.0, HIPS_HEIGHT_M, 0.0] - _SHOULDER_M
    return np.asarray(_SHOULDER_M + distance_m(at_m, _SHOULDER_M) * way_m / np.linalg.norm(way_m))


def stroke_start_m(placed: PlacedGesture, side: Hand) -> FloatArray:
    """The wrist's position (3,) at the start of the stroke."""
    return wrist_m(placed, side, placed.clip.markers.stroke_start)


def stroke_end_m(placed: PlacedGesture, side: Hand) -> FloatArray:
    """The wrist's position (3,) at the end of the stroke."""
    return wrist_m(placed, side, placed.clip.markers.stroke_end)


def relax_m(placed: PlacedGesture, side: Hand) -> FloatArray:
    """The wrist's position (3,) at the relax time."""
    return wrist_m(placed, side, placed.clip.markers.relax)


def distance_m(one: FloatArray, other: FloatArray) -> float:
    """The Euclidean distance between two positions."""
    return dist(one.tolist(), other.tolist())


def _wrist_m(clip: Clip, side: Hand, time_s: float, size: float) -> FloatArray:
    start_s, relax_s, left = clip.markers.start, clip.markers.relax, side is Hand.LEFT
    said = [
        (key.time_s, arm.place)
        for key in clip.keys
        if start_s <= key.time_s <= relax_s and (arm := key.left if left else key.right) and arm.place
    ]
    if not said:
        return sector_m(_UNPLACED, size)
    passed = bisect_right(said, time_s, key=lambda each: each[0])
    (from_s, place), (to_s, later) = said[max(passed - 1, 0)], said[min(passed, len(said) - 1)]
    from_m = place_m(place, size)
    if not from_s < time_s < to_s:
        return np.array(from_m)
    share, to_m = (time_s - from_s) / (to_s - from_s), place_m(later, size)
    return np.array([one + share * (other - one) for one, other in zip(from_m, to_m, strict=True)])
