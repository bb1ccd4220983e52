"""Small models drawn by chance, the same for the same seed."""

from dataclasses import replace

import numpy as np

from understudy.model import FloatArray
from understudy.prosody_gestures.semi_markov import DiscreteEmissions, SemiMarkovModel

LABELS = 5


def log_shares(generator: np.random.Generator, *shape: int) -> FloatArray:
    """Logarithms of chances that sum to 1 along the last axis."""
    chances = generator.random(shape) ** 3
    shares: FloatArray = np.log(chances / chances.sum(axis=-1, keepdims=True))
    return shares


def drawn_model(seed: int, *, states: int, longest: int) -> SemiMarkovModel:
    generator = np.random.default_rng(seed)
    return SemiMarkovModel(
        tuple(f"s{state}" for state in range(states)),
        log_shares(generator, states),
        log_shares(generator, states, states),
        log_shares(generator, states, longest),
        DiscreteEmissions(log_shares(generator, states, LABELS)),
    )


def three_frames_at_least() -> SemiMarkovModel:
    """No recording of one or two frames has a path in it."""
    return replace(drawn_model(0, states=2, longest=3), log_duration=np.tile([-np.inf, -np.inf, 0.0], (2, 1)))


def drawn_likelihoods(model: SemiMarkovModel, seed: int, frames: int) -> FloatArray:
    labels = np.random.default_rng(1000 + seed).integers(0, LABELS, frames)
    return model.emissions.log_likelihoods(labels)
