"""Blinks, gaze and listener's nods from the voices: blinks at a steady rate and at the ends of phrases, glances away at
their beginnings, nods at the ends of the other's phrases. Times are seconds of the stream; the rates are those of lines
(`behavior/idle`, `head_rates.yaml`).
"""

from collections.abc import Iterator
from dataclasses import dataclass

from ..behavior.idle.idle_behaviors import BLINKS_PER_MINUTE
from ..behavior.listeners.listening import SHORTEST_BETWEEN_NODS_S, HeadRates
from ..model import Behavior
from .agenda import Placer
from .ear import PhraseEdge
from .table import LiveTable

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
