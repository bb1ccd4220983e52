"""Rotations as a bone is keyed: quaternions, an axis and angle, or Euler angles in any order."""

import numpy as np
from mathutils import Euler, Quaternion

from ..motion.rotations import Array


def rotation_curves(quaternions: Array, mode: str) -> tuple[str, Array]:
    """The property that a bone of this rotation mode is turned by, and its values (T, 3 or 4) for quaternions (T, 4;
    w x y z). Euler angles go on from frame to frame without a jump."""
    if mode == "QUATERNION":
        return "rotation_quaternion", quaternions
    if mode == "AXIS_ANGLE":
        return "rotation_axis_angle", np.array([_axis_angle(each) for each in quaternions])
    found: list[Euler] = []
    for each in quaternions:
        turn = Quaternion(each)
        found.append(turn.to_euler(mode, found[-1]) if found else turn.to_euler(mode))
    return "rotation_euler", np.array(found)


def _axis_angle(quaternion: Array) -> tuple[float, ...]:
    axis, angle = Quaternion(quaternion).to_axis_angle()
    return (angle, *axis)
