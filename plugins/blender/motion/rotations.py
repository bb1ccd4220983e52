"""Rotations as matrices (…, 3, 3) that turn column vectors, and as quaternions (…, 4) in Blender's order w x y z."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.floating[Any]]


def matrices(quaternions: Array) -> Array:
    """The matrices of unit quaternions (…, 4)."""
    w, x, y, z = np.moveaxis(quaternions, -1, 0)
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def quaternions(turns: Array) -> Array:
    """Unit quaternions (T, 4) of matrices (T, 3, 3), each on the side of the one before.

    Of the four ways to find one, each frame takes that which divides by the largest part, so that none is near 0.
    """
    diagonal = np.stack([turns[:, k, k] for k in range(3)], axis=-1)
    trace = diagonal.sum(axis=-1)
    squares = 1 + np.concatenate([trace[:, None], 2 * diagonal - trace[:, None]], axis=1)
    found = np.empty((len(turns), 4))
    for largest in range(4):
        chosen = squares.argmax(axis=1) == largest
        found[chosen] = _by_part(turns[chosen], largest)
    found /= np.linalg.norm(found, axis=1, keepdims=True)
    return with_continuous_signs(found)


def with_continuous_signs(values: Array) -> Array:
    """The same rotations; each of the quaternions (T, 4) is the one of its two that is nearer to the one before."""
    flips = np.where(np.einsum("ij,ij->i", values[1:], values[:-1]) < 0, -1.0, 1.0)
    signed: Array = values * np.concatenate([[1.0], np.cumprod(flips)])[:, None]
    return signed


def shortest(start: Array, end: Array) -> Array:
    """The smallest rotation (3, 3) that turns the direction `start` (3) to that of `end`; of opposite ones, the half
    turn about any axis across."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    axis, cosine = np.cross(start, end), float(start @ end)
    if cosine < -1 + 1e-9:
        axis = np.cross(start, np.eye(3)[np.abs(start).argmin()])
        return 2 * np.outer(axis, axis) / (axis @ axis) - np.eye(3)
    skew = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    turn: Array = np.eye(3) + skew + skew @ skew / (1 + cosine)
    return turn


def frame(first: Array, second: Array) -> Array:
    """Orthogonal axes (3, 3) as columns: `first`, the part of `second` across it, and what is across both."""
    one = first / np.linalg.norm(first)
    two = second - one * (one @ second)
    two /= np.linalg.norm(two)
    return np.stack([one, two, np.cross(one, two)], axis=1)


def _by_part(m: Array, largest: int) -> Array:
    """Quaternions, not yet of length 1, whose part number `largest` is the largest."""
    a, b, c = m[:, 2, 1] - m[:, 1, 2], m[:, 0, 2] - m[:, 2, 0], m[:, 1, 0] - m[:, 0, 1]
    d, e, f = m[:, 1, 0] + m[:, 0, 1], m[:, 0, 2] + m[:, 2, 0], m[:, 2, 1] + m[:, 1, 2]
    x, y, z = m[:, 0, 0], m[:, 1, 1], m[:, 2, 2]
    parts = (
        (1 + x + y + z, a, b, c),
        (a, 1 + x - y - z, d, e),
        (b, d, 1 - x + y - z, f),
        (c, e, f, 1 - x - y + z),
    )[largest]
    return np.stack(parts, axis=-1)
