"""Analytic inverse kinematics of an arm: collarbone, shoulder and elbow for a given wrist position.

Conventions: everything refers to the left arm, in the hips' space of the upright body (x outwards, y up, z away from
the body, metres); the right arm is its mirror image. All functions are vectorized over leading axes (…, 3). The upper
arm's own x axis runs to the elbow, and the elbow bends about its -y axis, so that the forearm moves towards its z axis.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import cos, radians, sqrt

import numpy as np

from ...model import FloatArray
from ..body.limits import within_shoulder_limits
from ..body.skeleton import Skeleton
from ..geometry.curves import clipped
from ..geometry.rotations import (
    cross,
    dot,
    from_axes,
    from_axis_angle,
    from_rotation_vector,
    inverse,
    length,
    multiply,
    rotate,
    x_axis,
)

ELBOW_FLEXION_DEG = (12.0, 136.0)
"""The range of elbow flexion seen in speakers' strokes (docs/references.md)."""

_MOST_BENT_DEG, _STRAIGHT_DEG = 149.0, 2.0
_SOFTENED_M = 0.02
_RAISED = (-1.0, -0.6, 0.0, 0.3, 0.6, 0.9), (0.0, 5.5, 8.0, 10.0, 18.0, 24.0)
"""Heights of the hand over the shoulder in arm lengths, and the collarbone's elevation in degrees: hanging, before the
belly, at the shoulder, the head, overhead."""
_PROTRACTED_DEG, _RETRACTED_DEG = 16.0, 12.0
_SHRUG_DEG, _SLUMP_DEG = 18.0, 8.0
_ALONG: FloatArray = np.array([1.0, 0.0, 0.0])
_ALONG.setflags(write=False)


@dataclass(frozen=True, slots=True, eq=False)
class ArmBones:
    """The collarbone's root, the offset from there to the shoulder, and the lengths of upper arm and forearm."""

    root_m: FloatArray
    collarbone_m: FloatArray
    upper_m: float
    lower_m: float

    @staticmethod
    def of(skeleton: Skeleton) -> "ArmBones":
        """The bones of the skeleton's left arm."""
        return _bones(skeleton)

    @property
    def length_m(self) -> float:
        """The length of the stretched arm from shoulder to wrist."""
        return self.upper_m + self.lower_m

    @property
    def shoulder_m(self) -> FloatArray:
        """The shoulder's position with the collarbone at rest."""
        return np.asarray(self.root_m + self.collarbone_m)


@lru_cache(maxsize=64)
def _bones(skeleton: Skeleton) -> ArmBones:
    """Cached; never mutated."""
    names = ("spine", "chest", "upperChest", "leftShoulder", "leftUpperArm", "leftLowerArm", "leftHand")
    *trunk_m, shoulder_m, elbow_m, wrist_m = skeleton.offsets_m[skeleton.chain(*names)]
    return ArmBones(np.sum(trunk_m, axis=0), shoulder_m, float(length(elbow_m)[0]), float(length(wrist_m)[0]))


@dataclass(frozen=True, slots=True, eq=False)
class BentArm:
    """Local rotations of `upper_arm` and `elbow` (the hinge alone, without the forearm's twist), and the orientations
    of the upper arm and of the untwisted `forearm` in the hips' space."""

    upper_arm: FloatArray
    elbow: FloatArray
    orientation: FloatArray
    forearm: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Reach:
    """A solution: local rotations of `collarbone`, `upper_arm` and `elbow`, the orientation of the `forearm` as of a
    `BentArm`, and the positions of elbow and wrist."""

    collarbone: FloatArray
    upper_arm: FloatArray
    elbow: FloatArray
    forearm: FloatArray
    elbow_m: FloatArray
    wrist_m: FloatArray


def reach(bones: ArmBones, wrist_m: FloatArray, *, swivel_rad: FloatArray, raised: FloatArray | float = 0.0) -> Reach:
    """The arm whose wrist is at `wrist_m` (…, 3), or as near to it as possible.

    Targets that are too far or too near are pulled into range smoothly, without stretching bones: the elbow stays
    within `ELBOW_FLEXION_DEG`, the shoulder within its limits.

    `swivel_rad` (…) rotates the elbow about the line from shoulder to wrist, away from its natural position, outwards
    and up. `raised` (…) in [-1, 1] lifts (shrug) or lowers (slump) the collarbone in addition to what the wrist's
    height demands.
    """
    collarbone = collarbone_for(bones, wrist_m, raised)
    shoulder_m = shoulder_of(bones, collarbone)
    to_wrist = wrist_m - shoulder_m
    asked_m = np.maximum(length(to_wrist), 1e-6)
    direction = to_wrist / asked_m
    distance_m = _within_reach(bones, asked_m)
    pole = rotate(from_rotation_vector(direction * swivel_rad[..., None]), elbow_direction(direction))
    bend = _bent(bones, collarbone, direction, distance_m, pole)
    elbow_m = shoulder_m + bones.upper_m * x_axis(bend.orientation)
    reached_m = elbow_m + bones.lower_m * x_axis(bend.forearm)
    return Reach(collarbone, bend.upper_arm, bend.elbow, bend.forearm, elbow_m, reached_m)


def reach_by_elbow(bones: ArmBones, collarbone: FloatArray, to_wrist_m: FloatArray, elbow: FloatArray) -> BentArm:
    """The arm on a given `collarbone` (…, 4) with its wrist `to_wrist_m` (…, 3) from the shoulder and its elbow in the
    direction `elbow` (…, 3)."""
    asked_m = np.maximum(length(to_wrist_m), 1e-6)
    direction = to_wrist_m / asked_m
    distance_m = clipped(asked_m, *_distances(bones, (_MOST_BENT_DEG, _STRAIGHT_DEG)))
    return _bent(bones, collarbone, direction, distance_m, _across(elbow, direction))


def shoulder_of(bones: ArmBones, collarbone: FloatArray) -> FloatArray:
    """Where the shoulder (…, 3) is with this rotation of the collarbone (…, 4)."""
    return np.asarray(bones.root_m + rotate(collarbone, bones.collarbone_m))


def towards_elbow(upper_arm: FloatArray, elbow: FloatArray, bones: ArmBones) -> FloatArray:
    """The direction (…, 3) of the elbow, perpendicular to the line from shoulder to wrist, of an upper arm with this
    orientation (…, 4) and hinge rotation (…, 4). It is defined for a straight arm too."""
    to_wrist = bones.upper_m * _ALONG + bones.lower_m * x_axis(elbow)
    aside = np.zeros_like(to_wrist)
    aside[..., 0], aside[..., 2] = to_wrist[..., 2], -to_wrist[..., 0]
    return rotate(upper_arm, aside / length(aside))


def collarbone_for(bones: ArmBones, wrist_m: FloatArray, raised: FloatArray | float = 0.0) -> FloatArray:
    """The collarbone's rotation for a hand at `wrist_m`: raised for a high hand, protracted for a far one, retracted
    for one behind the body.

    Towards-natural §3.4 adjusts it by the height of the hands; the angles are ours, based on the third of the arm's
    elevation that the shoulder girdle contributes.
    """
    ahead = (wrist_m - bones.shoulder_m) / bones.length_m
    outwards, up, away = ahead[..., 0], ahead[..., 1], ahead[..., 2]
    far = np.hypot(np.maximum(away, 0.0), np.maximum(-outwards, 0.0))
    up_deg = np.interp(up, *_RAISED) + np.where(np.asarray(raised) > 0, _SHRUG_DEG, _SLUMP_DEG) * raised
    forward_deg = _PROTRACTED_DEG * _ease((far - 0.2) / 0.8) - _RETRACTED_DEG * _ease(-away / 0.5)
    forward = from_axis_angle((0.0, -1.0, 0.0), np.radians(forward_deg))
    return multiply(forward, from_axis_angle((0.0, 0.0, 1.0), np.radians(up_deg)))


def elbow_direction(direction: FloatArray) -> FloatArray:
    """The natural direction of the elbow, perpendicular to `direction` (…, 3) from the shoulder to the wrist.

    The model: an elbow hangs down and slightly outwards; it is behind a hand that hangs low and in front of the chest
    for one that reaches across. This suits talking hands; `swivel_rad` of `reach` adapts it to a pose.
    """
    low, across = np.maximum(-direction[..., 1], 0.0), np.maximum(-direction[..., 0], 0.0)
    pole = np.stack((np.full_like(low, 0.45), 0.4 * low - 1.0, 0.9 * across - 0.45 * (1 + low)), axis=-1)
    return _across(pole, direction)


def _across(vector: FloatArray, direction: FloatArray) -> FloatArray:
    """The component of `vector` perpendicular to `direction`, normalized."""
    vector = vector - dot(vector, direction) * direction
    return np.asarray(vector / np.maximum(length(vector), 1e-9))


def _bent(
    bones: ArmBones, collarbone: FloatArray, direction: FloatArray, distance_m: FloatArray, pole: FloatArray
) -> BentArm:
    """Shoulder and elbow for a wrist at `distance_m` in a direction from the shoulder, the elbow towards `pole`."""
    squared_m = distance_m * distance_m
    along = (bones.upper_m**2 + squared_m - bones.lower_m**2) / (2 * bones.upper_m * distance_m)
    aside = np.sqrt(np.maximum(1 - along * along, 0.0))
    upper = direction * along + pole * aside
    towards = direction * aside - pole * along
    orientation = within_shoulder_limits(from_axes(upper, cross(towards, upper), towards))
    cosine = (squared_m - bones.upper_m**2 - bones.lower_m**2) / (2 * bones.upper_m * bones.lower_m)
    elbow = from_axis_angle((0.0, -1.0, 0.0), np.arccos(clipped(cosine, -1.0, 1.0))[..., 0])
    return BentArm(multiply(inverse(collarbone), orientation), elbow, orientation, multiply(orientation, elbow))


def _within_reach(bones: ArmBones, distance_m: FloatArray) -> FloatArray:
    """Distances clamped smoothly to what the elbow's range allows; unchanged up to 2 cm from its ends."""
    longest, shortest = _distances(bones, ELBOW_FLEXION_DEG)
    over = np.maximum(distance_m - (longest - _SOFTENED_M), 0.0)
    under = np.maximum(shortest + _SOFTENED_M - distance_m, 0.0)
    pulled_in = distance_m - over + _SOFTENED_M * -np.expm1(-over / _SOFTENED_M)
    return np.asarray(pulled_in + under - _SOFTENED_M * -np.expm1(-under / _SOFTENED_M))


def _distances(bones: ArmBones, flexions_deg: tuple[float, float]) -> tuple[float, float]:
    """The distances from shoulder to wrist, by the law of cosines."""
    one, other = (
        sqrt(bones.upper_m**2 + bones.lower_m**2 + 2 * bones.upper_m * bones.lower_m * cos(radians(flexion_deg)))
        for flexion_deg in flexions_deg
    )
    return one, other


def _ease(share: FloatArray) -> FloatArray:
    share = clipped(share, 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))
