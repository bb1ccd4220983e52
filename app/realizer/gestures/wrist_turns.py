"""How a hand is held: finger base and palm as seen from the body → the forearm's twist and the hand's bend.

Conventions: the left arm's, angles in radians, whole arrays (…) at once. In the T-pose a hand's fingers run along its
x, the palm faces -y and the thumb z. A forearm's twist turns about its own x axis (pronation and supination; VRM has
one joint for it, the lower arm's); the hand bends about z (palm-wards is negative) and y (thumb-wards is negative).
"""

from dataclasses import dataclass

import numpy as np

from ...model import FloatArray
from ..geometry.rotations import (
    about,
    between,
    cross,
    dot,
    from_axes,
    from_rotation_vector,
    inverse,
    length,
    multiply,
    rotate,
    to_rotation_vector,
)

LOWEST_DEG: FloatArray = np.array([-80.0, -20.0, -80.0])
HIGHEST_DEG: FloatArray = np.array([80.0, 30.0, 70.0])
"""Limits of twist, of the bend about y (20 to the thumb, 30 away) and about z (80 to the palm, 70 back)."""

_FINGERS: FloatArray = np.array([1.0, 0.0, 0.0])
_PALM: FloatArray = np.array([0.0, -1.0, 0.0])


@dataclass(frozen=True, slots=True, eq=False)
class Turn:
    """A hand's `angles` (…, 3) against the forearm: twist, bend about y, bend about z."""

    angles: FloatArray

    @property
    def forearm(self) -> FloatArray:
        """The twist of the forearm about its own axis."""
        return about((1.0, 0.0, 0.0), self.angles[..., 0])

    @property
    def hand(self) -> FloatArray:
        """The hand's rotation, without twist."""
        return from_rotation_vector(self.angles * np.array([0.0, 1.0, 1.0]))

    @property
    def excess(self) -> FloatArray:
        """How far each angle is outside the limits (…, 3)."""
        return np.asarray(np.abs(self.angles - self.clamped().angles))

    def clamped(self) -> "Turn":
        """The same, within the limits."""
        return Turn(np.clip(self.angles, np.radians(LOWEST_DEG), np.radians(HIGHEST_DEG)))


def turned(forearm: FloatArray, finger_base: FloatArray | None, palm: FloatArray | None) -> Turn:
    """The turn that brings a hand's fingers and palm to the directions (3,), the untwisted forearm being (…, 4).

    Without a finger base the hand stays in line with the forearm; without a palm it takes no twist.
    """
    if finger_base is None and palm is None:
        return Turn(np.zeros((*forearm.shape[:-1], 3)))
    back = inverse(forearm)
    if palm is None:
        return _parted(between(_FINGERS, rotate(back, np.asarray(finger_base))))
    ahead = _FINGERS if finger_base is None else rotate(back, finger_base)
    return _parted(_held(ahead, rotate(back, palm)))


def kept(forearm: FloatArray, hand: FloatArray) -> Turn:
    """The turn that leaves a hand of the orientation `hand` (…, 4) as it is, the untwisted forearm being (…, 4)."""
    return _parted(multiply(inverse(forearm), hand))


def _held(fingers: FloatArray, palm: FloatArray) -> FloatArray:
    """The orientation of a hand by its directions; the palm gives way where they are not at right angles."""
    fingers = fingers / length(fingers)
    back_of_hand = dot(palm, fingers) * fingers - palm
    size = length(back_of_hand)
    back_of_hand = np.where(size > 1e-6, back_of_hand / np.maximum(size, 1e-6), -_PALM)
    fingers = np.broadcast_to(fingers, back_of_hand.shape)
    return from_axes(fingers, back_of_hand, cross(fingers, back_of_hand))


def _parted(rotation: FloatArray) -> Turn:
    """A rotation as a twist about x, then a bend without any (swing-twist decomposition)."""
    twist = 2 * np.arctan2(rotation[..., 0], rotation[..., 3])
    twist = np.where(twist > np.pi, twist - 2 * np.pi, np.where(twist < -np.pi, twist + 2 * np.pi, twist))
    bend = to_rotation_vector(multiply(about((-1.0, 0.0, 0.0), twist), rotation))
    return Turn(np.concatenate([twist[..., None], bend[..., 1:]], axis=-1))
