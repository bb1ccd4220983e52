"""Online Viterbi decoding of a stream with bounded delay (RTS §1.3, §2.3).

Decided segments are final. A part of the path is decided

- as soon as all survivors share it: the open paths whose score lies within `beam` of the best; with an infinite beam,
  when no other path can ever win;
- at the latest `bound_frames` after its frames arrived, by the best path at that moment. Paths that disagree are
  dropped, and the frames since are decoded again, so that the rest is the best continuation.

Provisional states are available from `scores` and may change; callers that cannot wait for the bound use them.

The thesis promises "a finite delay" without a figure: its program decodes one minute at a time.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf, isfinite

import numpy as np

from ..errors import InputError
from ..model import FloatArray
from .semi_markov import Segment, SemiMarkovModel
from .trellis import EVERYTHING, Search, Trellis


@dataclass(frozen=True, slots=True)
class Commitment:
    """When a path is decided. `bound_frames` is the maximum delay (None: unbounded). `at_once` is how many frames are
    decided together when it is reached, and the interval at which survivors are compared; larger values cost less."""

    bound_frames: int | None = None
    at_once: int = 1
    beam: float = inf


@dataclass(frozen=True, slots=True)
class Piece:
    """A decided part of the path. `begins` if it starts a segment; otherwise it continues that of the last piece."""

    segment: Segment
    begins: bool


class LiveDecoder:
    """Takes log likelihoods frame by frame and returns the decided path in contiguous pieces."""

    def __init__(
        self, model: SemiMarkovModel, search: Search = EVERYTHING, commitment: Commitment | None = None
    ) -> None:
        self._commitment = commitment or Commitment()
        self._longest = model.longest_frames
        self._bound = self._commitment.bound_frames
        self._trellis = Trellis(model, search, capacity=2 * self._longest + 4 * (self._bound or 0))
        self._root: tuple[int, int] | None = None
        self._decided = 0

    @property
    def decided(self) -> int:
        """The number of decided frames."""
        return self._decided

    def push(self, log_likelihoods: FloatArray) -> tuple[Piece, ...]:
        """Takes the log likelihoods of one more frame (states) and returns the pieces it decides."""
        self._trellis.forget(self._root[0] if self._root else 0)
        self._trellis.push(log_likelihoods)
        pieces: list[Piece] = []
        if self._trellis.time % self._commitment.at_once == 0:
            pieces += self._shared()
        if self._bound is not None and self._trellis.time - self._decided > self._bound:
            pieces += self._best_until(self._decided + self._commitment.at_once)
        return tuple(pieces)

    def scores(self) -> FloatArray:
        """The provisional score of each state for the last frame: the log probability of its best path (states)."""
        best: FloatArray = self._trellis.open_scores(self._start).max(axis=1)
        return best

    def finish(self) -> tuple[Piece, ...]:
        """Ends the last segment and returns the rest of the path."""
        if not self._trellis.time:
            return ()
        score, state = self._trellis.closed()
        if not isfinite(score):
            raise InputError("undecodable", "no path of the model fits these frames")
        last = self._trellis.last_segment(state)
        path = [*self._trellis.back_to(self._start, last.start, last.state), last]
        return tuple(self._until(path, self._trellis.time))

    @property
    def _start(self) -> int:
        return self._root[0] if self._root else 0

    def _shared(self) -> Iterator[Piece]:
        """The segments that all survivors share."""
        while (child := self._only_child()) is not None:
            boundary, state = child
            if boundary > 0:
                before = self._trellis.back_to(self._start, boundary, state)
                yield from self._until(before, boundary)
            self._root = (boundary, state)
            self._trellis.restart(state, boundary, boundary)

    def _only_child(self) -> tuple[int, int] | None:
        """The start and state of the first segment after the root's in all survivors; None unless they agree."""
        open_scores = self._trellis.open_scores(self._start)
        first = self._trellis.time - open_scores.shape[1]
        states, places = np.nonzero(open_scores >= max(open_scores.max() - self._commitment.beam, np.finfo(float).min))
        boundaries = places + first
        while len(boundaries):
            if self._root and (boundaries == self._start).any():
                return None
            at_start = boundaries == self._start
            starts, before = self._trellis.begun(boundaries, states)
            done = at_start if self._root is None else starts == self._start
            if done.all():
                nodes = set(zip(boundaries.tolist(), states.tolist(), strict=True))
                return nodes.pop() if len(nodes) == 1 else None
            boundaries, states = np.where(done, boundaries, starts), np.where(done, states, before)
        return None

    def _best_until(self, frame: int) -> Iterator[Piece]:
        """Decides the frames up to this one by the best current path."""
        open_scores = self._trellis.open_scores(self._start)
        state, place = divmod(int(open_scores.argmax()), open_scores.shape[1])
        boundary = place + self._trellis.time - open_scores.shape[1]
        going_on = Segment(state, boundary, self._trellis.time - boundary)
        path = [*self._trellis.back_to(self._start, boundary, state), going_on]
        holder = next(segment for segment in path if segment.end >= frame)
        yield from self._until(path, frame)
        self._root = (holder.start, holder.state)
        self._trellis.restart(holder.state, holder.start, frame)

    def _until(self, path: list[Segment], frame: int) -> Iterator[Piece]:
        """The undecided pieces of a path, up to a frame."""
        for segment in path:
            start, end = max(segment.start, self._decided), min(segment.end, frame)
            if end > start:
                yield Piece(Segment(segment.state, start, end - start), begins=start == segment.start)
                self._decided = end
