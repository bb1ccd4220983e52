"""The trunk's part in gestures: it turns to where the hands are, leans after them, and the weight goes along.

Towards Natural Gesture Synthesis (§3.4) lays body rotation over gestures on offset tracks and moves the wrists' targets
with the body. Ours follows the wrists: a few degrees and centimetres, added to what the trunk does, slowly, and a
little ahead of the hands, as the larger masses move first.

Conventions: radians, metres; wrists in the hips' space of the upright body (x to the own side, y up, z away).
"""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np
from scipy.ndimage import gaussian_filter1d

from ...model import FloatArray
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.rotations import from_rotation_vector, multiply
from .balance import LEG_JOINTS, hips_height_m, legs

SHARES: Mapping[str, float] = MappingProxyType({"spine": 0.4, "chest": 0.35, "upperChest": 0.25})
"""Each joint's part of what the trunk turns."""

LEAN_RAD_M = 0.22
STRAIGHTEN_RAD_M = 0.10
TURN_RAD_M = 0.25
TWIST_RAD_M = 0.10
ASIDE_RAD_M = 0.08
WEIGHT_M_M = 0.05
"""How far for each metre: forward after the hand that is farther out, upright for hands over the chest, round to the
hand that is farther aside, round after the one that reaches, over from the higher one, and the hips to the side."""

_AT_EASE_M: FloatArray = np.array([0.15, 0.05, 0.20])
_AT_EASE_M.setflags(write=False)
_CHEST_M = 0.4
_SMOOTHING_S = 0.22
_WEIGHT_SMOOTHING_S = 0.40
_AHEAD_S = 0.08


def with_trunk(skeleton: Skeleton, body: BodyMotion, left_m: FloatArray, right_m: FloatArray) -> BodyMotion:
    """The body with its trunk going along with the wrists (T, 3); the feet stay where they are."""
    left, right = left_m - _AT_EASE_M, right_m - _AT_EASE_M
    turns = _followed(body.times_s, _turns(left, right), _SMOOTHING_S)
    rotations = body.rotations.copy()
    for joint, share in SHARES.items():
        index = skeleton.index[joint]
        rotations[:, index] = multiply(rotations[:, index], from_rotation_vector(share * turns))
    aside_m = _followed(body.times_s, WEIGHT_M_M * (left[:, :1] - right[:, :1]), _WEIGHT_SMOOTHING_S)
    hips_m = body.hips_m + aside_m * [1.0, 0.0, 0.0]
    hips_m[:, 1] = hips_height_m(skeleton, hips_m, rotations[:, 0])
    rotations[:, skeleton.chain(*LEG_JOINTS)] = legs(skeleton, rotations[:, 0], hips_m)
    return replace(body, rotations=rotations, hips_m=hips_m)


def _turns(left: FloatArray, right: FloatArray) -> FloatArray:
    """Rotation vectors (T, 3): forward, to the left, aside to the right."""
    (left_out, left_up, left_away), (right_out, right_up, right_away) = left.T, right.T
    reach_m = np.maximum(np.maximum(left_away, right_away), 0.0)
    over_chest_m = np.maximum(np.maximum(left_up, right_up) - _CHEST_M, 0.0)
    forward = LEAN_RAD_M * reach_m - STRAIGHTEN_RAD_M * over_chest_m
    to_the_left = TURN_RAD_M * (left_out - right_out) + TWIST_RAD_M * (right_away - left_away)
    return np.stack([forward, to_the_left, ASIDE_RAD_M * (left_up - right_up)], axis=-1)


def _followed(times_s: FloatArray, course: FloatArray, width_s: float) -> FloatArray:
    """A course (T, C), smoothed and a little ahead."""
    if len(times_s) < 2:
        return course
    smooth = gaussian_filter1d(course, width_s / float(times_s[1] - times_s[0]), axis=0, mode="nearest")
    return np.stack([np.interp(times_s + _AHEAD_S, times_s, column) for column in smooth.T], axis=-1)
