"""Gaze geometry: both eyes converge on a point, within their limits.

Conventions: metres and radians in the world; an unrotated eye looks along the head's +Z. The eyes' rotations have no
roll. Limits are those of the eye in the head.
"""

from dataclasses import dataclass

import numpy as np

from ...model import FloatArray
from ..body.skeleton import Skeleton
from ..geometry.angles import from_pitch_yaw, pitch_and_yaw, unit_vector
from ..geometry.rotations import inverse, multiply, rotate

EYES = ("leftEye", "rightEye")
TRUNK = ("spine", "chest", "upperChest")

SIDEWAYS_LIMIT = np.radians(35.0)
UPRIGHT_LIMIT = np.radians(25.0)

FARTHEST_M = 20.0
"""The eyes are parallel for targets beyond this distance."""

_LIMITS = np.array([UPRIGHT_LIMIT, SIDEWAYS_LIMIT])[:, None, None]
_NEAR_ENOUGH = 0.4
"""Within this share of `FARTHEST_M` along each axis a point is nearer than that, and no eye's line ends before it."""
_PARALLEL = 1e-6
_AHEAD = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class Chest:
    """What carries the head: the upper chest's orientation in the world (T, 4), and the neck's position (T, 3)."""

    orientation: FloatArray
    neck_m: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Face:
    """The head's orientation in the world (T, 4), and the positions of the left and right eye (T, 2, 3)."""

    orientation: FloatArray
    eyes_m: FloatArray


def chest(skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> Chest:
    """The chest, from the rotations of the joints between hips and neck."""
    turned = [rotations[:, 0]]
    for joint in skeleton.chain(*TRUNK):
        turned.append(multiply(turned[-1], rotations[:, joint]))
    offsets_m = skeleton.offsets_m[skeleton.chain(*TRUNK, "neck")]
    return Chest(turned[-1], hips_m + rotate(np.stack(turned), offsets_m[:, None]).sum(axis=0))


def face(skeleton: Skeleton, carried_by: Chest, neck: FloatArray, head: FloatArray) -> Face:
    """Head and eyes on the chest, for local rotations (T, 4) of neck and head."""
    joint, *eyes = skeleton.chain("head", *EYES)
    turned = multiply(carried_by.orientation, neck)
    head_m = carried_by.neck_m + rotate(turned, skeleton.offsets_m[joint])
    turned = multiply(turned, head)
    return Face(turned, head_m[:, None] + rotate(turned[:, None], skeleton.offsets_m[eyes]))


def eye_rotations(where: Face, at_m: FloatArray) -> FloatArray:
    """The rotations (T, 2, 4) of the left and right eye towards the points `at_m` (T, 3), within their limits."""
    return looking(where, at_m)[0]


def looking(where: Face, at_m: FloatArray) -> tuple[FloatArray, FloatArray]:
    """`eye_rotations`, and the points (T, 3) at which the eyes look then: `at_m`, but where their limits keep them from
    it, or where it is so far that they are parallel."""
    asked = np.stack(pitch_and_yaw(rotate(inverse(where.orientation)[:, None], at_m[:, None] - where.eyes_m)))
    within = np.minimum(np.maximum(asked, -_LIMITS), _LIMITS)
    eyes, seen_m = from_pitch_yaw(*within), at_m
    missed = (np.abs(asked) >= _LIMITS).any(axis=(0, 2)) | (np.abs(at_m).max(axis=1) > _NEAR_ENOUGH * FARTHEST_M)
    if missed.any():
        seen_m = at_m.copy()
        seen_m[missed] = fixation_point_m(Face(where.orientation[missed], where.eyes_m[missed]), eyes[missed])
    return eyes, seen_m


def fixation_point_m(where: Face, eyes: FloatArray) -> FloatArray:
    """The points (T, 3) at which eyes with these rotations (T, 2, 4) look: where their lines of sight come nearest."""
    lines = rotate(multiply(where.orientation[:, None], eyes), _AHEAD)
    left, right = lines[:, 0], lines[:, 1]
    base = where.eyes_m[:, 0] - where.eyes_m[:, 1]
    cosine, on_left, on_right = (np.sum(a * b, axis=-1) for a, b in ((left, right), (base, left), (base, right)))
    sine_squared = 1.0 - cosine**2
    along = np.stack([cosine * on_right - on_left, on_right - cosine * on_left], axis=-1)
    along_m = np.clip(along / np.maximum(sine_squared, _PARALLEL)[:, None], 0.0, FARTHEST_M)
    ends_m = where.eyes_m + np.where(sine_squared < _PARALLEL, FARTHEST_M, along_m.T).T[:, :, None] * lines
    return np.asarray(ends_m.mean(axis=1))


def point_in_direction(pitch: FloatArray, yaw: FloatArray, distance_m: FloatArray, from_m: FloatArray) -> FloatArray:
    """The points (T, 3) at a distance from `from_m` in the direction of `pitch` and `yaw`."""
    return np.asarray(from_m + distance_m[:, None] * unit_vector(pitch, yaw))
