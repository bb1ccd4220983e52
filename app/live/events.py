"""Events of the live gesture model: one when a phase of hands, head or brows begins.

Times are seconds from the start of the sound. An event is sent at most `LATEST_S` after its sound was heard, as a
prediction; the final decision, `DECIDED_S` later, may differ, and is sent only on request.
"""

from collections.abc import Iterable
from dataclasses import dataclass

from ..acoustic.pitch.streaming import LATEST_S as PITCH_LATEST_S
from ..model import FloatArray
from ..prosody_gestures.live_gestures import ANNOUNCED_S, DECIDED_S, LiveGestures, Phase
from ..prosody_gestures.voice_model import VoiceModel

LATEST_S = PITCH_LATEST_S + ANNOUNCED_S
DECIDED_LATEST_S = PITCH_LATEST_S + DECIDED_S


@dataclass(frozen=True, slots=True)
class LiveEvent:
    """`part` ("hands", "head", "brows") enters `state` at `start_s`; sent when `heard_s` had been heard. Decided events
    are final; others are predictions and may be revised."""

    part: str
    state: str
    start_s: float
    heard_s: float
    decided: bool = False


class LiveEvents:
    """Takes contours, a row each `FRAME_SHIFT_S`, and gives the events: predictions or, if `decided`, final ones.
    Memory is bounded."""

    def __init__(self, model: VoiceModel, *, decided: bool = False) -> None:
        self._gestures, self._decided = LiveGestures(model), decided

    def hear(self, energy_db: FloatArray, f0_hz: FloatArray, heard_s: float) -> tuple[LiveEvent, ...]:
        """The events of more energy and f0, when `heard_s` of the sound have been heard."""
        return self._told(self._gestures.hear(energy_db, f0_hz), heard_s)

    def finish(self, heard_s: float) -> tuple[LiveEvent, ...]:
        """The remaining events, when the sound has ended."""
        return self._told(self._gestures.finish(), heard_s)

    def _told(self, phases: Iterable[Phase], heard_s: float) -> tuple[LiveEvent, ...]:
        return tuple(
            LiveEvent(phase.part, phase.state, phase.start_s, heard_s, phase.decided)
            for phase in phases
            if phase.begins and phase.decided is self._decided
        )
