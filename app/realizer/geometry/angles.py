"""Rotations as pitch, yaw and roll.

Conventions: radians. Positive `pitch` looks down (about x), `yaw` to the character's left (about y), `roll` tilts to
the character's right (about z); roll is applied first, yaw last. A direction is a vector; (0, 0, 1) is straight ahead.
"""

import numpy as np

from ...model import FloatArray


def from_pitch_yaw_roll(pitch: FloatArray, yaw: FloatArray, roll: FloatArray) -> FloatArray:
    """The rotations (…, 4) by `roll`, then `pitch`, then `yaw`."""
    sx, cx = np.sin(pitch / 2), np.cos(pitch / 2)
    sy, cy = np.sin(yaw / 2), np.cos(yaw / 2)
    sz, cz = np.sin(roll / 2), np.cos(roll / 2)
    both, pitched, rolled, neither = sx * sz, sx * cz, cx * sz, cx * cz
    turned = np.empty((*both.shape, 4))
    turned[..., 0] = cy * pitched + sy * rolled
    turned[..., 1] = sy * neither - cy * both
    turned[..., 2] = cy * rolled - sy * pitched
    turned[..., 3] = cy * neither + sy * both
    return turned


def to_pitch_yaw_roll(q: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Pitch, yaw and roll of the rotations (…, 4); pitch lies in [-π/2, π/2]."""
    x, y, z, w = (q[..., k] for k in range(4))
    pitch = np.arcsin(np.clip(2 * (w * x - y * z), -1.0, 1.0))
    yaw = np.arctan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y))
    roll = np.arctan2(2 * (w * z + x * y), 1 - 2 * (x * x + z * z))
    return pitch, yaw, roll


def pitch_and_yaw(direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Pitch and yaw of the directions (…, 3), of any length."""
    x, y, z = (direction[..., k] for k in range(3))
    return np.arctan2(-y, np.hypot(x, z)), np.arctan2(x, z)


def unit_vector(pitch: FloatArray, yaw: FloatArray) -> FloatArray:
    """The unit vectors (…, 3) with this pitch and yaw."""
    return np.stack([np.cos(pitch) * np.sin(yaw), -np.sin(pitch), np.cos(pitch) * np.cos(yaw)], axis=-1)
