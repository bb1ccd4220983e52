"""Curves over time: minimum-jerk movement, from rest to rest (Flash & Hogan 1985), and low-pass filtering by a
Gaussian.

Conventions: times are seconds, (T,); a curve has a column for each quantity, (T, C), or any further axes, (T, …), a
value a frame. A filtered curve is constant before its first and after its last frame. The filter is our own code, since
importing scipy's takes longer than realizing a line.
"""

from functools import lru_cache

import numpy as np

from ...model import FloatArray

SHORTEST_S = 1e-3
"""The duration used for movements without one, so that no curve jumps."""


def minimum_jerk(share: FloatArray) -> FloatArray:
    """The share of the way covered after `share` of the time: 6t⁵ - 15t⁴ + 10t³, 0 before the start, 1 after the
    end."""
    share = np.minimum(np.maximum(share, 0.0), 1.0)
    return np.asarray(share * share * share * (10.0 + share * (6.0 * share - 15.0)))


def superposed_movements(
    times_s: FloatArray, starts_s: FloatArray, durations_s: FloatArray, by: FloatArray
) -> FloatArray:
    """The sum (T, C) of lasting movements by `by` (K, C), in any order, at increasing `times_s`. A movement that starts
    before another has ended is superposed on it, as people do when a target jumps (Flash & Henis 1991), so velocity is
    continuous."""
    moving = by.any(axis=1) & (starts_s < times_s[-1])
    starts_s, durations_s, by = starts_s[moving], np.maximum(durations_s[moving], SHORTEST_S), by[moving]
    firsts, ends = times_s.searchsorted(starts_s), times_s.searchsorted(starts_s + durations_s)
    over = np.zeros((len(times_s) + 1, by.shape[1]))
    np.add.at(over, ends, by)
    course = over[:-1].cumsum(axis=0)
    counts = ends - firsts
    begins = counts.cumsum() - counts
    of = np.arange(len(counts)).repeat(counts)
    frames = np.arange(len(of)) + (firsts - begins).take(of)
    shares = minimum_jerk((times_s.take(frames) - starts_s.take(of)) / durations_s.take(of))
    made = shares[:, None] * by.take(of, axis=0)
    for first, end, begin in zip(firsts.tolist(), ends.tolist(), begins.tolist(), strict=True):
        course[first:end] += made[begin : begin + end - first]
    return np.asarray(course)


def minimum_jerk_through(times_s: FloatArray, at_s: FloatArray, values: FloatArray) -> FloatArray:
    """The curve (T,) that comes to rest at each of `values` (K,) at the increasing times `at_s` (K,), constant before
    and after."""
    if len(at_s) == 1:
        return np.full(len(times_s), values[0])
    return np.asarray(
        values[0] + superposed_movements(times_s, at_s[:-1], np.diff(at_s), np.diff(values)[:, None])[:, 0]
    )


def plateau(times_s: FloatArray, start_s: float, reached_s: float, left_s: float, end_s: float) -> FloatArray:
    """The curve that is 0 at `start_s`, 1 from `reached_s` to `left_s`, and 0 at `end_s`."""
    rise = minimum_jerk((times_s - start_s) / max(reached_s - start_s, SHORTEST_S))
    fall = minimum_jerk((times_s - left_s) / max(end_s - left_s, SHORTEST_S))
    return np.asarray(rise * (1.0 - fall))


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
