"""Places behaviours of the table on the stream's clock as soon as possible, and adjusts them to what is heard later.
Times are seconds of the stream."""

from dataclasses import dataclass, replace
from math import inf
from random import Random

from ..behavior.characters.overlays import Character
from ..behavior.table.behavior_table import STROKED, BehaviorEntry
from ..behavior.timing.phases import Placing, Window, placed
from ..model import Behavior, Channel

LEAST_PRIORITY = 0.1
_HURRY = 0.5
"""How far hurried phases lie between the usual (0) and the shortest (1)."""


@dataclass(slots=True)
class Placer:
    """Draws behaviours of a character and numbers them; deterministic by the seed."""

    character: Character
    seed: int
    generator: Random
    made: int = 0

    @classmethod
    def of(cls, character: Character, seed: int) -> "Placer":
        return cls(character, seed, Random(f"{seed} live"))

    def drawn(self, names: tuple[str, ...]) -> BehaviorEntry:
        """One of the character's behaviours of these names."""
        return self.character.entries[self.generator.choice(names)]

    def soon(self, entry: BehaviorEntry, now_s: float, *, hold_s: float = 0.0, reason: str) -> Behavior:
        """The behaviour from now on, slightly hurried, held for `hold_s` or for as long as the table says."""
        self.made += 1
        timing = entry.timing
        before_s = (1 - _HURRY) * timing.preparation.shortest_s + _HURRY * timing.preparation.usual_s
        if entry.channel in STROKED:
            before_s += timing.alignment * timing.stroke.usual_s
        at_s = now_s + before_s
        sync = placed(Placing(timing, at_s, at_s + hold_s, entry.channel in STROKED), Window(now_s, inf))
        assert sync is not None, "there is time for the shortest phases"
        return Behavior(
            id=f"{entry.channel.value}{self.made}",
            kind=entry.channel,
            lexeme=entry.lexeme,
            sync=sync,
            first=0,
            last=0,
            priority=LEAST_PRIORITY,
            hand=entry.hand or (self.character.handedness if entry.channel is Channel.GESTURE else None),
            amount=entry.amount,
            target=entry.target,
            direction=entry.direction,
            repetitions=entry.repetitions,
            reason=reason,
        )


def held_until(behavior: Behavior, relax_s: float) -> Behavior:
    """The same, held until then, with the same retraction; its stroke is never cut."""
    sync = behavior.sync
    assert sync.relax is not None, "what is held relaxes"
    earliest_s = next(each for each in (sync.stroke_end, sync.ready, sync.start) if each is not None)
    relax_s = max(relax_s, earliest_s)
    return replace(behavior, sync=replace(sync, relax=round(relax_s, 3), end=round(relax_s + sync.end - sync.relax, 3)))


def struck_at(behavior: Behavior, at_s: float) -> Behavior:
    """The same with its stroke from then on, and everything after it shifted as much."""
    sync = behavior.sync
    assert sync.stroke_start is not None, "it has a stroke"
    later = sync.shifted(at_s - sync.stroke_start)
    return replace(behavior, sync=replace(later, start=sync.start, ready=sync.ready))
