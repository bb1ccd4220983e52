"""Low-pass filtering of curves by a Gaussian.

Conventions: curves are (T, …), a value a frame; before the first and after the last frame they are constant. Own code,
since importing scipy's filters takes longer than realizing a line.
"""

import numpy as np

from ...model import FloatArray

_WIDTHS = 4.0
"""Where the Gaussian is cut off, in standard deviations."""

_FEW_COLUMNS = 8
_BLOCK = 200


def smoothed(values: FloatArray, width: float) -> FloatArray:
    """The curves (T, …), each frame the mean of its neighbours, weighted by a Gaussian with a standard deviation of
    `width` frames."""
    radius = int(_WIDTHS * width + 0.5)
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / width) ** 2)
    weights /= weights.sum()
    if values[0].size <= _FEW_COLUMNS:
        columns = _frames(values, -radius, len(values) + radius).reshape(len(values) + 2 * radius, -1).T
        return np.stack([np.convolve(column, weights, "valid") for column in columns], axis=-1).reshape(values.shape)
    return _sum_of_shifted(values, weights)


def _frames(values: FloatArray, first: int, past: int) -> FloatArray:
    """The frames from `first` to `past`; those before the first and after the last are like these."""
    return values[np.clip(np.arange(first, past), 0, len(values) - 1)]


def _sum_of_shifted(values: FloatArray, weights: FloatArray) -> FloatArray:
    """The weighted sum of shifted arrays: with many columns, faster than one curve after the other. In blocks, which
    stay in the processor's cache."""
    radius = len(weights) // 2
    found = weights[radius] * values
    for first in range(0, len(values), _BLOCK):
        block = found[first : first + _BLOCK]
        near = _frames(values, first - radius, first + len(block) + radius)
        for shift in range(1, radius + 1):
            pair = near[radius - shift :][: len(block)] + near[radius + shift :][: len(block)]
            pair *= weights[radius + shift]
            block += pair
    return np.asarray(found)
