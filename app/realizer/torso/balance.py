"""Keeps the feet planted: the height of the hips, and leg rotations by inverse kinematics.

Conventions: metres in the world. Each leg is solved analytically: the knee's angle from the distance of hip joint and
ankle, the thigh's direction from the ankle's position relative to the foot's heading. The knee bends about the lower
leg's x axis, as in the T-pose.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ...model import FloatArray
from ..body.skeleton import SIDES, Skeleton
from ..geometry.rotations import from_axis_angle, inverse, multiply, rotate

_LEG = ("UpperLeg", "LowerLeg", "Foot")
LEG_JOINTS = tuple(side + part for side in SIDES for part in _LEG)

STRETCHED = 0.992
"""How much of its length the weight-bearing leg extends to: its knee is bent by about 14°, never locked."""

_SOFTNESS_M = 0.0025
"""The width of the smooth transition between the legs that limit the height of the hips."""


@dataclass(frozen=True, slots=True)
class Footing:
    """A planted foot: its ankle's position, and its heading to the left in radians."""

    ankle_m: tuple[float, float, float]
    yaw: float


Feet = tuple[Footing, Footing]
"""The left and the right foot."""

_STANDING: Feet = (Footing((0.115, 0.08, -0.012), 0.16), Footing((-0.110, 0.08, -0.038), -0.12))


@lru_cache(maxsize=64)
def standing(skeleton: Skeleton) -> Feet:
    """Slightly apart, toes out, the left foot a little in front."""
    scale, hips = skeleton.proportions.scale, skeleton.proportions.hips
    left, right = (
        Footing((hips * foot.ankle_m[0], scale * foot.ankle_m[1], scale * foot.ankle_m[2]), foot.yaw)
        for foot in _STANDING
    )
    return left, right


def hips_height_m(skeleton: Skeleton, hips_m: FloatArray, turned: FloatArray, feet: Feet | None = None) -> FloatArray:
    """The height (T,) of hips at the horizontal position `hips_m` (T, 3) with orientations `turned` (T, 4): as high as
    the weight-bearing leg reaches. The feet are those of `standing` unless given."""
    heights = []
    for side, foot in zip(SIDES, feet or standing(skeleton), strict=True):
        hip_m = rotate(turned, skeleton.offsets_m[skeleton.index[f"{side}UpperLeg"]])
        across = np.asarray(foot.ankle_m) - hips_m - hip_m
        reach_m = STRETCHED * sum(_lengths_m(skeleton, side))
        rise_m = np.sqrt(reach_m**2 - across[:, 0] ** 2 - across[:, 2] ** 2)
        heights.append(foot.ankle_m[1] + rise_m - hip_m[:, 1])
    return np.asarray(-_SOFTNESS_M * np.logaddexp(-heights[0] / _SOFTNESS_M, -heights[1] / _SOFTNESS_M))


def legs(skeleton: Skeleton, turned: FloatArray, hips_m: FloatArray, feet: Feet | None = None) -> FloatArray:
    """The rotations (T, 6, 4) of `LEG_JOINTS` that keep the feet in place for any movement of the hips.

    Feet beyond the legs' reach leave their places; at heights up to `hips_height_m` this does not happen.
    """
    found = []
    for side, foot in zip(SIDES, feet or standing(skeleton), strict=True):
        hip_m = hips_m + rotate(turned, skeleton.offsets_m[skeleton.index[f"{side}UpperLeg"]])
        flat = from_axis_angle((0.0, 1.0, 0.0), np.array(foot.yaw))
        thigh, knee = _leg(skeleton, side, rotate(inverse(flat), np.asarray(foot.ankle_m) - hip_m))
        thigh = multiply(flat, thigh)
        found += [multiply(inverse(turned), thigh), knee, multiply(inverse(multiply(thigh, knee)), flat)]
    return np.stack(found, axis=1)


def set_legs(skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> None:
    """Turn the legs of a body with these local rotations (T, J, 4), so that its feet stay in place."""
    found = legs(skeleton, rotations[:, 0], hips_m)
    for number, side in enumerate(SIDES):
        rotations[:, skeleton.rows(*(side + part for part in _LEG))] = found[:, 3 * number : 3 * number + 3]


def _leg(skeleton: Skeleton, side: str, way_m: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The rotations (T, 4) of thigh and knee for the vector from hip to ankle, in the space of the foot's heading."""
    shin = skeleton.offsets_m[skeleton.index[f"{side}LowerLeg"]]
    foot = skeleton.offsets_m[skeleton.index[f"{side}Foot"]]
    upper_m, lower_m = _lengths_m(skeleton, side)
    distance_m = np.minimum(np.sqrt(np.sum(way_m**2, axis=-1)), upper_m + lower_m)
    cosine = (distance_m**2 - upper_m**2 - lower_m**2) / (2 * upper_m * lower_m)
    straight = np.arctan2(shin[2], -shin[1]) - np.arctan2(foot[2], -foot[1])
    bend = np.arccos(np.clip(cosine, -1.0, 1.0)) - straight
    bent_y = shin[1] + foot[1] * np.cos(bend) - foot[2] * np.sin(bend)
    bent_z = shin[2] + foot[1] * np.sin(bend) + foot[2] * np.cos(bend)
    along_m = np.hypot(way_m[:, 0], way_m[:, 1])
    swing = np.arctan2(way_m[:, 2], -along_m) - np.arctan2(bent_z, bent_y)
    spread = np.arctan2(way_m[:, 0], -way_m[:, 1])
    return _swung(swing, spread), _swung(bend, np.zeros_like(bend))


def _swung(swing: FloatArray, spread: FloatArray) -> FloatArray:
    """The rotations (T, 4) about x by `swing`, then about z by `spread`."""
    sx, cx, sz, cz = np.sin(swing / 2), np.cos(swing / 2), np.sin(spread / 2), np.cos(spread / 2)
    return np.stack([cz * sx, sz * sx, sz * cx, cz * cx], axis=-1)


@lru_cache(maxsize=128)
def _lengths_m(skeleton: Skeleton, side: str) -> tuple[float, float]:
    thigh, shin = (skeleton.offsets_m[skeleton.index[f"{side}{part}"]] for part in ("LowerLeg", "Foot"))
    return float(np.linalg.norm(thigh)), float(np.linalg.norm(shin))
