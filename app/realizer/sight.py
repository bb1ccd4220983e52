"""Where the eyes look: both at one point, as far as they can turn.

Conventions: metres and radians in the world; an eye that is not turned looks along +Z of the head. The eyes' rotations
have no roll. Limits are those of the eye in the head.
"""

from dataclasses import dataclass

import numpy as np

from app.model import FloatArray
from app.realizer.angles import aim, direction, turn
from app.realizer.motion import BodyMotion
from app.realizer.rotations import inverse, multiply, rotate
from app.realizer.skeleton import Skeleton

EYES = ("leftEye", "rightEye")

SIDEWAYS_LIMIT = np.radians(35.0)
UPRIGHT_LIMIT = np.radians(25.0)

FARTHEST_M = 20.0
"""Eyes that see farther are parallel."""

_PARALLEL = 1e-8
_AHEAD = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class Carried:
    """The head in the world, and what carries it: `chest` and `head` (T, 4), the eyes' places (T, 2, 3)."""

    chest: FloatArray
    head: FloatArray
    eyes_m: FloatArray


def carried(skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> Carried:
    """Head and eyes as the joints from the hips up carry them."""
    place_m, turned = hips_m, rotations[:, 0]
    for joint in ("spine", "chest", "upperChest", "neck"):
        place_m = place_m + rotate(turned, skeleton.offsets_m[skeleton.index[joint]])
        turned = multiply(turned, rotations[:, skeleton.index[joint]])
        if joint == "upperChest":
            chest = turned
    place_m = place_m + rotate(turned, skeleton.offsets_m[skeleton.index["head"]])
    head = multiply(turned, rotations[:, skeleton.index["head"]])
    eyes = skeleton.offsets_m[skeleton.chain(*EYES)]
    return Carried(chest, head, place_m[:, None] + rotate(head[:, None], eyes))


def aimed(skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray, at_m: FloatArray) -> FloatArray:
    """The rotations (T, 2, 4) of the left and right eye that look at the points `at_m` (T, 3), within their limits."""
    body = carried(skeleton, rotations, hips_m)
    pitch, yaw = aim(rotate(inverse(body.head)[:, None], at_m[:, None] - body.eyes_m))
    pitch = np.clip(pitch, -UPRIGHT_LIMIT, UPRIGHT_LIMIT)
    return turn(pitch, np.clip(yaw, -SIDEWAYS_LIMIT, SIDEWAYS_LIMIT), np.zeros_like(yaw))


def seen_m(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    """The points (T, 3) that both eyes look at: where their lines of sight come nearest to each other."""
    where = carried(skeleton, body.rotations, body.hips_m)
    eyes = body.rotations[:, skeleton.chain(*EYES)]
    lines = rotate(multiply(where.head[:, None], eyes), _AHEAD)
    left, right = lines[:, 0], lines[:, 1]
    base = where.eyes_m[:, 0] - where.eyes_m[:, 1]
    cosine, on_left, on_right = (np.sum(a * b, axis=-1) for a, b in ((left, right), (base, left), (base, right)))
    sine_squared = np.maximum(1.0 - cosine**2, _PARALLEL)
    left_m, right_m = (cosine * on_right - on_left) / sine_squared, (on_right - cosine * on_left) / sine_squared
    ends_m = where.eyes_m + np.clip(np.stack([left_m, right_m], axis=-1), 0.0, FARTHEST_M)[:, :, None] * lines
    return np.asarray(ends_m.mean(axis=1))


def toward(pitch: FloatArray, yaw: FloatArray, distance_m: FloatArray, from_m: FloatArray) -> FloatArray:
    """The points (T, 3) so far from `from_m` in the direction of `pitch` and `yaw`."""
    return np.asarray(from_m + distance_m[:, None] * direction(pitch, yaw))
