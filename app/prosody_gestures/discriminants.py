"""Linear discriminant analysis (Fisher): the mixtures with diagonal covariance are fitted to its projections.

AHG §3.4 uses the first two principal components, which ignore the states; discriminants separate the states and are
uncorrelated within them, as diagonal mixtures assume.
"""

from dataclasses import dataclass

import numpy as np

from ..model import FloatArray
from .semi_markov import IntArray

RIDGE = 1e-3
"""Added to the within-state variances of the standardised features."""


@dataclass(frozen=True, slots=True, eq=False)
class Discriminants:
    """`mean` and `scale` (features) standardise, `weights` (features × directions) project."""

    mean: FloatArray
    scale: FloatArray
    weights: FloatArray

    def project(self, rows: FloatArray) -> FloatArray:
        """The projections (… × directions) of rows (… × features)."""
        projected: FloatArray = (rows - self.mean) / self.scale @ self.weights
        return projected


def fit_discriminants(rows: FloatArray, states: IntArray) -> Discriminants:
    """Fits one direction fewer than there are states, the most discriminative first, to rows (frames × features)."""
    mean, scale = rows.mean(axis=0), rows.std(axis=0) + 1e-9
    standard = (rows - mean) / scale
    kinds = np.unique(states)
    within = RIDGE * np.eye(rows.shape[1])
    between = np.zeros_like(within)
    for kind in kinds:
        own = standard[states == kind]
        centred = own - own.mean(axis=0)
        within += centred.T @ centred / len(rows)
        between += len(own) / len(rows) * np.outer(own.mean(axis=0), own.mean(axis=0))
    sizes, axes = np.linalg.eigh(within)
    whitening = axes / np.sqrt(sizes)
    order = np.linalg.eigh(whitening.T @ between @ whitening)[1][:, ::-1]
    return Discriminants(mean, scale, whitening @ order[:, : max(1, len(kinds) - 1)])
