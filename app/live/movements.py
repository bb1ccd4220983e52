"""The behaviours that the voices alone trigger, of the speaker and of a listener. Times are seconds of the stream.

The live gesture model announces the phases of hands, head and brows: at most `LATEST_S` after the sound of their
beginning was heard, as a prediction; the final decision, `DECIDED_S` later, may differ, and is sent only on request.
Where a stroke or its preparation is announced there is a beat, held as long as a hold is; where a movement of head or
brows is, one of these. A beat begun by a preparation strikes when the stroke is announced, at the latest when a
preparation usually ends. A hold is extended a little as long as nothing else is announced: a time to relax that was
sent may be put off, never back but to make way for another movement, and nothing is held for long after the last sound.

The eyes blink at a steady rate and at the ends of phrases and glance away at their beginnings; a listener nods at the
ends of the other's phrases. The rates are those of lines (`behavior/idle`, `head_rates.yaml`).
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ..acoustic.pitch.streaming import LATEST_S as PITCH_LATEST_S
from ..behavior.idle.idle_behaviors import BLINKS_PER_MINUTE
from ..behavior.listeners.listening import SHORTEST_BETWEEN_NODS_S, HeadRates
from ..model import Behavior, FloatArray
from ..prosody_gestures.live_gestures import ANNOUNCED_S, LiveGestures, LivePhase
from ..prosody_gestures.voice_model import VoiceModel
from .agenda import Placer, held_until, struck_at
from .ear import PhraseEdge
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


SHORTEST_BETWEEN_BLINKS_S = 0.8
BLINKS_AT_PHRASE_END = 0.5
LOOKING_AWAY_S = (0.4, 1.4)
LONGEST_DELAY_S = 1.0


@dataclass(slots=True)
class Attention:
    """Decides the movements of eyes and of a listener's head."""

    table: LiveTable
    placer: Placer
    rates: HeadRates
    blink_due_s: float = 1.0
    blinked_s: float = -1.0
    nodded_s: float = -SHORTEST_BETWEEN_NODS_S

    def passed(self, now_s: float) -> Iterator[Behavior]:
        """Blinks that are due."""
        if now_s >= self.blink_due_s:
            yield self._blink(now_s, "blinks now and then")

    def spoken(self, edge: PhraseEdge, now_s: float) -> Iterator[Behavior]:
        """Behaviours when the character begins or ends a phrase."""
        generator = self.placer.generator
        if not edge.begins:
            if now_s > self.blinked_s + SHORTEST_BETWEEN_BLINKS_S and generator.random() < BLINKS_AT_PHRASE_END:
                yield self._blink(now_s, "blinks as the phrase ends")
        elif generator.random() < 1 - self.placer.character.eye_contact:
            hold_s = generator.uniform(*LOOKING_AWAY_S)
            entry = self.placer.drawn(self.table.look_away)
            yield self.placer.soon(entry, now_s, hold_s=hold_s, reason="looks away as the phrase begins")

    def listened(self, edge: PhraseEdge, now_s: float) -> Iterator[Behavior]:
        """Behaviours when the other begins or ends a phrase."""
        generator, rates = self.placer.generator, self.rates
        if edge.begins:
            yield self.placer.soon(
                self.placer.drawn(self.table.look_at), now_s, hold_s=2.0, reason="looks at who begins to talk"
            )
        elif now_s >= self.nodded_s + SHORTEST_BETWEEN_NODS_S and generator.random() < rates.nods_after_pause:
            due_s = edge.at_s + min(max(generator.gauss(rates.delay_s, rates.delay_spread_s), 0.0), LONGEST_DELAY_S)
            self.nodded_s = max(now_s, due_s)
            entry = self.placer.drawn(self.table.listener_nod)
            yield self.placer.soon(entry, self.nodded_s, reason="nods as the other pauses")

    def _blink(self, now_s: float, reason: str) -> Behavior:
        self.blinked_s = now_s
        mean_s = 60 / BLINKS_PER_MINUTE - SHORTEST_BETWEEN_BLINKS_S
        between_s = SHORTEST_BETWEEN_BLINKS_S + self.placer.generator.expovariate(1 / mean_s)
        self.blink_due_s = now_s + between_s
        return self.placer.soon(self.placer.drawn(self.table.blink), now_s, reason=reason)
