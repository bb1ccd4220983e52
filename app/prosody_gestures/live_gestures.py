"""Contours in as they are heard, gesture phases out: announced at once, decided later.

The likeliest path up to the newest frame says what a part of the body does now; whoever moves it cannot wait, so a
change of state is announced as soon as it looks so, `ANNOUNCED_S` after its sound was heard, and may turn out wrong.
A stroke often looks so only when it has gone on for a while, and a hand needs time to get ready; so a preparation is
announced while a gesture is still less likely than none (`EARLY`; what that brings is in docs/measurements.md, "Live
streams").
What is decided never changes, and leaves at the latest `DECIDED_S` after it was heard: the frame's window, the
look-ahead of its context, and the decoder's bound.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..model import FRAME_SHIFT_S, FloatArray
from .context import LOOKAHEAD_S, ProsodyContext
from .live_decoder import Commitment, LiveDecoder, Piece
from .prosody import HALF_WINDOW_S, ProsodyNormalizer, raw_frame, whole_frames
from .semi_markov import FRAME_S
from .trellis import EVERYTHING, Search
from .voice_model import PartModel, VoiceModel

BOUND_S = 1.6
COMMITMENT = Commitment(bound_frames=round(BOUND_S / FRAME_S), at_once=20, beam=8.0)
LEAD = 1.0
"""By how much another state's path must be likelier, in logarithms, before it is announced."""

EARLY = 2.5
"""By how much the best path into a gesture may be less likely than that without, in logarithms, while a preparation is
announced."""

PREPARATION, STROKE = "preparation", "stroke"

ANNOUNCED_S = HALF_WINDOW_S + LOOKAHEAD_S
DECIDED_S = ANNOUNCED_S + BOUND_S


@dataclass(frozen=True, slots=True)
class Phase:
    """A stretch of a part's path: `state` of `part`, from `start_s` to `end_s`.

    One that is `decided` follows the decided one before without a gap; where it does not `begin`, that one goes on. One
    that is not was announced, and goes on until another is.
    """

    part: str
    state: str
    start_s: float
    end_s: float
    begins: bool
    decided: bool


class LiveGestures:
    """What hands, head and brows do, from a voice that still goes on. Memory does not grow."""

    def __init__(self, model: VoiceModel, search: Search = EVERYTHING, commitment: Commitment = COMMITMENT) -> None:
        self._parts = [_LivePart(part, search, commitment) for part in model.parts]
        self._normalizer, self._context = ProsodyNormalizer(), ProsodyContext()
        self._levels_db, self._pitches_hz = np.empty(0), np.empty(0)
        self._base = self._frames = 0

    def hear(self, energy_db: FloatArray, f0_hz: FloatArray) -> tuple[Phase, ...]:
        """What is announced and decided by more of the contours (a row each `FRAME_SHIFT_S`; f0 is 0 where
        unvoiced)."""
        self._levels_db = np.concatenate([self._levels_db, energy_db])
        self._pitches_hz = np.concatenate([self._pitches_hz, f0_hz])
        phases = [phase for _ in iter(self._next_frame, False) for phase in self._told_by_frame()]
        done = max(0, int((self._frames * FRAME_S - HALF_WINDOW_S) / FRAME_SHIFT_S) - self._base - 1)
        self._levels_db, self._pitches_hz = self._levels_db[done:], self._pitches_hz[done:]
        self._base += done
        return tuple(phases)

    def finish(self) -> tuple[Phase, ...]:
        """The rest, when the voice has ended."""
        phases = [phase for row in self._context.finish() for phase in self._told(row)]
        return (*phases, *(phase for part in self._parts for phase in part.finish()))

    def _next_frame(self) -> bool:
        return self._frames < whole_frames(self._base + len(self._pitches_hz))

    def _told_by_frame(self) -> Iterator[Phase]:
        raw = raw_frame(self._levels_db, self._pitches_hz, self._frames, self._base)
        self._frames += 1
        row = self._context.push(np.array(self._normalizer.push(*raw)))
        if row is not None:
            yield from self._told(row)

    def _told(self, row: FloatArray) -> Iterator[Phase]:
        for part in self._parts:
            yield from part.push(row)


class _LivePart:
    """One part of the body: its decoder, and what was announced of it last."""

    def __init__(self, part: PartModel, search: Search, commitment: Commitment) -> None:
        self._part, self._decoder = part, LiveDecoder(part.model, search, commitment)
        self._announcing = Announcing(part.model.states)
        self._frames = 0

    def push(self, row: FloatArray) -> Iterator[Phase]:
        """What one more frame (`WIDTH`) tells."""
        decided = self._decoder.push(self._part.log_likelihoods(row[None])[0])
        state = self._announcing.changed(self._decoder.scores())
        if state is not None:
            start_s = self._frames * FRAME_S
            yield Phase(self._part.part, self._named(state), start_s, start_s + FRAME_S, begins=True, decided=False)
        self._frames += 1
        yield from map(self._phase, decided)

    def finish(self) -> Iterator[Phase]:
        return map(self._phase, self._decoder.finish())

    def _named(self, state: int) -> str:
        return self._part.model.states[state]

    def _phase(self, piece: Piece) -> Phase:
        start_s, end_s = piece.segment.start * FRAME_S, piece.segment.end * FRAME_S
        return Phase(self._part.part, self._named(piece.segment.state), start_s, end_s, piece.begins, decided=True)


class Announcing:
    """Tells changes of state, so that they neither flicker nor come late. A model without preparations and strokes, as
    of a team's own pairs, has no early ones."""

    def __init__(self, states: Sequence[str]) -> None:
        self._state: int | None = None
        has_gestures = {PREPARATION, STROKE} <= set(states)
        self._gesture = [states.index(PREPARATION), states.index(STROKE)] if has_gestures else []

    def changed(self, scores: FloatArray) -> int | None:
        """The state that is announced by how likely each is (`LiveDecoder.scores`), if it is another than before."""
        state, best = self._state, int(scores.argmax())
        if state is None or scores[best] - scores[state] > LEAD:
            state = best
        if self._gesture and state not in self._gesture and self._state != self._gesture[1]:
            kept = EARLY + LEAD if self._state == self._gesture[0] else EARLY
            state = self._gesture[0] if scores[self._gesture].max() > scores[state] - kept else state
        changed = state != self._state
        self._state = state
        return state if changed else None
