"""One-dimensional Perlin gradient noise for idle movement (paper §3.8; Perlin 2002).

Conventions: lattice points are multiples of the period from time 0, where every channel is zero. Slopes depend only on
seed, channel and lattice point, so the noise at a time does not depend on which other times are requested. Values are
in [-1, 1].
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .easing import minimum_jerk

_LARGEST = 2.0**64
_GOLDEN = 0.618033988749895
"""Its multiples modulo 1 are spread evenly over [0, 1), however many there are."""


def perlin(
    times_s: FloatArray, *, frequency_hz: float, seed: int, channels: int = 1, in_step: bool = True
) -> FloatArray:
    """Smooth noise (T, channels) with `frequency_hz` lattice points per second.

    Slopes are blended by 6t⁵ - 15t⁴ + 10t³ (Perlin 2002), so the second derivative is continuous. Perlin takes slopes
    from a short permuted table; here an integer hash draws them uniformly from [-2, 2], without repetition. Unless
    `in_step`, channels have lattices shifted evenly against each other and are not all zero at once.
    """
    at = np.asarray(times_s, dtype=np.float64)[:, None] * frequency_hz
    if not in_step:
        at = at + np.arange(channels) * _GOLDEN % 1.0
    below = np.floor(at)
    first = int(below.min(initial=0))
    last = int(below.max(initial=0)) + 1
    slopes = _slopes(np.arange(first, last + 1), seed, channels)
    share = at - below
    row = (below - first).astype(np.int64)
    if in_step:
        left, right = (slopes.take(row[:, 0] + later, axis=0) for later in (0, 1))
    else:
        left, right = (slopes.take((row + later) * channels + np.arange(channels)) for later in (0, 1))
    left, right = left * share, right * (share - 1.0)
    return np.asarray(left + minimum_jerk(share) * (right - left))


def _slopes(points: NDArray[np.int64], seed: int, channels: int) -> FloatArray:
    """Slopes (points, channels), uniform in [-2, 2]."""
    hashed = _mixed(np.add(_of_channels(seed, channels), points.astype(np.uint64)[:, None]))
    return np.asarray(hashed / _LARGEST * 4.0 - 2.0)


@lru_cache(maxsize=1024)
def _of_channels(seed: int, channels: int) -> NDArray[np.uint64]:
    """Where the hash of each channel begins (channels,). Cached, since most lines have the same seed; never
    mutated."""
    start = np.full(1, seed & (2**64 - 1), dtype=np.uint64)
    return _mixed(np.asarray(_mixed(start) + np.arange(channels, dtype=np.uint64), dtype=np.uint64))


def _mixed(number: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """A bijective integer hash (SplitMix64; Steele, Lea & Flood 2014)."""
    number = number + np.uint64(0x9E3779B97F4A7C15)
    number = (number ^ (number >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    number = (number ^ (number >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return np.asarray(number ^ (number >> np.uint64(31)))
