"""Finds peaks along the rows of a table; at the edges, the missing neighbour equals the edge value."""

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
