"""Similarity measures of two streams or two distributions (AHG §4)."""

import numpy as np

from ..model import FloatArray

LEAST_SHARE = 1e-6
"""Directions of a stream with a smaller share of its largest deviation are ignored."""

ADDED = 1e-4
"""Added to every share before a divergence, so that none is 0."""


def canonical_correlation(one: FloatArray, other: FloatArray) -> float:
    """The first canonical correlation of two streams (frames × features each): the largest correlation between a
    linear combination of the features of one and one of the other. 0 if either is constant."""
    bases = [_directions(stream) for stream in (one, other)]
    if not all(basis.shape[1] for basis in bases):
        return 0.0
    return float(min(1.0, np.linalg.svd(bases[0].T @ bases[1], compute_uv=False)[0]))


def _directions(stream: FloatArray) -> FloatArray:
    """An orthonormal basis of the variation of a stream (frames × directions)."""
    stream = np.asarray(stream, dtype=np.float64)
    left, sizes, _ = np.linalg.svd(stream - stream.mean(axis=0), full_matrices=False)
    kept: FloatArray = left[:, sizes > LEAST_SHARE * max(sizes.max(initial=0.0), 1e-12)]
    return kept


def symmetric_divergence(one: FloatArray, other: FloatArray) -> float:
    """The symmetric Kullback-Leibler divergence of two distributions in nats, the sum of both directions; `ADDED` is
    added to every share."""
    shares = [(each + ADDED) / (each + ADDED).sum() for each in (one, other)]
    return float(((shares[0] - shares[1]) * np.log(shares[0] / shares[1])).sum())


def kinetic_energy(angles: FloatArray, frame_s: float) -> FloatArray:
    """The sum of squared angular velocities of each frame except the first (AHG §4.4); `angles` is frames × angles."""
    energy: FloatArray = (np.diff(angles, axis=0) ** 2).sum(axis=1) / frame_s**2
    return energy


def energy_difference(one: FloatArray, other: FloatArray, frame_s: float) -> float:
    """The mean difference of the kinetic energies of two streams of angles, frame by frame (AHG Fig. 4)."""
    return float(np.abs(kinetic_energy(one, frame_s) - kinetic_energy(other, frame_s)).mean())
