"""Learning a semi-Markov model by counting segments whose states are known (AHG eq. 11, 12 and 14).

Eq. 11 as printed keeps j in its numerator; the first gestures of each kind are counted, whatever follows them, and
divided by all first gestures.

Departures, each for want of data: a small count is added to all that is possible, so that nothing unseen is forbidden;
and a duration that was seen counts for those near it too, since a histogram of 200 bins a state filled by some dozen
segments is mostly holes.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..model import FloatArray
from .semi_markov import DiscreteEmissions, IntArray, Segment


@dataclass(frozen=True, slots=True)
class Smoothing:
    """`added` is shared out over the initial states, over each state's followers, durations and labels; `spread` is how
    far a duration counts for others, as the deviation of its logarithm (0: not at all)."""

    added: float = 0.5
    spread: float = 0.15


PLAIN = Smoothing(added=0.0, spread=0.0)
"""As printed: what was not seen is impossible."""


@dataclass(frozen=True, slots=True, eq=False)
class Counts:
    """Logarithms of the shares that were counted: initial states (states), transitions (from × to), durations (states ×
    frames)."""

    log_initial: FloatArray
    log_transition: FloatArray
    log_duration: FloatArray


def count(
    paths: Iterable[Sequence[Segment]], states: int, longest_frames: int, smoothing: Smoothing = Smoothing()
) -> Counts:
    """What is counted in paths. A segment longer than `longest_frames` counts as one that long."""
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
    """The probability mass of the labels in each state (RTS eq. 2.2), from paths with a label a frame."""
    counts = np.zeros((states, labels))
    for path, emitted in pairs:
        for segment in path:
            counts[segment.state] += np.bincount(emitted[segment.start : segment.end], minlength=labels)
    return DiscreteEmissions(_log_shares(counts, added))


def _spreading(longest_frames: int, spread: float) -> FloatArray:
    """How much a duration (row) counts for each (column)."""
    if not spread:
        return np.eye(longest_frames)
    logarithms = np.log(np.arange(1, longest_frames + 1))
    weights = np.exp(-0.5 * ((logarithms[:, None] - logarithms) / spread) ** 2)
    shares: FloatArray = weights / weights.sum(axis=1, keepdims=True)
    return shares


def _log_shares(counts: FloatArray, added: float) -> FloatArray:
    """Logarithms of shares along the last axis; all alike where nothing was counted and nothing is added."""
    counts = counts + added / counts.shape[-1]
    totals = counts.sum(axis=-1, keepdims=True)
    shares = np.where(totals > 0, counts / np.where(totals > 0, totals, 1), 1 / counts.shape[-1])
    with np.errstate(divide="ignore"):
        logarithms: FloatArray = np.log(shares)
    return logarithms
