"""Reduces the frames of a track to the few keys that an animator edits, within a stated error.

Ramer, Douglas and Peucker's method over time: a stretch between two keys is split at the frame that is furthest from
what players interpolate there, until none is further than the tolerance. Rotations are interpolated along the shorter
arc (slerp) and their distance is an angle; everything else is interpolated linearly, its distance the largest of its
components'. All stretches are measured together, so that ten minutes take seconds.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..geometry.rotations import dot, normalized

ROTATION_DEG, PLACE_M, WEIGHT = 0.25, 0.001, 0.02
"""The tolerances: of each joint's rotation, of the hips' position and of the face's weights."""

Distance = Callable[[FloatArray, FloatArray, FloatArray, FloatArray], FloatArray]
"""From the values of frames, those of the keys before and after, and the share of the way, to the frames' errors."""


def rotation_keys(rotations: FloatArray, tolerance_rad: float) -> NDArray[np.intp]:
    """The frames that are kept of the rotations (T, 4), with continuous signs."""
    return _kept(rotations, tolerance_rad, _angles)


def value_keys(values: FloatArray, tolerance: float) -> NDArray[np.intp]:
    """The frames that are kept of the values (T, N)."""
    return _kept(values, tolerance, _differences)


def _kept(values: FloatArray, tolerance: float, distance: Distance) -> NDArray[np.intp]:
    """The kept frames in order: the first, the last and those between that are needed."""
    keys = np.unique([0, len(values) - 1])
    open_ends = keys[1:]
    while len(open_ends):
        starts = keys[np.searchsorted(keys, open_ends) - 1]
        frames, stretch = _inside(starts, open_ends)
        if not len(frames):
            break
        share = (frames - starts[stretch]) / (open_ends - starts)[stretch]
        apart = distance(values[frames], values[starts[stretch]], values[open_ends[stretch]], share)
        worst = _furthest(apart, stretch, len(starts))
        split = worst[apart[worst] > tolerance]
        new = frames[split]
        open_ends = np.sort(np.concatenate([new, open_ends[stretch[split]]]))
        keys = np.sort(np.concatenate([keys, new]))
    return keys


def _inside(starts: NDArray[np.intp], ends: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The frames strictly inside each stretch, and the stretch of each."""
    counts = ends - starts - 1
    stretch = np.repeat(np.arange(len(starts)), counts)
    firsts = np.cumsum(counts) - counts
    return starts[stretch] + 1 + np.arange(len(stretch)) - firsts[stretch], stretch


def _furthest(apart: FloatArray, stretch: NDArray[np.intp], count: int) -> NDArray[np.intp]:
    """The index into `apart` of the largest error of each stretch that has any frame."""
    order = np.lexsort((apart, stretch))
    last = np.searchsorted(stretch[order], np.arange(count), side="right") - 1
    has_frames = np.bincount(stretch, minlength=count) > 0
    return order[last[has_frames]]


def _angles(values: FloatArray, before: FloatArray, after: FloatArray, share: FloatArray) -> FloatArray:
    cosine = dot(before, after)
    after, cosine = np.where(cosine < 0, -after, after), np.minimum(np.abs(cosine), 1.0)
    angle, share = np.arccos(cosine), share[:, None]
    small = angle < 1e-6
    sine = np.where(small, 1.0, np.sin(angle))
    first = np.where(small, 1 - share, np.sin((1 - share) * angle) / sine)
    second = np.where(small, share, np.sin(share * angle) / sine)
    between = normalized(first * before + second * after)
    chord = np.minimum(np.linalg.norm(values - between, axis=-1), np.linalg.norm(values + between, axis=-1))
    return np.asarray(4 * np.arcsin(np.minimum(chord / 2, 1.0)))


def _differences(values: FloatArray, before: FloatArray, after: FloatArray, share: FloatArray) -> FloatArray:
    between = before + share[:, None] * (after - before)
    return np.asarray(np.abs(values - between).max(axis=-1))
