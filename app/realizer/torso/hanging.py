"""Arms that hang keep hanging straight down while the ribs bend to the side, as weights do, and stay off the hips.

Conventions: radians; world axes, y up, z forward.
"""

from dataclasses import replace

import numpy as np

from ...model import FloatArray
from ..body.motion import BodyMotion
from ..body.skeleton import SIDES, Skeleton
from ..geometry.rotations import from_axis_angle, inverse, multiply, rotate

_TRUNK = ("hips", "spine", "chest", "upperChest")
_HANGS, _WHOLLY = 0.80, 0.95
"""The drop of the upper arm, as a share of its length, from which on and at which it counts as hanging."""
_STRAIGHT = 0.85
"""How much of the ribs' tilt a hanging arm does not follow."""
_UP, _OUT, _FORWARD = np.array([0.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0]), (0.0, 0.0, 1.0)


def with_hanging_arms(skeleton: Skeleton, body: BodyMotion) -> BodyMotion:
    """The body whose arms, where they hang, do not follow the ribs' tilt to the side."""
    rotations = body.rotations.copy()
    chest = rotations[:, 0]
    for joint in skeleton.chain(*_TRUNK[1:]):
        chest = multiply(chest, rotations[:, joint])
    up = rotate(chest, _UP)
    tilt = np.arctan2(up[:, 0], up[:, 1])
    for side, sign in zip(SIDES, (1.0, -1.0), strict=True):
        collarbone, arm = skeleton.chain(f"{side}Shoulder", f"{side}UpperArm")
        carrying = multiply(chest, rotations[:, collarbone])
        turned = multiply(carrying, rotations[:, arm])
        straight = from_axis_angle(_FORWARD, _STRAIGHT * tilt * _hanging(rotate(turned, sign * _OUT)))
        rotations[:, arm] = multiply(inverse(carrying), multiply(straight, turned))
    return replace(body, rotations=rotations)


def _hanging(along: FloatArray) -> FloatArray:
    """How much arms in these directions (T, 3) hang (T,): 0 to 1."""
    share = np.clip((-along[:, 1] - _HANGS) / (_WHOLLY - _HANGS), 0.0, 1.0)
    return np.asarray(share * share * (3 - 2 * share))
