"""The trunk follows the gestures: it turns and leans towards the hands, and the weight shifts with it; with each stroke
the knees bend, the trunk bows and twists, and the shoulders tilt.

Towards Natural Gesture Synthesis (§3.4) puts body rotation on tracks with an offset and moves the wrist targets with
the body. Here a few degrees and centimetres derived from the wrists are added to the trunk's motion, low-pass filtered
and slightly ahead of the hands, since larger masses move first.

The trunk's part in strokes follows Lasseter's principle that movement starts at the centre of the body: the trunk
starts before the hand and reaches the emphasis with it.

Conventions: radians, metres, seconds; wrists in the hips' space of the upright body (x to the own side, y up, z
away); a rotation vector leans forward, turns to the left, tips to the right.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Hand
from ..body.motion import BodyMotion
from ..body.movement_style import StrokeLife
from ..body.skeleton import Skeleton
from ..geometry.curves import smoothed, superposed_movements
from ..geometry.rotations import from_rotation_vector, multiply
from .balance import hips_height_m, set_legs

SHARES: Mapping[str, float] = MappingProxyType({"spine": 0.4, "chest": 0.35, "upperChest": 0.25})
"""Each joint's share of the trunk's rotation."""

LEAN_RAD_M = 0.22
STRAIGHTEN_RAD_M = 0.10
TURN_RAD_M = 0.25
TWIST_RAD_M = 0.10
ASIDE_RAD_M = 0.08
WEIGHT_M_M = 0.05

BACK_M_M = (0.05, 0.07)
"""Per metre: forward lean towards the hand that is farther out, straightening for hands above the chest, yaw towards
the hand farther to the side, yaw with the hand that reaches farther, side bend away from the higher hand, and lateral
hip shift; and the backward movement of the hips, by each hand's reach and by the farther one's, after which the trunk
leans. With the latter two, hands far from the body move the centre of mass 5 mm forward instead of 16
(`benchmarks.realizer.balance`)."""

_AT_EASE_M: FloatArray = np.array([0.15, 0.05, 0.20])
_AT_EASE_M.setflags(write=False)
_CHEST_M = 0.4
_SMOOTHING_S = 0.22
_WEIGHT_SMOOTHING_S = 0.40
_AHEAD_S = 0.08


@dataclass(frozen=True, slots=True, eq=False)
class AccentCourse:
    """The movement added by strokes: `turns` (T, 3) of the trunk, `dip_m` (T,) and `aside_m` (T,) of the hips, and the
    forward reach of the `neck` (T,)."""

    turns: FloatArray
    dip_m: FloatArray
    aside_m: FloatArray
    neck: FloatArray


def follow_with_trunk(
    skeleton: Skeleton, body: BodyMotion, wrists_m: FloatArray, accents: AccentCourse | None = None
) -> None:
    """Turn the trunk of this body, in place, after the left and the right wrist (2, T, 3), and add the movement of
    strokes; the feet stay planted."""
    left, right = wrists_m - _AT_EASE_M
    turns = _followed(body.times_s, _turns(left, right), _SMOOTHING_S)
    turns = turns if accents is None else turns + accents.turns
    rotations, hips_m, joints = body.rotations, body.hips_m, skeleton.rows(*SHARES)
    shared = turns[:, None] * np.array(list(SHARES.values()))[:, None]
    rotations[:, joints] = multiply(rotations[:, joints], from_rotation_vector(shared))
    moved_m = hips_m[None].repeat(2, axis=0)
    shift_m = np.stack([WEIGHT_M_M * (left[:, 0] - right[:, 0]), -_way_back_m(left, right)], axis=-1)
    aside_m, away_m = _followed(body.times_s, shift_m, _WEIGHT_SMOOTHING_S).T
    moved_m[1, :, 0] += aside_m if accents is None else aside_m + accents.aside_m
    moved_m[1, :, 2] += away_m
    before_m, after_m = hips_height_m(skeleton, moved_m, rotations[:, 0])
    hips_m[:, [0, 2]] = moved_m[1][:, [0, 2]]
    hips_m[:, 1] += after_m - before_m
    if accents is not None:
        hips_m[:, 1] -= accents.dip_m
    set_legs(skeleton, rotations, hips_m)


def _way_back_m(left: FloatArray, right: FloatArray) -> FloatArray:
    """The backward movement (T,) of the hips that keeps the centre of mass over the feet while the hands reach out."""
    left_m, right_m = np.maximum(left[:, 2], 0.0), np.maximum(right[:, 2], 0.0)
    by_arms, by_lean = BACK_M_M
    return np.asarray(by_arms * (left_m + right_m) + by_lean * np.maximum(left_m, right_m))


def _turns(left: FloatArray, right: FloatArray) -> FloatArray:
    """Rotation vectors (T, 3): forward, to the left, to the right side."""
    (left_out, left_up, left_away), (right_out, right_up, right_away) = left.T, right.T
    reach_m = np.maximum(np.maximum(left_away, right_away), 0.0)
    over_chest_m = np.maximum(np.maximum(left_up, right_up) - _CHEST_M, 0.0)
    forward = LEAN_RAD_M * reach_m - STRAIGHTEN_RAD_M * over_chest_m
    to_the_left = TURN_RAD_M * (left_out - right_out) + TWIST_RAD_M * (right_away - left_away)
    return np.stack([forward, to_the_left, ASIDE_RAD_M * (left_up - right_up)], axis=-1)


def _followed(times_s: FloatArray, course: FloatArray, width_s: float) -> FloatArray:
    """A curve (T, C), smoothed and shifted slightly ahead, between frames along straight lines."""
    if len(times_s) < 2:
        return course
    step_s = float(times_s[1] - times_s[0])
    whole, share = divmod(_AHEAD_S / step_s, 1.0)
    smooth = smoothed(course, width_s / step_s)
    ahead = np.minimum(np.arange(len(times_s) + 1) + int(whole), len(times_s) - 1)
    smooth = smooth.take(ahead, axis=0)
    return np.asarray(smooth[:-1] + share * (smooth[1:] - smooth[:-1]))


AHEAD_S = 0.12
"""The time by which the trunk starts before the hand."""
RECOVERY_S = 0.5
SHORTEST_S = 0.22


@dataclass(frozen=True, slots=True)
class Accent:
    """A stroke of one hand, from its start to its emphasis; `strength` is 1 for a fast one."""

    start_s: float
    stroke_s: float
    strength: float
    side: Hand


def accent_course(times_s: FloatArray, accents: Sequence[Accent], life: StrokeLife, *, scale: float) -> AccentCourse:
    """The sum of all strokes; `scale` (0 to 1) is 1 - stillness."""
    by = np.array([scale * each.strength * _whole(each.side, life) for each in accents]).reshape(-1, 6)
    starts_s = np.array([each.start_s - AHEAD_S for each in accents])
    reached_s = np.array([max(each.stroke_s, each.start_s - AHEAD_S + SHORTEST_S) for each in accents])
    recovery_s = np.full(len(accents), RECOVERY_S)
    durations_s = np.concatenate([reached_s - starts_s, recovery_s])
    course = superposed_movements(
        times_s, np.concatenate([starts_s, reached_s]), durations_s, np.concatenate([by, -by])
    )
    return AccentCourse(course[:, :3], course[:, 3], course[:, 4], course[:, 5])


def _whole(side: Hand, life: StrokeLife) -> FloatArray:
    """A stroke of full strength: bow, twist, tip, dip, shift of the weight to the left, reach of the neck."""
    right = 1.0 if side is Hand.RIGHT else -1.0
    bow, twist, tip, neck = np.radians([life.bow_deg, life.twist_deg, life.shoulders_deg, life.neck_deg])
    return np.array([bow, right * twist, right * tip, life.dip_m, -right * life.weight_m, neck])
