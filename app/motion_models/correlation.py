"""Similarity measures of two streams or two distributions (AHG §4)."""

import numpy as np

from ..model import FloatArray
from ..realizer.geometry.rotations import inverse, multiply, to_rotation_vector

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


def kinetic_energy(rotations: FloatArray, frame_s: float) -> FloatArray:
    """The sum over joints of squared angular velocities in rad²/s², of each frame but the first (AHG §4.4), of local
    rotations (frames × joints × 4)."""
    turned = to_rotation_vector(multiply(inverse(rotations[:-1]), rotations[1:]))
    energy: FloatArray = (turned**2).sum(axis=(1, 2)) / frame_s**2
    return energy


def energy_difference(one: FloatArray, other: FloatArray, frame_s: float) -> float:
    """The mean difference of the kinetic energies of two motions, frame by frame, in rad²/s² (AHG Fig. 4)."""
    return float(np.abs(kinetic_energy(one, frame_s) - kinetic_energy(other, frame_s)).mean())
