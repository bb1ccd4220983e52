"""Maximum-likelihood training of a semi-Markov model from labelled segments (AHG eq. 11, 12 and 14).

Eq. 11 as printed has a stray j in its numerator; here the first gestures of each kind, whatever follows them, are
divided by all first gestures.

Departures, because data are scarce: additive smoothing, so that unseen events remain possible; and a kernel over
durations, since a histogram with 200 bins a state and a few dozen segments is mostly empty.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..model import FloatArray
from .semi_markov import DiscreteEmissions, IntArray, Segment


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
