"""Streams gesture phases from energy and f0: predictions at once, final decisions later.

The most likely path up to the newest frame predicts what each part of the body does now. An animated character cannot
wait, so a change of state is announced as soon as it is likely, `ANNOUNCED_S` after its sound, and may be revised.
A stroke is often recognised only some time after it has begun, and a hand needs time to prepare it; so a preparation is
announced while a gesture is still less likely than none (`EARLY`; its effect is in docs/measurements/live.md, "Live
streams").
Decided phases are final and are sent at the latest `DECIDED_S` after their sound: the frame's window, the look-ahead
of its context, and the decoder's bound.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..model import FRAME_SHIFT_S, FloatArray
from .live_decoder import Commitment, LiveDecoder, Piece
from .prosody import HALF_WINDOW_S, LOOKAHEAD_S, ProsodyContext, ProsodyNormalizer, raw_frame, whole_frames
from .semi_markov import FRAME_S
from .trellis import EVERYTHING, Search
from .voice_model import PartModel, VoiceModel

BOUND_S = 1.6
COMMITMENT = Commitment(bound_frames=round(BOUND_S / FRAME_S), at_once=20, beam=8.0)
LEAD = 1.0
"""The margin, in log probability, by which another state must be more likely before it is announced."""

EARLY = 2.5
"""The margin, in log probability, by which a gesture may be less likely than none for its preparation to be
announced."""

PREPARATION, STROKE = "preparation", "stroke"

ANNOUNCED_S = HALF_WINDOW_S + LOOKAHEAD_S
DECIDED_S = ANNOUNCED_S + BOUND_S


@dataclass(frozen=True, slots=True)
class LivePhase:
    """A phase of a part of the body: `part` is in `state` from `start_s` to `end_s`.

    `decided` phases are final and contiguous; one that does not `begin` continues the one before it. Others are
    predictions, which last until the next prediction for the part.
    """

    part: str
    state: str
    start_s: float
    end_s: float
    begins: bool
    decided: bool


class LiveGestures:
    """Predicts the phases of hands, head and brows from a live voice. Memory use is bounded."""

    def __init__(self, model: VoiceModel, search: Search = EVERYTHING, commitment: Commitment = COMMITMENT) -> None:
        self._parts = [_LivePart(part, search, commitment) for part in model.parts]
        self._normalizer, self._context = ProsodyNormalizer(), ProsodyContext()
        self._levels_db, self._pitches_hz = np.empty(0), np.empty(0)
        self._base = self._frames = 0

    def hear(self, energy_db: FloatArray, f0_hz: FloatArray) -> tuple[LivePhase, ...]:
        """Takes more of the contours (one row each `FRAME_SHIFT_S`; f0 is 0 where unvoiced) and returns the phases
        announced and decided by them."""
        self._levels_db = np.concatenate([self._levels_db, energy_db])
        self._pitches_hz = np.concatenate([self._pitches_hz, f0_hz])
        phases = [phase for _ in iter(self._next_frame, False) for phase in self._told_by_frame()]
        done = max(0, int((self._frames * FRAME_S - HALF_WINDOW_S) / FRAME_SHIFT_S) - self._base - 1)
        self._levels_db, self._pitches_hz = self._levels_db[done:], self._pitches_hz[done:]
        self._base += done
        return tuple(phases)

    def finish(self) -> tuple[LivePhase, ...]:
        """Ends the stream and returns the remaining phases."""
        phases = [phase for row in self._context.finish() for phase in self._told(row)]
        return (*phases, *(phase for part in self._parts for phase in part.finish()))

    def _next_frame(self) -> bool:
        return self._frames < whole_frames(self._base + len(self._pitches_hz))

    def _told_by_frame(self) -> Iterator[LivePhase]:
        raw = raw_frame(self._levels_db, self._pitches_hz, self._frames, self._base)
        self._frames += 1
        row = self._context.push(np.array(self._normalizer.push(*raw)))
        if row is not None:
            yield from self._told(row)

    def _told(self, row: FloatArray) -> Iterator[LivePhase]:
        for part in self._parts:
            yield from part.push(row)


class _LivePart:
    """The decoder of one part of the body, and its last announced state."""

    def __init__(self, part: PartModel, search: Search, commitment: Commitment) -> None:
        self._part, self._decoder = part, LiveDecoder(part.model, search, commitment)
        self._announcing = Announcing(part.model.states)
        self._frames = 0

    def push(self, row: FloatArray) -> Iterator[LivePhase]:
        """Takes one more frame (`WIDTH`) and returns the phases it announces and decides."""
        decided = self._decoder.push(self._part.log_likelihoods(row[None])[0])
        state = self._announcing.changed(self._decoder.scores())
        if state is not None:
            start_s = self._frames * FRAME_S
            yield LivePhase(self._part.part, self._named(state), start_s, start_s + FRAME_S, begins=True, decided=False)
        self._frames += 1
        yield from map(self._phase, decided)

    def finish(self) -> Iterator[LivePhase]:
        return map(self._phase, self._decoder.finish())

    def _named(self, state: int) -> str:
        return self._part.model.states[state]

    def _phase(self, piece: Piece) -> LivePhase:
        start_s, end_s = piece.segment.start * FRAME_S, piece.segment.end * FRAME_S
        return LivePhase(self._part.part, self._named(piece.segment.state), start_s, end_s, piece.begins, decided=True)


class Announcing:
    """Announces changes of state with hysteresis, and preparations early. A model without the states preparation and
    stroke, such as one trained on a user's own motion, has no early announcements."""

    def __init__(self, states: Sequence[str]) -> None:
        self._state: int | None = None
        has_gestures = {PREPARATION, STROKE} <= set(states)
        self._gesture = [states.index(PREPARATION), states.index(STROKE)] if has_gestures else []

    def changed(self, scores: FloatArray) -> int | None:
        """The newly announced state by the scores of all states (`LiveDecoder.scores`); None if it is unchanged."""
        state, best = self._state, int(scores.argmax())
        if state is None or scores[best] - scores[state] > LEAD:
            state = best
        if self._gesture and state not in self._gesture and self._state != self._gesture[1]:
            kept = EARLY + LEAD if self._state == self._gesture[0] else EARLY
            state = self._gesture[0] if scores[self._gesture].max() > scores[state] - kept else state
        changed = state != self._state
        self._state = state
        return state if changed else None
