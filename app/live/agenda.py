"""The schedule of a live stream: behaviours of the table are placed on the stream's clock as soon as possible, adjusted
to what is heard later, shortened for others and cancelled. Times are seconds of the stream.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from math import inf
from random import Random

from ..behavior.characters.overlays import Character
from ..behavior.table.behavior_table import STROKED, BehaviorEntry
from ..behavior.timing.phases import TimingBasis, Window, placed
from ..model import Behavior, Channel
from .messages import BehaviorMessage, LiveMessage, WithdrawalMessage

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
        sync = placed(TimingBasis(timing, at_s, at_s + hold_s, entry.channel in STROKED), Window(now_s, inf))
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


REMEMBERED_S = 4.0
"""How long after its end a behaviour is kept: as far back as a take of the body begins."""


WORDED = "words"
"""The prefix of the ids of behaviours that come from words."""


@dataclass(slots=True)
class Agenda:
    """The current and recent behaviours by id."""

    by_id: dict[str, Behavior] = field(default_factory=dict)

    @property
    def behaviors(self) -> tuple[Behavior, ...]:
        return tuple(self.by_id.values())

    def keep(self, behaviors: Iterable[Behavior], now_s: float) -> Iterator[LiveMessage]:
        """Adds behaviours, or replaces those of the same ids."""
        for each in behaviors:
            before = self.by_id.get(each.id)
            if before != each:
                self.by_id[each.id] = each
                yield BehaviorMessage(each, now_s, revised=before is not None)

    def beside(self, coming: Iterable[Behavior]) -> tuple[Behavior, ...]:
        """The behaviours whose channel is not taken by earlier words, which keep what they announced."""
        worded = [each for each in self.behaviors if each.id.startswith(WORDED)]
        return tuple(each for each in coming if not any(_overlap(each, other) for other in worded))

    def make_way(self, coming: Iterable[Behavior], now_s: float) -> Iterator[LiveMessage]:
        """Behaviours on a channel that others need from some moment on retract before it, or are cancelled."""
        needed_s: dict[Channel, float] = {}
        for each in coming:
            needed_s[each.kind] = min(each.sync.start, needed_s.get(each.kind, each.sync.start))
        for before in self.behaviors:
            at_s = needed_s.get(before.kind)
            if at_s is None or before.sync.end <= at_s:
                continue
            if before.sync.start >= min(at_s, now_s + 1e-9):
                yield self._given_up(before, now_s)
            elif before.sync.relax is not None:
                relax_s = max(now_s, at_s - (before.sync.end - before.sync.relax))
                yield from self.keep([held_until(before, relax_s)], now_s)

    def give_up(self, now_s: float) -> Iterator[LiveMessage]:
        """Cancels everything that is not over."""
        yield from [self._given_up(each, now_s) for each in self.behaviors if each.sync.end > now_s]

    def forget(self, now_s: float) -> None:
        """Drops behaviours that ended more than `REMEMBERED_S` ago."""
        for each in self.behaviors:
            if each.sync.end < now_s - REMEMBERED_S:
                del self.by_id[each.id]

    def _given_up(self, behavior: Behavior, now_s: float) -> WithdrawalMessage:
        del self.by_id[behavior.id]
        return WithdrawalMessage(behavior.id, now_s)


def _overlap(one: Behavior, other: Behavior) -> bool:
    return one.kind is other.kind and one.sync.start < other.sync.end and other.sync.start < one.sync.end
