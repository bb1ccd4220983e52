"""The schedule of a live stream: behaviours are added, revised, shortened for others and cancelled. Times are seconds
of the stream."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from ..model import Behavior, Channel
from .messages import BehaviorMessage, LiveMessage, WithdrawalMessage
from .placing import held_until

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
