"""The few keys of a curve that an animator edits, instead of one in every frame.

Ramer, Douglas and Peucker's method over time: a stretch between two keys is split at the frame that is furthest from
the straight line between them, until none is further than a tolerance. All values of a property (the four of a
quaternion) have their keys in the same frames. Quaternions are interpolated as Blender does it, component by component;
their distance is the angle between what is interpolated and what was.
"""

from collections.abc import Callable

import numpy as np

from .rotations import Array

ROTATION_RAD, PLACE, WEIGHT = 0.25 * np.pi / 180, 0.001, 0.01
"""Tolerances of rotations, of places (metres, where the armature is) and of the weights of shape keys."""

Distances = Callable[[Array, Array], Array]


def rotation_frames(quaternions: Array) -> list[int]:
    """The frames of quaternions (T, 4), with continuous signs, that are kept."""
    return kept_frames(quaternions, ROTATION_RAD, _angles)


def value_frames(values: Array, tolerance: float) -> list[int]:
    """The frames of values (T, N) that are kept."""
    return kept_frames(values, tolerance, _largest)


def kept_frames(values: Array, tolerance: float, distances: Distances) -> list[int]:
    """The frames that are kept, in order: the first, the last and those that are needed between."""
    kept, open_stretches = {0, len(values) - 1}, [(0, len(values) - 1)]
    while open_stretches:
        first, last = open_stretches.pop()
        if last - first < 2:
            continue
        share = ((np.arange(first + 1, last) - first) / (last - first))[:, None]
        apart = distances(values[first + 1 : last], values[first] * (1 - share) + values[last] * share)
        worst = int(apart.argmax())
        if apart[worst] > tolerance:
            split = first + 1 + worst
            kept.add(split)
            open_stretches += [(first, split), (split, last)]
    return sorted(kept)


def _angles(ours: Array, between: Array) -> Array:
    lengths = np.linalg.norm(ours, axis=1) * np.linalg.norm(between, axis=1)
    cosines = np.abs(np.einsum("ij,ij->i", ours, between)) / np.maximum(lengths, 1e-12)
    angles: Array = 2 * np.arccos(np.clip(cosines, 0, 1))
    return angles


def _largest(ours: Array, between: Array) -> Array:
    largest: Array = np.abs(ours - between).max(axis=1)
    return largest
