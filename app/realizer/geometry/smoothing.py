"""Low-pass filtering of curves by a Gaussian.

Conventions: curves are (T, …), a value a frame; before the first and after the last frame they are constant. Own code,
since importing scipy's filters takes longer than realizing a line.
"""

import numpy as np

from ...model import FloatArray

_WIDTHS = 4.0
"""Where the Gaussian is cut off, in standard deviations."""

_FEW_COLUMNS = 8
_BLOCK = 48
"""Frames at a time: more multiply more zeros, fewer take more calls."""


def smoothed(values: FloatArray, width: float) -> FloatArray:
    """The curves (T, …), each frame the mean of its neighbours, weighted by a Gaussian with a standard deviation of
    `width` frames."""
    radius = int(_WIDTHS * width + 0.5)
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / width) ** 2)
    weights /= weights.sum()
    around = np.concatenate([values[:1].repeat(radius, 0), values, values[-1:].repeat(radius, 0)])
    around = around.reshape(len(around), -1)
    if around.shape[1] <= _FEW_COLUMNS:
        return np.stack([np.convolve(each, weights, "valid") for each in around.T], axis=-1).reshape(values.shape)
    return _by_blocks(around, weights).reshape(values.shape)


def _by_blocks(around: FloatArray, weights: FloatArray) -> FloatArray:
    """The weighted means of `around` (T + 2 × radius, C), as products of matrices: with many columns, faster than one
    curve after the other."""
    frames = len(around) - len(weights) + 1
    found = np.empty((frames, around.shape[1]))
    means = np.zeros((_BLOCK, _BLOCK + len(weights) - 1))
    for row in range(_BLOCK):
        means[row, row : row + len(weights)] = weights
    for first in range(0, frames, _BLOCK):
        near = around[first : first + means.shape[1]]
        size = len(near) - len(weights) + 1
        np.matmul(means[:size, : len(near)], near, out=found[first : first + size])
    return found
