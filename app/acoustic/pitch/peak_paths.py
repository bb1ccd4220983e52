"""Peaks of a curve, and the best path through candidates from frame to frame (Viterbi)."""

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray


def is_peak(curves: FloatArray) -> NDArray[np.bool_]:
    """Whether each value is no less than its neighbours."""
    peak = np.ones(curves.shape, dtype=np.bool_)
    peak[:, 1:] &= curves[:, 1:] >= curves[:, :-1]
    peak[:, :-1] &= curves[:, :-1] >= curves[:, 1:]
    return peak


def peak_offsets(curves: FloatArray, columns: NDArray[np.intp]) -> FloatArray:
    """The offset, in columns (−½ to ½), of the vertex of the parabola through each peak and its neighbours."""
    width = curves.shape[1]
    rows = width * np.arange(len(curves))[:, None]
    beside = (np.maximum(columns - 1, 0), columns, np.minimum(columns + 1, width - 1))
    before, at, after = (curves.take(rows + each).astype(np.float64) for each in beside)
    curvature = before - 2 * at + after
    bent = curvature < 0
    offsets = np.where(bent, (before - after) / np.where(bent, 2 * curvature, 1.0), 0.0)
    return np.clip(offsets, -0.5, 0.5)


_BLOCK = 256


def best_path(gains: FloatArray, positions: FloatArray, price: float) -> NDArray[np.intp]:
    """The column of `gains` (frames × columns) in each frame on the best path; the first of equals.

    A transition between neighbouring frames costs `price` times the distance of the columns' `positions` (frames ×
    columns), at most `price`.
    """
    total = gains[0]
    origins = np.zeros(gains.shape, dtype=np.intp)
    for first in range(1, len(gains), _BLOCK):
        for frame, costs in enumerate(_step_costs(positions[first - 1 : first + _BLOCK], price), first):
            arrivals = total - costs
            origins[frame] = arrivals.argmax(axis=1)
            total = np.maximum.reduce(arrivals, axis=1) + gains[frame]
    path = np.empty(len(gains), dtype=np.intp)
    path[-1] = total.argmax()
    for frame in range(len(gains) - 1, 0, -1):
        path[frame - 1] = origins[frame, path[frame]]
    return path


def _step_costs(positions: FloatArray, price: float) -> FloatArray:
    """The cost of each transition from column i in frame t to j in t + 1 (frames - 1 × j × i)."""
    return price * np.minimum(np.abs(positions[1:, :, None] - positions[:-1, None, :]), 1.0)
