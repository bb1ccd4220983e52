"""Hands, head and brows by what the voice announces: a beat where a stroke or its preparation is announced, held as
long as a hold is, a movement of the head or the brows where one is. Times are seconds of the stream.

A hold is extended a little as long as nothing else is announced: a time to relax that was sent may be put off,
never back but to make way for another movement, and nothing is held for long after the last sound.

A beat begun by a preparation strikes when the stroke is announced, at the latest when a preparation usually ends.

Events of the live gesture model: one when a phase of hands, head or brows begins.

Times are seconds from the start of the sound. An event is sent at most `LATEST_S` after its sound was heard, as a
prediction; the final decision, `DECIDED_S` later, may differ, and is sent only on request.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ..acoustic.pitch.streaming import LATEST_S as PITCH_LATEST_S
from ..model import Behavior, FloatArray
from ..prosody_gestures.live_gestures import ANNOUNCED_S, LiveGestures, LivePhase
from ..prosody_gestures.voice_model import VoiceModel
from .agenda import Placer, held_until, struck_at
from .table import LiveTable

PREPARATION_S = 0.48
"""How long the model's preparations last on average."""

LONGEST_HOLD_S = 2.0

HELD_AHEAD_S = 0.4
"""How far ahead a hold is announced; it is sent again when half of that has passed."""

_HOLD_S = 0.25
"""How long a beat is held about which nothing more is heard."""

_APART, _FEWEST_PER_MINUTE = 20.0, 1.0
"""No beat begins sooner after another's stroke than so many seconds over the character's gestures a minute, a third of
its usual distance."""


@dataclass(frozen=True, slots=True)
class LiveEvent:
    """`part` ("hands", "head", "brows") enters `state` at `start_s`; sent when `heard_s` had been heard. Decided events
    are final; others are predictions and may be revised."""

    part: str
    state: str
    start_s: float
    heard_s: float
    decided: bool = False


@dataclass(slots=True)
class Movements:
    """Behaviours by announcements, new ones and the last of a part as it changes. `prepared` tells that the last beat
    was begun by a preparation whose stroke has not been announced, `holds_until_s` how long it is held at most."""

    table: LiveTable
    placer: Placer
    hands: Behavior | None = None
    brows: Behavior | None = None
    prepared: bool = False
    holds_until_s: float = 0.0

    def moved(self, event: LiveEvent, now_s: float) -> Iterator[Behavior]:
        """The behaviours that follow from an announcement."""
        parts = {"hands": self._hands, "head": self._head, "brows": self._brows}
        yield from parts[event.part](event.state, now_s)

    def passed(self, now_s: float) -> Iterator[Behavior]:
        """What is held a little longer, now that so much time has passed."""
        if self.hands is not None and (longer := _longer(self.hands, now_s, self.holds_until_s)):
            self.hands = longer
            yield longer
        if self.brows is not None and (longer := _longer(self.brows, now_s, self.brows.sync.start + LONGEST_HOLD_S)):
            self.brows = longer
            yield longer

    def release(self) -> None:
        """The voice has ended: holds are not extended any more."""
        self.brows, self.holds_until_s = None, 0.0

    def forget(self) -> None:
        """Nothing that was begun goes on."""
        self.hands, self.brows, self.prepared, self.holds_until_s = None, None, False, 0.0

    def _hands(self, state: str, now_s: float) -> Iterator[Behavior]:
        if state == "preparation":
            yield from self._beaten(now_s, PREPARATION_S, "the voice sounds like the preparation of a stroke")
        elif state == "stroke" and self.prepared:
            self.prepared = False
            yield from self._struck(now_s)
        elif state == "stroke":
            yield from self._beaten(now_s, 0.0, "the voice sounds like a stroke")
        else:
            self.prepared = False
            self.holds_until_s = now_s + LONGEST_HOLD_S if state == "hold" else 0.0
            yield from self.passed(now_s)

    def _beaten(self, now_s: float, preparation_s: float, reason: str) -> Iterator[Behavior]:
        """A beat from now on, unless one is being made."""
        before = self.hands
        apart_s = _APART / max(self.placer.character.gestures_per_minute, _FEWEST_PER_MINUTE)
        if before is not None and now_s < (before.sync.stroke_end or 0.0) + apart_s:
            return
        if before is not None and before.sync.end > now_s:
            yield held_until(before, now_s)
        beat = self.placer.soon(self.placer.drawn(self.table.hands), now_s, hold_s=_HOLD_S, reason=reason)
        self.hands = struck_at(beat, max(now_s + preparation_s, beat.sync.ready or 0.0))
        self.prepared, self.holds_until_s = preparation_s > 0, 0.0
        yield self.hands

    def _struck(self, now_s: float) -> Iterator[Behavior]:
        """The beat that was prepared, now or as soon as the hand is there; what that gains it is held."""
        beat = self.hands
        if beat is not None and (beat.sync.stroke_start or 0.0) > now_s:
            sooner = struck_at(beat, max(now_s, beat.sync.ready or 0.0))
            self.hands = held_until(sooner, beat.sync.relax or 0.0)
            yield self.hands

    def _head(self, state: str, now_s: float) -> Iterator[Behavior]:
        names = {"nod": self.table.nod, "shake": self.table.shake, "tilt": self.table.tilt, "turn": self.table.turn}
        if state in names:
            yield self.placer.soon(self.placer.drawn(names[state]), now_s, hold_s=0.4, reason=f"sounds like a {state}")

    def _brows(self, state: str, now_s: float) -> Iterator[Behavior]:
        before, names = self.brows, {"raised": self.table.raised, "lowered": self.table.lowered}
        self.brows = None
        if state in names:
            if before is not None and before.sync.relax is not None and before.sync.relax > now_s:
                yield held_until(before, now_s)
            reason = f"sounds as if brows were {state}"
            entry = self.placer.drawn(names[state])
            self.brows = self.placer.soon(entry, now_s, hold_s=HELD_AHEAD_S, reason=reason)
            yield self.brows


def _longer(held: Behavior, now_s: float, until_s: float) -> Behavior | None:
    """The same, held some more, where it is time to say so; None where it is not, or it relaxes already."""
    relax_s, wanted_s = held.sync.relax, min(now_s + HELD_AHEAD_S, until_s)
    if relax_s is None or not now_s < relax_s < min(now_s + HELD_AHEAD_S / 2, wanted_s):
        return None
    return held_until(held, wanted_s)


LATEST_S = PITCH_LATEST_S + ANNOUNCED_S


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

    def _told(self, phases: Iterable[LivePhase], heard_s: float) -> tuple[LiveEvent, ...]:
        return tuple(
            LiveEvent(phase.part, phase.state, phase.start_s, heard_s, phase.decided)
            for phase in phases
            if phase.begins and phase.decided is self._decided
        )
