"""Stretches of frames: runs of those in which something is true, and what is near them.

Conventions: booleans (T,) for each frame; a stretch is its first frame and the frame past its last.
"""

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray


def frames_in(times_s: FloatArray, time_s: float) -> int:
    """The number of frames in a time, at least one."""
    rate_hz = (len(times_s) - 1) / max(times_s[-1] - times_s[0], 1e-9)
    return max(1, round(time_s * float(rate_hz)))


def around(inside: NDArray[np.bool_], frames: int) -> NDArray[np.bool_]:
    """Frames within `frames` of one that is inside."""
    return np.convolve(inside, np.ones(2 * frames + 1), mode="full")[frames : frames + len(inside)] > 0


def stretches(inside: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The first frame and the frame past the last of each run of true values: (n, 2)."""
    padded = np.concatenate([[False], inside, [False]])
    return np.nonzero(padded[1:] != padded[:-1])[0].reshape(-1, 2)
