"""Contours in as they are heard, gesture phases out as they are decided.

What is decided of a frame leaves at the latest `LATEST_S` after it was heard: the frame's window, the look-ahead of its
context, and the decoder's bound.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..model import FRAME_SHIFT_S, FloatArray
from .context import LOOKAHEAD_S, ProsodyContext
from .live_decoder import Commitment, LiveDecoder, Piece
from .prosody import HALF_WINDOW_S, ProsodyNormalizer, raw_frame, whole_frames
from .semi_markov import FRAME_S
from .trellis import EVERYTHING, Search
from .voice_model import VoiceModel

BOUND_S = 0.2
COMMITMENT = Commitment(bound_frames=round(BOUND_S / FRAME_S), at_once=4, beam=8.0)
LATEST_S = HALF_WINDOW_S + LOOKAHEAD_S + BOUND_S


@dataclass(frozen=True, slots=True)
class Phase:
    """A decided stretch of a part's path: `state` of `part`, from `start_s` to `end_s`. Where it does not
    `begin`, the one before goes on."""

    part: str
    state: str
    start_s: float
    end_s: float
    begins: bool


class LiveGestures:
    """What hands, head and brows do, from a voice that still goes on. Memory does not grow."""

    def __init__(self, model: VoiceModel, search: Search = EVERYTHING, commitment: Commitment = COMMITMENT) -> None:
        self._parts = [(part, LiveDecoder(part.model, search, commitment)) for part in model.parts]
        self._normalizer, self._context = ProsodyNormalizer(), ProsodyContext()
        self._levels_db, self._pitches_hz = np.empty(0), np.empty(0)
        self._base = self._frames = 0

    def hear(self, energy_db: FloatArray, f0_hz: FloatArray) -> tuple[Phase, ...]:
        """What is decided by more of the contours (a row each `FRAME_SHIFT_S`; f0 is 0 where unvoiced)."""
        self._levels_db = np.concatenate([self._levels_db, energy_db])
        self._pitches_hz = np.concatenate([self._pitches_hz, f0_hz])
        phases = [phase for _ in iter(self._next_frame, False) for phase in self._decided_by_frame()]
        done = max(0, int((self._frames * FRAME_S - HALF_WINDOW_S) / FRAME_SHIFT_S) - self._base - 1)
        self._levels_db, self._pitches_hz = self._levels_db[done:], self._pitches_hz[done:]
        self._base += done
        return tuple(phases)

    def finish(self) -> tuple[Phase, ...]:
        """The rest, when the voice has ended."""
        phases = [phase for row in self._context.finish() for phase in self._decided(row)]
        for part, decoder in self._parts:
            phases += [_phase(part.part, part.model.states, piece) for piece in decoder.finish()]
        return tuple(phases)

    def _next_frame(self) -> bool:
        return self._frames < whole_frames(self._base + len(self._pitches_hz))

    def _decided_by_frame(self) -> Iterator[Phase]:
        raw = raw_frame(self._levels_db, self._pitches_hz, self._frames, self._base)
        self._frames += 1
        row = self._context.push(np.array(self._normalizer.push(*raw)))
        if row is not None:
            yield from self._decided(row)

    def _decided(self, row: FloatArray) -> Iterator[Phase]:
        for part, decoder in self._parts:
            for piece in decoder.push(part.log_likelihoods(row[None])[0]):
                yield _phase(part.part, part.model.states, piece)


def _phase(part: str, states: tuple[str, ...], piece: Piece) -> Phase:
    segment = piece.segment
    return Phase(part, states[segment.state], segment.start * FRAME_S, segment.end * FRAME_S, piece.begins)
