"""Maximum-likelihood training of a semi-Markov model: counts of labelled segments (AHG eq. 11, 12 and 14), and Gaussian
mixtures with diagonal covariance fitted to the frames of each state (AHG eq. 13), by expectation maximisation with
k-means++ initialisation.

Eq. 11 as printed has a stray j in its numerator; here the first gestures of each kind, whatever follows them, are
divided by all first gestures.

Departures, because data are scarce: additive smoothing, so that unseen events remain possible; and a kernel over
durations.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..model import FloatArray
from .semi_markov import DiscreteEmissions, IntArray, MixtureEmissions, Segment


@dataclass(frozen=True, slots=True)
class CountSmoothing:
    """`added` is a pseudo-count divided among the initial states, and among each state's successors, durations and
    labels; `spread` is the width of the kernel over durations, a standard deviation of their logarithm (0: none)."""

    added: float = 0.5
    spread: float = 0.15


PLAIN = CountSmoothing(added=0.0, spread=0.0)
"""As printed: unseen events are impossible."""


@dataclass(frozen=True, slots=True, eq=False)
class Counts:
    """Log probabilities: initial states (states), transitions (from × to), durations (states × frames)."""

    log_initial: FloatArray
    log_transition: FloatArray
    log_duration: FloatArray


def count(
    paths: Iterable[Sequence[Segment]], states: int, longest_frames: int, smoothing: CountSmoothing = CountSmoothing()
) -> Counts:
    """The probabilities estimated from paths. Durations are clipped to `longest_frames`."""
    initial, followers = np.zeros(states), np.zeros((states, states))
    durations = np.zeros((states, longest_frames))
    for path in paths:
        initial[path[0].state] += 1
        for one, other in pairwise(path):
            followers[one.state, other.state] += 1
        for segment in path:
            durations[segment.state, min(segment.frames, longest_frames) - 1] += 1
    return Counts(
        _log_shares(initial, smoothing.added),
        _log_shares(followers, smoothing.added),
        _log_shares(durations @ _spreading(longest_frames, smoothing.spread), smoothing.added),
    )


def count_labels(
    pairs: Iterable[tuple[Sequence[Segment], IntArray]], states: int, labels: int, added: float = 0.5
) -> DiscreteEmissions:
    """The emission probabilities of labels in each state (RTS eq. 2.2), from paths with one label a frame."""
    counts = np.zeros((states, labels))
    for path, emitted in pairs:
        for segment in path:
            counts[segment.state] += np.bincount(emitted[segment.start : segment.end], minlength=labels)
    return DiscreteEmissions(_log_shares(counts, added))


def _spreading(longest_frames: int, spread: float) -> FloatArray:
    """The weight of a duration (row) for each other (column)."""
    if not spread:
        return np.eye(longest_frames)
    logarithms = np.log(np.arange(1, longest_frames + 1))
    weights = np.exp(-0.5 * ((logarithms[:, None] - logarithms) / spread) ** 2)
    shares: FloatArray = weights / weights.sum(axis=1, keepdims=True)
    return shares


def _log_shares(counts: FloatArray, added: float) -> FloatArray:
    """Logarithms of the shares along the last axis; uniform where all counts are 0 and nothing is added."""
    counts = counts + added / counts.shape[-1]
    totals = counts.sum(axis=-1, keepdims=True)
    shares = np.where(totals > 0, counts / np.where(totals > 0, totals, 1), 1 / counts.shape[-1])
    with np.errstate(divide="ignore"):
        logarithms: FloatArray = np.log(shares)
    return logarithms


@dataclass(frozen=True, slots=True)
class MixtureOptions:
    """At most `components` (K in AHG) a state, one for each `frames_each` frames; `rounds` is the number of iterations;
    `least_deviation` is the minimum standard deviation."""

    components: int = 10
    rounds: int = 30
    least_deviation: float = 0.1
    frames_each: int = 30
    seed: int = 0


def fit_mixtures(frames_by_state: Sequence[FloatArray], options: MixtureOptions = MixtureOptions()) -> MixtureEmissions:
    """The mixtures fitted to the frames (frames × features) of each state; a state without frames uses all frames."""
    everything = np.concatenate([frames for frames in frames_by_state if len(frames)])
    fitted = [_fit(frames if len(frames) else everything, options) for frames in frames_by_state]
    log_weights, means, variances = (np.stack(parts) for parts in zip(*fitted, strict=True))
    return MixtureEmissions(log_weights, means, variances)


def _fit(frames: FloatArray, options: MixtureOptions) -> tuple[FloatArray, FloatArray, FloatArray]:
    count = max(1, min(options.components, len(frames) // options.frames_each))
    generator = np.random.default_rng(options.seed)
    means = drawn_apart(frames, count, generator)
    variances = np.tile(frames.var(axis=0) + options.least_deviation**2, (count, 1))
    weights = np.full(count, 1 / count)
    for _ in range(options.rounds if count > 1 else 1):
        shares = _shares(frames, MixtureEmissions(np.log(weights)[None], means[None], variances[None]))
        totals = shares.sum(axis=0) + 1e-9
        weights = totals / totals.sum()
        means = shares.T @ frames / totals[:, None]
        variances = np.maximum(shares.T @ frames**2 / totals[:, None] - means**2, options.least_deviation**2)
    return _padded(weights, means, variances, options.components)


def _shares(frames: FloatArray, mixture: MixtureEmissions) -> FloatArray:
    """The responsibility of each component of a single state for each frame (frames × components)."""
    densities = mixture.log_densities(frames)[:, 0]
    chances = np.exp(densities - densities.max(axis=1, keepdims=True))
    shares: FloatArray = chances / chances.sum(axis=1, keepdims=True)
    return shares


def _padded(
    weights: FloatArray, means: FloatArray, variances: FloatArray, components: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Pads the mixtures to the same number of components; the added ones have negligible weight."""
    missing = components - len(weights)
    return (
        np.log(np.concatenate([weights, np.full(missing, 1e-12)])),
        np.concatenate([means, np.tile(means[:1], (missing, 1))]),
        np.concatenate([variances, np.tile(variances[:1], (missing, 1))]),
    )


def drawn_apart(points: FloatArray, count: int, generator: np.random.Generator) -> FloatArray:
    """`count` of the points, drawn by k-means++: with probability proportional to the squared distance from the nearest
    point drawn before."""
    chosen = [int(generator.integers(len(points)))]
    distances = ((points - points[chosen[0]]) ** 2).sum(axis=1)
    while len(chosen) < count:
        total = distances.sum()
        chances = distances / total if total > 0 else None
        chosen.append(int(generator.choice(len(points), p=chances)))
        distances = np.minimum(distances, ((points - points[chosen[-1]]) ** 2).sum(axis=1))
    return points[chosen].astype(np.float64)
