"""Converts between hand orientation in the body's space, and forearm twist with wrist bend.

Conventions: the left arm, angles in radians, vectorized (…). In the T-pose the fingers run along the hand's x axis, the
palm faces -y and the thumb z. Forearm twist (pronation, supination) is about the forearm's x axis and belongs to VRM's
lower arm joint; the hand bends about z (negative is flexion) and y (negative is towards the thumb).
"""

from dataclasses import dataclass

import numpy as np

from ...model import FloatArray
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
    shortest_rotation,
    to_rotation_vector,
)

LOWEST_DEG: FloatArray = np.array([-80.0, -20.0, -80.0])
HIGHEST_DEG: FloatArray = np.array([80.0, 30.0, 70.0])
"""Limits of the twist, of the bend about y (20° towards the thumb, 30° away) and about z (80° flexion, 70°
extension)."""

_LOWEST, _HIGHEST = np.radians(LOWEST_DEG), np.radians(HIGHEST_DEG)
_BEND: FloatArray = np.array([0.0, 1.0, 1.0])
_FINGERS: FloatArray = np.array([1.0, 0.0, 0.0])
_PALM: FloatArray = np.array([0.0, -1.0, 0.0])


@dataclass(frozen=True, slots=True, eq=False)
class WristAngles:
    """The `angles` (…, 3) of a hand relative to its forearm: twist, bend about y, bend about z."""

    angles: FloatArray

    @property
    def forearm(self) -> FloatArray:
        """The rotation of the forearm's twist."""
        return from_axis_angle((1.0, 0.0, 0.0), self.angles[..., 0])

    @property
    def hand(self) -> FloatArray:
        """The rotation of the hand's bend."""
        return from_rotation_vector(self.angles * _BEND)

    @property
    def excess(self) -> FloatArray:
        """By how much each angle exceeds its limits (…, 3)."""
        return np.asarray(np.abs(self.angles - self.clamped().angles))

    def clamped(self) -> "WristAngles":
        """The angles clamped to the limits."""
        return WristAngles(clipped(self.angles, _LOWEST, _HIGHEST))


def wrist_angles(forearm: FloatArray, finger_base: FloatArray | None, palm: FloatArray | None) -> WristAngles:
    """The angles that point fingers and palm in the given directions (3,), for an untwisted forearm orientation (…, 4).

    Without a finger base the hand stays in line with the forearm; without a palm there is no twist.
    """
    if finger_base is None and palm is None:
        return WristAngles(np.zeros((*forearm.shape[:-1], 3)))
    back = inverse(forearm)
    if palm is None:
        return _parted(shortest_rotation(_FINGERS, rotate(back, np.asarray(finger_base))))
    ahead = _FINGERS if finger_base is None else rotate(back, finger_base)
    return _parted(_held(ahead, rotate(back, palm)))


def preserving_wrist_angles(forearm: FloatArray, hand: FloatArray) -> WristAngles:
    """The angles that preserve a hand's orientation `hand` (…, 4), for an untwisted forearm orientation (…, 4)."""
    return _parted(multiply(inverse(forearm), hand))


def _held(fingers: FloatArray, palm: FloatArray) -> FloatArray:
    """The orientation of a hand by the directions of fingers and palm; the palm yields where they are not
    orthogonal."""
    fingers = fingers / length(fingers)
    back_of_hand = dot(palm, fingers) * fingers - palm
    size = length(back_of_hand)
    back_of_hand = np.where(size > 1e-6, back_of_hand / np.maximum(size, 1e-6), -_PALM)
    fingers = np.broadcast_to(fingers, back_of_hand.shape)
    return from_axes(fingers, back_of_hand, cross(fingers, back_of_hand))


def _parted(rotation: FloatArray) -> WristAngles:
    """A rotation as a twist about x, then a bend without any (swing-twist decomposition)."""
    twist = 2 * np.arctan2(rotation[..., 0], rotation[..., 3])
    twist -= (2 * np.pi) * (twist > np.pi)
    twist += (2 * np.pi) * (twist < -np.pi)
    angles = to_rotation_vector(multiply(from_axis_angle((-1.0, 0.0, 0.0), twist), rotation))
    angles[..., 0] = twist
    return WristAngles(angles)
