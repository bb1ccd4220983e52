"""Room for what an author put somewhere: what is in its way ends earlier, begins later, or goes (paper §3.5).

What the author changed stays where it is, except that a retraction nobody asked for gives way to what comes next, as in
the choice (`understudy.bml.choice.timing.conflicts`). Of two edits in each other's way the first stands. Between two
gestures of a hand the time is left that the way takes.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

from ..bml.choice.behavior_table.table import GLANCE, LOOK
from ..bml.choice.timing.conflicts import compete
from ..gesture_limits import Forms, transition_times
from ..model import Behavior, Channel, SyncPoints

INSTANT_S = 0.001
"""A posture that is left is left for an instant at least, lest it lasts."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A behaviour that has its place; one whose end is `free` lets its retraction go."""

    behavior: Behavior
    free: bool


def with_room(
    authored: Iterable[Placed], others: Iterable[Behavior], forms: Callable[[Behavior], Forms]
) -> tuple[Behavior, ...]:
    """All of them, no two of them in each other's way; those that have no room are no longer kept. `others` do not
    compete among each other."""
    placed: tuple[Placed, ...] = ()
    left: list[Behavior] = []
    for each in authored:
        mine, placed = _among(each, placed, forms)
        if mine.kept:
            placed = (*placed, replace(each, behavior=mine))
        else:
            left.append(mine)
    for other in others:
        mine, placed = _among(Placed(other, True), placed, forms)
        left.append(mine)
    return (*(each.behavior for each in placed), *left)


def _among(
    newcomer: Placed, placed: tuple[Placed, ...], forms: Callable[[Behavior], Forms]
) -> tuple[Behavior, tuple[Placed, ...]]:
    """The newcomer as it fits among the placed, no longer kept if it does not, and the placed beside it."""
    behavior, settled = newcomer.behavior, list[Placed]()
    for other in placed:
        if compete(behavior, other.behavior):
            behavior = _with_the_eyes_alone(behavior, other.behavior)
        pair = _beside(behavior, other, forms) if compete(behavior, other.behavior) else (behavior, other)
        if pair is None:
            reason = f"too close to {other.behavior.lexeme}, which the author put there"
            return replace(behavior, kept=False, lost_to=other.behavior.id, reason=reason), placed
        behavior, beside = pair
        settled.append(beside)
    return behavior, tuple(settled)


def _with_the_eyes_alone(behavior: Behavior, head: Behavior) -> Behavior:
    """A look aside while the author has the head move; everything else as it is."""
    apart = behavior.sync.end <= head.sync.start or head.sync.end <= behavior.sync.start
    if apart or (behavior.kind, behavior.lexeme, head.kind) != (Channel.GAZE, LOOK, Channel.HEAD):
        return behavior
    return replace(behavior, lexeme=GLANCE, reason=f"with the eyes alone: the head has its {head.lexeme}")


def _beside(behavior: Behavior, other: Placed, forms: Callable[[Behavior], Forms]) -> tuple[Behavior, Placed] | None:
    """A behaviour and one that has its place; None where there is no room for both."""
    beside = other.behavior
    if _struck_s(behavior.sync) <= _struck_s(beside.sync):
        limit_s = min(beside.sync.start, _stroke_start_s(beside.sync) - _way_s(behavior, beside, forms))
        over = _over_by(behavior, limit_s, beside)
        return None if over is None else (over, other)
    limit_s = _stroke_start_s(behavior.sync) - _way_s(beside, behavior, forms)
    if beside.sync.end > limit_s:
        relax_s = beside.sync.end if beside.sync.relax is None else beside.sync.relax
        let_go = _over_by(beside, limit_s, behavior) if other.free and relax_s <= limit_s else None
        if let_go is None:
            return None
        other, beside = replace(other, behavior=let_go), let_go
    return _begun_after(behavior, beside), other


def _over_by(behavior: Behavior, limit_s: float, beside: Behavior) -> Behavior | None:
    """The behaviour over by then, without its retraction and if need be its hold; None where its stroke is later."""
    sync = behavior.sync
    if sync.end <= limit_s:
        return behavior
    firm_s = next(each for each in (sync.stroke_end, sync.ready, sync.start) if each is not None)
    longest_s = limit_s - INSTANT_S if behavior.kind is Channel.POSTURE else limit_s
    if firm_s > longest_s or limit_s <= sync.start:
        return None
    end_s = round(limit_s, 3)
    relax_s = None if sync.relax is None else round(min(sync.relax, longest_s), 3)
    return _shortened(behavior, replace(sync, relax=relax_s, end=end_s), beside)


def _begun_after(behavior: Behavior, beside: Behavior) -> Behavior:
    if behavior.sync.start >= beside.sync.end:
        return behavior
    return _shortened(behavior, replace(behavior.sync, start=beside.sync.end), beside)


def _shortened(behavior: Behavior, sync: SyncPoints, beside: Behavior) -> Behavior:
    return replace(behavior, sync=sync, reason=behavior.reason or f"shortened beside {beside.lexeme}")


def _struck_s(sync: SyncPoints) -> float:
    return next(each for each in (sync.stroke, sync.ready, sync.start) if each is not None)


def _stroke_start_s(sync: SyncPoints) -> float:
    """What must not begin before the way there is over; the state that is reached where there is no stroke."""
    return next(each for each in (sync.stroke_start, sync.ready, sync.start) if each is not None)


def _way_s(first: Behavior, second: Behavior, forms: Callable[[Behavior], Forms]) -> float:
    """The time from one to the next: none but between gestures."""
    if first.kind is not Channel.GESTURE or second.kind is not Channel.GESTURE:
        return 0.0
    amounts = first.amount, second.amount
    return transition_times(forms(first), forms(second), amounts=amounts).shortest_s
