"""The path of greatest gain through a row of frames, each step at its cost (Viterbi)."""

import numpy as np
from numpy.typing import NDArray

from app.model import FloatArray


def best_path(gains: FloatArray, step_costs: FloatArray) -> NDArray[np.intp]:
    """Which column of `gains` (frames × columns) to take in each frame; the first of equals.

    `step_costs[t, j, i]` is the cost of going from column i in frame t to j in t + 1.
    """
    total = gains[0]
    origins = np.zeros(gains.shape, dtype=np.intp)
    for frame in range(1, len(gains)):
        arrivals = total - step_costs[frame - 1]
        origins[frame] = arrivals.argmax(axis=1)
        total = arrivals.max(axis=1) + gains[frame]
    path = np.empty(len(gains), dtype=np.intp)
    path[-1] = total.argmax()
    for frame in range(len(gains) - 1, 0, -1):
        path[frame - 1] = origins[frame, path[frame]]
    return path
