"""Peaks along the rows of a table whose columns are samples of a curve."""

import numpy as np
from numpy.typing import NDArray

from app.model import FloatArray


def peak_offsets(strengths: FloatArray, columns: NDArray[np.intp]) -> FloatArray:
    """How far beside its column, in columns (−½ to ½), the parabola through a peak and its neighbours is highest."""
    before, at, after = (
        np.take_along_axis(values, columns, axis=1)
        for values in (neighbours(strengths)[0], strengths, neighbours(strengths)[1])
    )
    curvature = before - 2 * at + after
    bent = curvature < 0
    offsets = np.where(bent, (before - after) / np.where(bent, 2 * curvature, 1.0), 0.0)
    return np.clip(offsets, -0.5, 0.5)


def neighbours(strengths: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The values one column before and one after, an edge being its own neighbour."""
    padded = np.pad(strengths, ((0, 0), (1, 1)), mode="edge")
    return padded[:, :-2], padded[:, 2:]
