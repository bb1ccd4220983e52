"""Keeps the feet planted: the height of the hips, and leg rotations by inverse kinematics.

Conventions: metres in the world. Each leg is solved analytically: the knee's angle from the distance of hip joint and
ankle, the thigh's direction from the ankle's position relative to the foot's heading. The knee bends about the lower
leg's x axis, as in the T-pose.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ...model import FloatArray
from ..body.skeleton import SIDES, Skeleton, forward
from ..geometry.curves import clipped, soft_maximum
from ..geometry.rotations import from_axis_angle, inverse, length, multiply, rotate, sine_and_cosine

_LEG = ("UpperLeg", "LowerLeg", "Foot")
LEG_JOINTS = tuple(side + part for side in SIDES for part in _LEG)

STRETCHED = 0.992
"""How much of its length the weight-bearing leg extends to: its knee is bent by about 14°, never locked."""

_SOFTNESS_M = 0.0025
"""The width of the smooth transition between the legs that limit the height of the hips."""


@dataclass(frozen=True, slots=True)
class FootPlacement:
    """A planted foot: its ankle's position, and its heading to the left in radians."""

    ankle_m: tuple[float, float, float]
    yaw: float


Feet = tuple[FootPlacement, FootPlacement]
"""The left and the right foot."""


@dataclass(frozen=True, slots=True, eq=False)
class FeetCourse:
    """Feet that move: positions of the ankles (2, T, 3) and headings (2, T), the left's and the right's."""

    ankles_m: FloatArray
    yaws: FloatArray


_STANDING: Feet = (FootPlacement((0.115, 0.08, -0.012), 0.16), FootPlacement((-0.110, 0.08, -0.038), -0.12))


@lru_cache(maxsize=64)
def standing(skeleton: Skeleton) -> Feet:
    """The usual footing: feet slightly apart, toes out, the left foot a little in front."""
    scale, hips = skeleton.proportions.scale, skeleton.proportions.hips
    left, right = (
        FootPlacement((hips * foot.ankle_m[0], scale * foot.ankle_m[1], scale * foot.ankle_m[2]), foot.yaw)
        for foot in _STANDING
    )
    return left, right


def feet_of(skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> FeetCourse:
    """The position of a body's feet, assuming level soles."""
    legs_only = frozenset([0, *skeleton.chain(*LEG_JOINTS)])
    places_m, turned = forward(skeleton, rotations, hips_m, legs_only)
    rows = skeleton.chain(*(side + "Foot" for side in SIDES))
    ahead = rotate(turned[:, rows], np.array([0.0, 0.0, 1.0]))
    yaws = np.arctan2(ahead[..., 0], ahead[..., 2])
    return FeetCourse(np.ascontiguousarray(places_m[:, rows].swapaxes(0, 1)), yaws.T)


def hips_height_m(
    skeleton: Skeleton, hips_m: FloatArray, turned: FloatArray, feet: Feet | FeetCourse | None = None
) -> FloatArray:
    """The height (…, T) of hips at the horizontal position `hips_m` (…, T, 3) with orientations `turned` (T, 4): as
    high as the weight-bearing leg reaches. The feet are those of `standing` unless given."""
    ankles_m, _yaws = _placed(skeleton, feet)
    hip_joints_m = rotate(turned, _hip_joints_m(skeleton))
    reach_m = ankles_m - hip_joints_m
    away_m, aside_m = (reach_m[..., axis] - hips_m[..., None, :, axis] for axis in (0, 2))
    rise_m = np.sqrt((STRETCHED * sum(_lengths_m(skeleton))) ** 2 - away_m * away_m - aside_m * aside_m)
    rise_m += reach_m[..., 1]
    left_m, right_m = rise_m[..., 0, :], rise_m[..., 1, :]
    return -soft_maximum(-left_m, -right_m, _SOFTNESS_M)


def _placed(skeleton: Skeleton, feet: Feet | FeetCourse | None) -> tuple[FloatArray, FloatArray]:
    """Ankles (2, T or 1, 3) and headings (2, T or 1) of these feet, by default of `standing`."""
    if isinstance(feet, FeetCourse):
        return feet.ankles_m, feet.yaws
    feet = feet or standing(skeleton)
    return np.array([foot.ankle_m for foot in feet])[:, None], np.array([foot.yaw for foot in feet])[:, None]


def legs(
    skeleton: Skeleton, turned: FloatArray, hips_m: FloatArray, feet: Feet | FeetCourse | None = None
) -> FloatArray:
    """The rotations (2, 3, T, 4) of `LEG_JOINTS`, side by side, that keep the feet in place for any movement of the
    hips.

    Feet beyond the legs' reach leave their places; at heights up to `hips_height_m` this does not happen.
    """
    ankles_m, yaws = _placed(skeleton, feet)
    flat = from_axis_angle((0.0, 1.0, 0.0), yaws)
    way_m = rotate(inverse(flat), ankles_m - hips_m - rotate(turned, _hip_joints_m(skeleton)))
    thigh, knee = _leg(skeleton, way_m)
    thigh = multiply(flat, thigh)
    leg = np.array((multiply(inverse(turned), thigh), knee, multiply(inverse(multiply(thigh, knee)), flat)))
    return leg.swapaxes(0, 1)


def set_legs(
    skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray, feet: Feet | FeetCourse | None = None
) -> None:
    """Turn the legs of a body with these local rotations (T, J, 4), so that its feet stay in place, or at `feet`."""
    for side, leg in zip(SIDES, legs(skeleton, rotations[:, 0], hips_m, feet), strict=True):
        rotations[:, skeleton.rows(*(side + part for part in _LEG))] = leg.swapaxes(0, 1)


def _leg(skeleton: Skeleton, way_m: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The rotations (…, 4) of thighs and knees for the vectors (…, 3) from hip to ankle, in the space of the foot's
    heading. Both legs have the same bones."""
    shin, foot = skeleton.offsets_m[skeleton.chain("leftLowerLeg", "leftFoot")]
    upper_m, lower_m = _lengths_m(skeleton)
    aside_m, up_m, away_m = way_m[..., 0], way_m[..., 1], way_m[..., 2]
    distance_m = np.minimum(length(way_m)[..., 0], upper_m + lower_m)
    cosine = (distance_m**2 - upper_m**2 - lower_m**2) / (2 * upper_m * lower_m)
    straight = np.arctan2(shin[2], -shin[1]) - np.arctan2(foot[2], -foot[1])
    bend = np.arccos(clipped(cosine, -1.0, 1.0)) - straight
    bend_sine, bend_cosine = sine_and_cosine(bend)
    bent_y = shin[1] + foot[1] * bend_cosine - foot[2] * bend_sine
    bent_z = shin[2] + foot[1] * bend_sine + foot[2] * bend_cosine
    swing = np.arctan2(away_m, -np.sqrt(aside_m * aside_m + up_m * up_m)) - np.arctan2(bent_z, bent_y)
    spread = np.arctan2(aside_m, -up_m)
    return _swung(swing, spread), from_axis_angle((1.0, 0.0, 0.0), bend)


def _swung(swing: FloatArray, spread: FloatArray) -> FloatArray:
    """The rotations (…, 4) about x by `swing`, then about z by `spread`."""
    (sx, cx), (sz, cz) = sine_and_cosine(swing / 2), sine_and_cosine(spread / 2)
    turned = np.empty((*sx.shape, 4))
    turned[..., 0], turned[..., 1], turned[..., 2], turned[..., 3] = cz * sx, sz * sx, sz * cx, cz * cx
    return turned


def _hip_joints_m(skeleton: Skeleton) -> FloatArray:
    """The positions of the hip joints (2, 1, 3), in the space of the hips."""
    return skeleton.offsets_m[skeleton.chain(*(side + "UpperLeg" for side in SIDES)), None]


@lru_cache(maxsize=64)
def _lengths_m(skeleton: Skeleton) -> tuple[float, float]:
    thigh, shin = skeleton.offsets_m[skeleton.chain("leftLowerLeg", "leftFoot")]
    return float(np.linalg.norm(thigh)), float(np.linalg.norm(shin))
