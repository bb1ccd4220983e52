"""Fits Gaussian mixtures with diagonal covariance to the frames of each state (AHG eq. 13), by expectation maximisation
with k-means++ initialisation."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..model import FloatArray
from .semi_markov import MixtureEmissions


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
