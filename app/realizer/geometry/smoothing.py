"""Low-pass filtering of curves by a Gaussian.

Conventions: curves are (T, …), a value a frame; before the first and after the last frame they are constant. Own code,
since importing scipy's filters takes longer than realizing a line.
"""

from functools import lru_cache

import numpy as np

from ...model import FloatArray

_WIDTHS = 4.0
"""Where the Gaussian is cut off, in standard deviations."""

_FEW_COLUMNS = 8
_BLOCK = 32
"""Frames at a time: more multiply more zeros, fewer take more calls."""
_IN_PLACE = 1920
"""Frames smoothed at a time where long motions are smoothed in place."""


def smoothed(values: FloatArray, width: float) -> FloatArray:
    """The curves (T, …), each frame the mean of its neighbours, weighted by a Gaussian with a standard deviation of
    `width` frames."""
    weights = _weights(width)
    around = _among(values, values[:1].repeat(len(weights) // 2, 0), values[len(values) :], len(weights) // 2)
    if around.shape[1] <= _FEW_COLUMNS:
        return np.stack([np.convolve(each, weights, "valid") for each in around.T], axis=-1).reshape(values.shape)
    return _by_blocks(around, width).reshape(values.shape)


def smooth(values: FloatArray, width: float) -> None:
    """The same in place, of many curves and with little memory, however long they are."""
    radius = len(_weights(width)) // 2
    before = values[:1].repeat(radius, 0)
    for first in range(0, len(values), _IN_PLACE):
        block, after = values[first : first + _IN_PLACE], values[first + _IN_PLACE : first + _IN_PLACE + radius]
        around = _among(block, before, after, radius)
        before = block[-radius:].copy()
        block[...] = _by_blocks(around, width).reshape(block.shape)


def _among(values: FloatArray, before: FloatArray, after: FloatArray, radius: int) -> FloatArray:
    """The curves (T + 2 × radius, C) with those before and after them, the last one repeated where more are needed."""
    last = (after if len(after) else values)[-1:].repeat(radius - len(after), 0)
    around = np.concatenate([before, values, after, last])
    return around.reshape(len(around), -1)


@lru_cache(maxsize=16)
def _weights(width: float) -> FloatArray:
    """The Gaussian, cut off. Cached; never mutated."""
    radius = int(_WIDTHS * width + 0.5)
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / width) ** 2)
    return np.asarray(weights / weights.sum())


@lru_cache(maxsize=16)
def _means(width: float) -> FloatArray:
    """The weights (frames, neighbours) of the neighbours of a block's frames. Cached; never mutated."""
    weights = _weights(width)
    means = np.zeros((_BLOCK, _BLOCK + len(weights) - 1))
    for row in range(_BLOCK):
        means[row, row : row + len(weights)] = weights
    return means


def _by_blocks(around: FloatArray, width: float) -> FloatArray:
    """The weighted means of `around` (T + 2 × radius, C), as products of matrices: with many columns, faster than one
    curve after the other."""
    means = _means(width)
    beyond = means.shape[1] - _BLOCK
    found = np.empty((len(around) - beyond, around.shape[1]))
    for first in range(0, len(found), _BLOCK):
        near = around[first : first + means.shape[1]]
        size = len(near) - beyond
        np.matmul(means[:size, : len(near)], near, out=found[first : first + size])
    return found
