"""Low-pass filtering of curves by a Gaussian.

Conventions: curves are (T, …), a value a frame; before the first and after the last frame they are constant. Own code,
since importing scipy's filters takes longer than realizing a line.
"""

import numpy as np

from ...model import FloatArray

_WIDTHS = 4.0
"""Where the Gaussian is cut off, in standard deviations."""

_FEW_COLUMNS = 8


def smoothed(values: FloatArray, width: float) -> FloatArray:
    """The curves (T, …), each frame the mean of its neighbours, weighted by a Gaussian with a standard deviation of
    `width` frames."""
    radius = int(_WIDTHS * width + 0.5)
    weights = np.exp(-0.5 * (np.arange(-radius, radius + 1) / width) ** 2)
    weights /= weights.sum()
    padded = np.concatenate([np.repeat(values[:1], radius, axis=0), values, np.repeat(values[-1:], radius, axis=0)])
    if values[0].size <= _FEW_COLUMNS:
        columns = padded.reshape(len(padded), -1).T
        return np.stack([np.convolve(column, weights, "valid") for column in columns], axis=-1).reshape(values.shape)
    return _sum_of_shifted(values, padded, weights)


def _sum_of_shifted(values: FloatArray, padded: FloatArray, weights: FloatArray) -> FloatArray:
    """The weighted sum of whole shifted arrays: with many columns, faster than one curve after the other."""
    frames, radius = len(values), len(weights) // 2
    found = weights[radius] * values
    pair = np.empty_like(found)
    for shift in range(1, radius + 1):
        np.add(padded[radius - shift :][:frames], padded[radius + shift :][:frames], out=pair)
        pair *= weights[radius + shift]
        found += pair
    return np.asarray(found)
