"""Curves over time: minimum-jerk movement, from rest to rest (Flash & Hogan 1985), and low-pass filtering by a
Gaussian.

Conventions: times are seconds, (T,); a curve has a column for each quantity, (T, C), or any further axes, (T, …), a
value a frame. A filtered curve is constant before its first and after its last frame. The filter is our own code, since
importing scipy's takes longer than realizing a line.
"""

from functools import lru_cache

import numpy as np

from ...model import FloatArray

Bound = FloatArray | float | tuple[float, ...]

SHORTEST_S = 1e-3
"""The duration used for movements without one, so that no curve jumps."""


def clipped(values: FloatArray, lowest: Bound, highest: Bound) -> FloatArray:
    """`np.clip`, in half the time."""
    return np.minimum(np.maximum(values, lowest), highest)


def soft_maximum(one: FloatArray, other: FloatArray | float, softness: float) -> FloatArray:
    """The larger of both, rounded over some times `softness` about where they are equal: `softness` times
    `np.logaddexp` of both in units of it, in a quarter of the time."""
    apart = np.abs(one - other)
    return np.asarray(np.maximum(one, other) + softness * np.log1p(np.exp(apart / -softness)))


def minimum_jerk(share: FloatArray) -> FloatArray:
    """The share of the way covered after `share` of the time: 6t⁵ - 15t⁴ + 10t³, 0 before the start, 1 after the
    end."""
    return eased(clipped(share, 0.0, 1.0))


def eased(share: FloatArray) -> FloatArray:
    """`minimum_jerk` of shares that are in [0, 1]."""
    course = 6.0 * share
    course -= 15.0
    course *= share
    course += 10.0
    for _third in range(3):
        course *= share
    return np.asarray(course)


def superposed_movements(
    times_s: FloatArray, starts_s: FloatArray, durations_s: FloatArray, by: FloatArray
) -> FloatArray:
    """The sum (T, C) of lasting movements by `by` (K, C), in any order, at increasing `times_s`. A movement that starts
    before another has ended is superposed on it, as people do when a target jumps (Flash & Henis 1991), so velocity is
    continuous."""
    moving = by.any(axis=1) & (starts_s < times_s[-1])
    if not moving.any():
        return np.zeros((len(times_s), by.shape[1]))
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


def smoothed(values: FloatArray, width: float) -> FloatArray:
    """The curves (T, …), each frame the mean of its neighbours, weighted by a Gaussian with a standard deviation of
    `width` frames."""
    reach = reach_of(width)
    around = np.concatenate([values[:1].repeat(reach, 0), values, values[-1:].repeat(reach, 0)])
    around = around.reshape(len(around), -1)
    if around.shape[1] <= _FEW_COLUMNS:
        means = np.convolve(around.T.ravel(), _weights(width), "same").reshape(around.shape[::-1])
        return means[:, reach : reach + len(values)].T.reshape(values.shape)
    return means_around(around.T, width).T.reshape(values.shape)


def reach_of(width: float) -> int:
    """How many neighbours on either side a smoothed frame depends on."""
    return int(_WIDTHS * width + 0.5)


@lru_cache(maxsize=16)
def _weights(width: float) -> FloatArray:
    """The Gaussian, cut off. Cached; never mutated."""
    reach = reach_of(width)
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / width) ** 2)
    return np.asarray(weights / weights.sum())


@lru_cache(maxsize=16)
def _means(width: float) -> FloatArray:
    """The weights (neighbours, frames) of the neighbours of a block's frames. Cached; never mutated."""
    weights = _weights(width)
    means = np.zeros((_BLOCK + len(weights) - 1, _BLOCK))
    for frame in range(_BLOCK):
        means[frame : frame + len(weights), frame] = weights
    return means


def means_around(around: FloatArray, width: float) -> FloatArray:
    """`smoothed` curves (C, T), given also their neighbours before and after (C, T + 2 × `reach_of`), as products of
    matrices: with many curves, faster than one after the other."""
    means = _means(width)
    beyond = len(means) - _BLOCK
    found = np.empty((len(around), around.shape[1] - beyond))
    for first in range(0, found.shape[1], _BLOCK):
        near = around[:, first : first + len(means)]
        size = near.shape[1] - beyond
        np.matmul(near, means[: near.shape[1], :size], out=found[:, first : first + size])
    return found
