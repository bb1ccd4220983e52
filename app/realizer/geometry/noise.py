"""One-dimensional Perlin gradient noise for idle movement (paper §3.8; Perlin 2002).

Conventions: lattice points are multiples of the period from time 0, where every channel is zero. Slopes depend only on
seed, channel and lattice point, so the noise at a time does not depend on which other times are requested. Values are
in [-1, 1].
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .curves import eased

_LARGEST = 2.0**64
_GOLDEN = 0.618033988749895
"""Its multiples modulo 1 are spread evenly over [0, 1), however many there are."""
_KNOWN = 64
"""The points of a lattice whose slopes are kept: those of half a minute to a minute and a half."""


@dataclass(frozen=True, slots=True)
class Noise:
    """Channels of noise with `frequency_hz` lattice points per second. Unless `in_step`, they have lattices shifted
    evenly against each other and are not all zero at once."""

    frequency_hz: float
    seed: int
    channels: int = 1
    in_step: bool = True


def perlin(
    times_s: FloatArray, *, frequency_hz: float, seed: int, channels: int = 1, in_step: bool = True
) -> FloatArray:
    """Smooth noise (T, channels); see `Noise` and `perlins`."""
    return perlins(times_s, Noise(frequency_hz, seed, channels, in_step))


def perlins(times_s: FloatArray, *kinds: Noise) -> FloatArray:
    """The channels (T, C) of several kinds of noise, one after the other; together they cost little more than one.

    Slopes are blended by 6t⁵ - 15t⁴ + 10t³ (Perlin 2002), so the second derivative is continuous. Perlin takes slopes
    from a short permuted table; here an integer hash draws them uniformly from [-2, 2], without repetition.
    """
    lattice = _lattice(kinds)
    at = np.asarray(times_s, dtype=np.float64)[:, None] * lattice.frequency_hz
    at += lattice.shift
    below = np.floor(at)
    first = int(below.min(initial=0))
    last = int(below.max(initial=0)) + 1
    slopes = lattice.slopes_of(first, last)
    share = at - below
    row = (below - first).astype(np.int64)
    if row.shape[1] == 1:
        left, right = (slopes.take(row[:, 0] + later, axis=0) for later in (0, 1))
    else:
        row *= slopes.shape[1]
        row += np.arange(slopes.shape[1])
        left, right = slopes.take(row), slopes[1:].take(row)
    left *= share
    right *= share - 1.0
    right -= left
    right *= eased(share)
    left += right
    return left


@dataclass(frozen=True, slots=True, eq=False)
class _Lattice:
    """Lattice points per second and shift of each channel (C,), or (1,) where they are the same for all; where the hash
    of each channel begins (C,), and the slopes (`_KNOWN`, C) at the points from 0 on."""

    frequency_hz: FloatArray
    shift: FloatArray
    hashed: NDArray[np.uint64]
    known: FloatArray

    def slopes_of(self, first: int, last: int) -> FloatArray:
        """Slopes (points, C) at the lattice points from the first to the last."""
        if first >= 0 and last < _KNOWN:
            return self.known[first : last + 1]
        return _slopes(np.arange(first, last + 1), self.hashed)


@lru_cache(maxsize=64)
def _lattice(kinds: tuple[Noise, ...]) -> _Lattice:
    """Cached, since most lines have the same seed; few, since every live stream has its own. Never mutated."""
    frequency_hz = np.concatenate([np.full(kind.channels, kind.frequency_hz) for kind in kinds])
    shift = np.concatenate([np.arange(kind.channels) * _GOLDEN % 1.0 * (not kind.in_step) for kind in kinds])
    hashed = np.concatenate([_of_channels(kind.seed, kind.channels) for kind in kinds])
    if not shift.any() and (frequency_hz == frequency_hz[0]).all():
        frequency_hz, shift = frequency_hz[:1], shift[:1]
    return _Lattice(frequency_hz, shift, hashed, _slopes(np.arange(_KNOWN), hashed))


def _slopes(points: NDArray[np.int64], hashed: NDArray[np.uint64]) -> FloatArray:
    """Slopes (points, channels), uniform in [-2, 2]."""
    found = _mixed(np.add(hashed, points.astype(np.uint64)[:, None]))
    return np.asarray(found * (4.0 / _LARGEST) - 2.0)


def _of_channels(seed: int, channels: int) -> NDArray[np.uint64]:
    start = np.full(1, seed & (2**64 - 1), dtype=np.uint64)
    return _mixed(np.asarray(_mixed(start) + np.arange(channels, dtype=np.uint64), dtype=np.uint64))


def _mixed(number: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """A bijective integer hash (SplitMix64; Steele, Lea & Flood 2014)."""
    number = number + np.uint64(0x9E3779B97F4A7C15)
    number = (number ^ (number >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    number = (number ^ (number >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return np.asarray(number ^ (number >> np.uint64(31)))
