"""The hidden semi-Markov model Λ = (A, B, D, Π) (RTS eq. 2.1 to 2.4; AHG eq. 7 to 10) as arrays of log probabilities.

States are kinds of gesture phrases, fully connected; a state may follow itself, as one beat follows another. Each
segment of a path has a state and a duration in whole frames, and emits one observation a frame.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..model import FloatArray

FRAME_S = 0.025
"""The length δ of a frame and of a bin of the duration histogram (RTS §2.2, AHG §3.2)."""

IntArray = NDArray[np.intp]


class Emissions(Protocol):
    """The emission model of the states."""

    def log_likelihoods(self, observations: FloatArray | IntArray) -> FloatArray:
        """The log likelihoods b_i(o) (frames × states) of `observations`, one row or label a frame; all finite."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class DiscreteEmissions:
    """The probability of each intonation-phrase label (RTS eq. 2.2): `log_probability` is states × labels."""

    log_probability: FloatArray

    def log_likelihoods(self, observations: FloatArray | IntArray) -> FloatArray:
        """Takes labels (frames)."""
        return self.log_probability.T[observations.astype(np.intp)]


@dataclass(frozen=True, slots=True, eq=False)
class MixtureEmissions:
    """Gaussian mixtures with diagonal covariance (AHG eq. 13): `log_weights` is states × components, `means` and
    `variances` are states × components × features."""

    log_weights: FloatArray
    means: FloatArray
    variances: FloatArray

    def log_likelihoods(self, observations: FloatArray | IntArray) -> FloatArray:
        """Takes features (frames × features)."""
        densities = self.log_densities(observations)
        highest = densities.max(axis=2)
        total: FloatArray = highest + np.log(np.exp(densities - highest[:, :, None]).sum(axis=2))
        return total

    def log_densities(self, observations: FloatArray | IntArray) -> FloatArray:
        """The log of weight times density of each component (frames × states × components)."""
        states, components, features = self.means.shape
        precisions = 1 / self.variances.reshape(-1, features)
        means = self.means.reshape(-1, features)
        constants = -0.5 * (np.log(2 * np.pi / precisions) + means**2 * precisions).sum(axis=1)
        exponents = observations @ (means * precisions).T - 0.5 * observations**2 @ precisions.T
        densities: FloatArray = exponents + constants + self.log_weights.reshape(-1)
        return densities.reshape(-1, states, components)


@dataclass(frozen=True, slots=True, eq=False)
class SemiMarkovModel:
    """`states` are their names; `log_initial` (states), `log_transition` (from × to) and `log_duration` (states ×
    frames, from a duration of one frame up to the longest) are logarithms of probabilities."""

    states: tuple[str, ...]
    log_initial: FloatArray
    log_transition: FloatArray
    log_duration: FloatArray
    emissions: Emissions

    @property
    def longest_frames(self) -> int:
        return int(self.log_duration.shape[1])


@dataclass(frozen=True, slots=True)
class Segment:
    """`frames` frames in `state`, starting at frame `start`."""

    state: int
    start: int
    frames: int

    @property
    def end(self) -> int:
        return self.start + self.frames


def states_by_frame(segments: Iterable[Segment]) -> IntArray:
    """The state of each frame of contiguous segments."""
    found = list(segments)
    return np.repeat([each.state for each in found], [each.frames for each in found]).astype(np.intp)


def segments_of(states: Sequence[int] | IntArray) -> list[Segment]:
    """The segments of a state sequence: its runs of equal states."""
    frames = np.asarray(states, dtype=np.intp)
    bounds = [0, *(np.flatnonzero(np.diff(frames)) + 1).tolist(), len(frames)]
    return [Segment(int(frames[start]), start, end - start) for start, end in pairwise(bounds) if end > start]


def similarity(one: IntArray, other: IntArray) -> float:
    """The share of frames in which two paths have the same state (RTS §3.1)."""
    return float((one == other).mean())
