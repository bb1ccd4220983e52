"""Unsupervised segmentation of feature streams into recurring movements or intonation phrases (AHG §3.1, RTS §2.2).

A hidden Markov model with parallel branches: each branch is a kind of phrase, a left-to-right chain of states lasting
at least one frame each (10 states: a third of a second at 30 frames a second). From the end of a branch a path may
enter any branch. Training alternates segmentation and re-estimation from the segments. The source does not say how it
is initialised: here by clustering one-second stretches. Self and forward transitions are equally likely, as are the
branches.

Similarity measures of two streams or two distributions (AHG §4).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import log

import numpy as np
from numpy.typing import NDArray

from ..model import FloatArray
from ..prosody_gestures.estimation import drawn_apart
from ..prosody_gestures.semi_markov import IntArray, Segment
from ..realizer.geometry.rotations import inverse, multiply, to_rotation_vector

STATES = 10
"""N_g: the states of a branch, and so the minimum length of a phrase in frames (AHG §3.1)."""

STRETCH_FRAMES = 30

LEAST_DEVIATION = 0.1
"""As a share of the standard deviation over all frames."""


@dataclass(frozen=True, slots=True, eq=False)
class ParallelBranches:
    """The `means` and `variances` of the states of each branch (branches × states × features)."""

    means: FloatArray
    variances: FloatArray

    def segment(self, features: FloatArray) -> list[Segment]:
        """The most likely phrases of a stream (frames × features); the state of a phrase is its branch. Only the first
        may start, and only the last may end, in the middle of a branch."""
        entered, positions = self._aligned(features)
        branches, frames = positions // self.means.shape[1], len(features)
        bounds = [*np.flatnonzero(entered).tolist(), frames]
        return [Segment(int(branches[start]), start, end - start) for start, end in pairwise(bounds)]

    def _aligned(self, features: FloatArray) -> tuple[FloatArray, IntArray]:
        """For each frame, whether it enters a branch, and its state, numbered across all branches."""
        branches, states, _ = self.means.shape
        densities = self._log_densities(features).reshape(len(features), branches, states)
        entry, step = log(0.5 / branches), log(0.5)
        score, came_from = densities[0].copy(), np.zeros((len(features), branches, states), dtype=np.int32)
        places = np.arange(branches * states, dtype=np.int32).reshape(branches, states)
        for frame in range(1, len(features)):
            before = np.empty_like(score)
            before[:, 1:], origin = score[:, :-1] + step, places - 1
            leaving = int(score[:, -1].argmax())
            before[:, 0], origin[:, 0] = score[leaving, -1] + entry, places[leaving, -1]
            stays = score + step >= before
            came_from[frame] = np.where(stays, places, origin)
            score = np.where(stays, score + step, before) + densities[frame]
        return self._traced(int(score.argmax()), came_from.reshape(len(features), -1))

    def _traced(self, last: int, came_from: NDArray[np.int32]) -> tuple[FloatArray, IntArray]:
        states = self.means.shape[1]
        positions = np.empty(len(came_from), dtype=np.intp)
        for frame in range(len(came_from) - 1, -1, -1):
            positions[frame] = last
            last = int(came_from[frame, last])
        entered = (positions % states == 0) & (np.diff(positions, prepend=-1) != 0)
        entered[0] = True
        return entered, positions

    def _log_densities(self, features: FloatArray) -> FloatArray:
        count = self.means.shape[2]
        means, precisions = self.means.reshape(-1, count), 1 / self.variances.reshape(-1, count)
        constants = -0.5 * (means**2 * precisions - np.log(precisions)).sum(axis=1)
        densities: FloatArray = features @ (means * precisions).T - 0.5 * features**2 @ precisions.T + constants
        return densities

    def estimated(self, streams: Iterable[FloatArray]) -> "ParallelBranches":
        """The branches re-estimated from their segmentation of the streams; a state without frames is unchanged."""
        shape = self.means.shape
        totals, sums = np.zeros(shape[0] * shape[1]), np.zeros((shape[0] * shape[1], shape[2]))
        squares = np.zeros_like(sums)
        for features in streams:
            positions = self._aligned(features)[1]
            totals += np.bincount(positions, minlength=len(totals))
            np.add.at(sums, positions, features)
            np.add.at(squares, positions, features**2)
        held = totals[:, None] > 1
        divided = np.maximum(totals, 1)[:, None]
        means = np.where(held, sums / divided, self.means.reshape(-1, shape[2]))
        variances = np.maximum(squares / divided - (sums / divided) ** 2, LEAST_DEVIATION**2)
        variances = np.where(held, variances, self.variances.reshape(-1, shape[2]))
        return ParallelBranches(means.reshape(shape), variances.reshape(shape))


def learn_branches(streams: Sequence[FloatArray], branches: int, *, rounds: int = 8, seed: int = 0) -> ParallelBranches:
    """Trains branches on streams (frames × features each), whose features have mean 0 and standard deviation 1."""
    stretches = np.stack([stretch for features in streams for stretch in _stretches(features)])
    points = stretches.reshape(len(stretches), -1)
    centres = drawn_apart(points, branches, np.random.default_rng(seed))
    for _ in range(rounds):
        distances = (points**2).sum(axis=1)[:, None] - 2 * points @ centres.T + (centres**2).sum(axis=1)
        nearest = distances.argmin(axis=1)
        held = np.unique(nearest)
        centres[held] = [points[nearest == place].mean(axis=0) for place in held]
    means = centres.reshape(branches, STATES, -1)
    learnt = ParallelBranches(means, np.ones_like(means))
    for _ in range(rounds):
        learnt = learnt.estimated(streams)
    return learnt


def _stretches(features: FloatArray) -> list[FloatArray]:
    """One-second stretches, each as the means of as many equal parts as a branch has states (states × features)."""
    part = STRETCH_FRAMES // STATES
    whole = features[: len(features) // STRETCH_FRAMES * STRETCH_FRAMES]
    return list(whole.reshape(-1, STATES, part, features.shape[1]).mean(axis=2))


def cluster_correlation(angles: FloatArray, affect: FloatArray, labels: IntArray) -> FloatArray:
    """The correlation of joint angles (frames × angles) with each affect (frames × affects) within clusters, averaged
    over clusters weighted by their frames (AHG §4.1, Fig. 3). Clusters too small for a correlation count as 0."""
    total = np.zeros(affect.shape[1])
    for label in np.unique(labels):
        inside = labels == label
        if inside.sum() > 2 * angles.shape[1]:
            pairs = [canonical_correlation(angles[inside], affect[inside, place, None]) for place in range(len(total))]
            total += inside.sum() * np.array(pairs)
    return total / len(labels)


def fewest_clusters(correlations: dict[int, FloatArray], whole: FloatArray) -> int:
    """The smallest number of clusters whose correlation, averaged over affects, is at least that of the unclustered
    data; if there is none, the number with the highest correlation (AHG §4.1)."""
    enough = [clusters for clusters, kept in correlations.items() if kept.mean() >= whole.mean()]
    return min(enough) if enough else max(correlations, key=lambda clusters: float(correlations[clusters].mean()))


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
