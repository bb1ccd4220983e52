"""The path of greatest gain through a row of frames, each step at its cost (Viterbi)."""

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray

_BLOCK = 256


def best_path(gains: FloatArray, positions: FloatArray, price: float) -> NDArray[np.intp]:
    """Which column of `gains` (frames × columns) to take in each frame; the first of equals.

    A step between neighbouring frames costs `price` times the distance of the columns' `positions` (frames × columns),
    and no more than `price`.
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
    """What each step costs, from column i in frame t to j in t + 1 (frames - 1 × j × i)."""
    return price * np.minimum(np.abs(positions[1:, :, None] - positions[:-1, None, :]), 1.0)
