"""Our joints as those of MPEG-4's body, and rotations as angles about its axes, whatever a decoder makes of them.

Angles are from the pose in which a body stands with its arms down, palms to the thighs; each joint's axes are the
world's there (X to its left, Y up, Z forward). Our spine has three joints, which are the vertebrae L3, T10 and T6; the
neck is C4.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from scipy.spatial.transform import Rotation

from ....model import FloatArray
from ...gestures.hand_shapes import THUMB_HINGE

TRUNK: Mapping[str, str] = MappingProxyType(
    {"spine": "vl3", "chest": "vt10", "upperChest": "vt6", "neck": "vc4", "head": "skullbase"}
)
"""The vertebra that each joint of our trunk is."""

FINGERS: Mapping[str, str] = MappingProxyType({"Index": "index", "Middle": "middle", "Ring": "ring", "Little": "pinky"})
FINGER_BENDS = (("Intermediate", "2_flexion"), ("Distal", "3_flexion"))
THUMB_BENDS = (("Proximal", "thumb2_flexion"), ("Distal", "thumb3_flexion"))

FINGER_HINGE: FloatArray = np.array([0.0, 0.0, 1.0])
"""The axis about which the outer joints of a finger bend, of the left hand towards its back."""


def euler_rad(rotations: Rotation, order: str) -> FloatArray:
    """The angles (T, 3) about three axes, each as the turns before leave it. Where the first and the last are one axis,
    the last is 0."""
    matrices = rotations.as_matrix()
    i, j, k = ("XYZ".index(axis) for axis in order)
    parity = 1.0 if (j - i) % 3 == 1 else -1.0
    sine = np.clip(parity * matrices[:, i, k], -1.0, 1.0)
    locked = np.abs(sine) > 1 - 1e-12
    first = np.arctan2(-parity * matrices[:, j, k], matrices[:, k, k])
    last = np.arctan2(-parity * matrices[:, i, j], matrices[:, i, i])
    alone = np.arctan2(parity * matrices[:, k, j], matrices[:, j, j])
    return np.stack([np.where(locked, alone, first), np.arcsin(sine), np.where(locked, 0.0, last)], axis=1)


def angle_about(rotations: Rotation, axis: FloatArray) -> FloatArray:
    """The angles (T,) about an axis, which may be more than 90°."""
    quaternions = rotations.as_quat()
    return np.asarray(2 * np.arctan2(quaternions[:, :3] @ (axis / np.linalg.norm(axis)), quaternions[:, 3]))


def arms_down(side: str) -> Rotation:
    """The turn of an arm from the T-pose to hanging."""
    return Rotation.from_euler("z", -90.0 if side == "left" else 90.0, degrees=True)


def thumb_hinge(side: str) -> FloatArray:
    """The axis, in the T-pose, about which the outer joints of a thumb bend."""
    return np.asarray(THUMB_HINGE if side == "left" else THUMB_HINGE * (1.0, -1.0, -1.0))
