"""What the body is to do: behaviours as they come, change, make way and are given up. Times are seconds of the
stream."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from ..model import Behavior, Channel
from .placing import held_until
from .telling import Moved, Told, Withdrawn

REMEMBERED_S = 4.0
"""How long after its end a behaviour is remembered: as long as a body's clock goes back."""


WORDED = "words"
"""What the ids of behaviours begin with that words asked for."""


@dataclass(slots=True)
class Agenda:
    """The behaviours that are not long over, by their ids."""

    by_id: dict[str, Behavior] = field(default_factory=dict)

    @property
    def behaviors(self) -> tuple[Behavior, ...]:
        return tuple(self.by_id.values())

    def keep(self, behaviors: Iterable[Behavior], now_s: float) -> Iterator[Told]:
        """Takes behaviours, new ones and others as they are now."""
        for each in behaviors:
            before = self.by_id.get(each.id)
            if before != each:
                self.by_id[each.id] = each
                yield Moved(each, now_s, revised=before is not None)

    def beside(self, coming: Iterable[Behavior]) -> tuple[Behavior, ...]:
        """Those that no words asked for before need their channel: what was promised stays."""
        worded = [each for each in self.behaviors if each.id.startswith(WORDED)]
        return tuple(each for each in coming if not any(_overlap(each, other) for other in worded))

    def make_way(self, coming: Iterable[Behavior], now_s: float) -> Iterator[Told]:
        """What is on a channel that others need from some moment on relaxes in time, or is not done at all."""
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

    def give_up(self, now_s: float) -> Iterator[Told]:
        """Whatever is not over is not done any more."""
        yield from [self._given_up(each, now_s) for each in self.behaviors if each.sync.end > now_s]

    def forget(self, now_s: float) -> None:
        """Drops what has been over for long."""
        for each in self.behaviors:
            if each.sync.end < now_s - REMEMBERED_S:
                del self.by_id[each.id]

    def _given_up(self, behavior: Behavior, now_s: float) -> Withdrawn:
        del self.by_id[behavior.id]
        return Withdrawn(behavior.id, now_s)


def _overlap(one: Behavior, other: Behavior) -> bool:
    return one.kind is other.kind and one.sync.start < other.sync.end and other.sync.start < one.sync.end
