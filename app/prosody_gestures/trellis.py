"""The recursion of the semi-Markov Viterbi algorithm, boundary by boundary (RTS eq. 2.5, Algorithm 1; AHG eq. 15).

ψ_t(j), the best score of a path whose last segment is in state j and ends at boundary t, is the maximum over durations
τ of: ψ_{t-τ}(i) + log a_ij for the best i, plus log d_j(τ), plus the log likelihood of the frames in j. The best
predecessor of a (boundary, state) does not depend on t, so it is computed once, when the boundary is reached, and a
frame costs states² + states × durations instead of the states² × durations of the printed double loop.

Algorithm 1 is unclear or misprinted in places; we read it as follows:

- As printed, the n best states restrict only the predecessor φ, while ψ and ν range over all: that saves nothing, and φ
  could belong to another path than ψ. Here ψ, φ and ν all range over the n best.
- They are the n best at the boundary where the predecessor ends, not those of the frame before t: a state that scored
  well two seconds ago may be far from the best now (`benchmarks.prosody_gestures.tables` measures both).
- ν, printed as a maximum, is the duration at which the maximum is attained.
- ψ_1 has no duration as printed, and ψ_0 is undefined; here the first segment has π_j d_j(τ), like any other.
- T and D_max are frames and seconds in print; here everything is frames.
"""

from dataclasses import dataclass
from math import inf

import numpy as np

from ..model import FloatArray
from .semi_markov import IntArray, Segment, SemiMarkovModel


@dataclass(frozen=True, slots=True)
class Search:
    """The search space: durations of 1, 1 + step, 1 + 2 step, … frames (m in RTS), and only the `best` predecessor
    states (n; None: all)."""

    step: int = 1
    best: int | None = None


EVERYTHING = Search()


class Trellis:
    """The scores of all paths up to boundary `time`; starts at boundary 0.

    Columns are boundaries, starting at `base`. `entry` (states × boundaries) is the best score of a path that enters a
    state at a boundary, minus the state's cumulative emission score there, so that adding `emitted` (cumulative,
    states × boundaries) at the end completes it.
    """

    def __init__(self, model: SemiMarkovModel, search: Search = EVERYTHING, capacity: int = 0) -> None:
        states, longest = model.log_duration.shape
        self._model, self._search = model, search
        self._durations = model.log_duration[:, :: search.step].copy()
        self._remaining = _log_survival(model.log_duration, search.step)
        self._columns = max(capacity, 2 * longest) + 1
        self._entry = np.full((states, self._columns), -inf)
        self._emitted = np.zeros((states, self._columns))
        self._predecessor = np.zeros((self._columns, states), dtype=np.intp)
        self._lasted = np.zeros((self._columns, states), dtype=np.intp)
        self._ended = np.full(states, -inf)
        self._rows = np.arange(states)
        self._entry[:, 0] = model.log_initial
        self.base = self.time = 0

    def push(self, log_likelihoods: FloatArray) -> None:
        """Adds the log likelihoods of one more frame (states)."""
        if self.time + 1 - self.base == self._columns:
            self._widen()
        self.time += 1
        column = self.time - self.base
        np.add(self._emitted[:, column - 1], log_likelihoods, out=self._emitted[:, column])
        self._reach(column)

    def _reach(self, column: int) -> None:
        """Computes the best segments ending at a boundary, and the best predecessors of those that start there."""
        first = max(0, column - self._model.longest_frames)
        latest = self._entry[:, first:column][:, :: -self._search.step]
        scores = latest + self._durations[:, : latest.shape[1]]
        place = scores.argmax(axis=1)
        ended = scores[self._rows, place] + self._emitted[:, column]
        self._lasted[column] = 1 + place * self._search.step
        best = self._best(ended)
        chains = ended[best, None] + self._model.log_transition[best]
        chosen = chains.argmax(axis=0)
        self._predecessor[column] = best[chosen]
        self._entry[:, column] = chains[chosen, self._rows] - self._emitted[:, column]
        self._ended = ended

    def _best(self, ended: FloatArray) -> IntArray:
        count = self._search.best
        if count is None or count >= len(ended):
            return self._rows
        return np.sort(np.argpartition(-ended, count - 1)[:count])

    def closed(self) -> tuple[float, int]:
        """The best score of a path that ends now, and its last state."""
        state = int(self._ended.argmax())
        return float(self._ended[state]), state

    def open_scores(self, since: int) -> FloatArray:
        """The scores of the paths whose last segment started at boundary `since` or later and is still open (states ×
        boundaries up to now); the open segment is scored by the probability of lasting at least this long."""
        first, column = max(since, self.time - self._model.longest_frames) - self.base, self.time - self.base
        remaining = self._remaining[:, column - first - 1 :: -1] if column > first else self._remaining[:, :0]
        scores: FloatArray = self._entry[:, first:column] + remaining + self._emitted[:, column, None]
        return scores

    def begun(self, boundary: int | IntArray, state: int | IntArray) -> tuple[IntArray, IntArray]:
        """The start and state of the best predecessor of a segment that starts at `boundary` in `state`."""
        before = self._predecessor[boundary - self.base, state]
        return boundary - self._lasted[boundary - self.base, before], before

    def last_segment(self, state: int) -> Segment:
        """The best segment in `state` that ends now."""
        lasted = int(self._lasted[self.time - self.base, state])
        return Segment(state, self.time - lasted, lasted)

    def back_to(self, root: int, boundary: int, state: int) -> list[Segment]:
        """The segments of the best path that enters `state` at `boundary`, traced back to the segment at `root`."""
        segments: list[Segment] = []
        while boundary > root:
            start, before = self.begun(boundary, state)
            segments.append(Segment(int(before), int(start), boundary - int(start)))
            boundary, state = int(start), int(before)
        return segments[::-1]

    def restart(self, state: int, start: int, boundary: int) -> None:
        """Keeps only the paths with a segment in `state` from boundary `start` to at least `boundary`, and decodes
        again from there, so that paths that had been pruned before are found too."""
        first = start - self.base
        again = max(boundary - self.base, first + 1)
        kept = self._entry[state, first]
        self._entry[:, :again] = -inf
        self._entry[state, first] = kept
        for column in range(again, self.time - self.base + 1):
            self._reach(column)

    def forget(self, boundary: int) -> None:
        """Frees the columns before `boundary`; no path is traced back beyond it. Does nothing while there is room."""
        dropped = boundary - self.base
        if self.time + 1 - self.base < self._columns or dropped <= 0:
            return
        for by_boundary in (self._entry.T, self._emitted.T, self._predecessor, self._lasted):
            by_boundary[:-dropped] = by_boundary[dropped:].copy()
        self.base = boundary

    def _widen(self) -> None:
        """Doubles the columns, because nothing could be freed."""
        more = self._columns
        self._entry = np.pad(self._entry, ((0, 0), (0, more)), constant_values=-inf)
        self._emitted = np.pad(self._emitted, ((0, 0), (0, more)))
        self._predecessor = np.pad(self._predecessor, ((0, more), (0, 0)))
        self._lasted = np.pad(self._lasted, ((0, more), (0, 0)))
        self._columns += more


def _log_survival(log_duration: FloatArray, step: int) -> FloatArray:
    """The log survival function of the searched durations: that a segment lasts at least 1, 2, … frames."""
    probability = np.zeros_like(log_duration)
    probability[:, ::step] = np.exp(log_duration[:, ::step])
    chance = np.cumsum(probability[:, ::-1], axis=1)[:, ::-1]
    with np.errstate(divide="ignore"):
        survival: FloatArray = np.log(chance)
    return survival
