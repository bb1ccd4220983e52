"""Makes room for edited behaviours: what overlaps them is shortened, starts later or is dropped (paper §3.5).

Edited behaviours keep their place, except that a retraction the author did not move is cut where the next behaviour
begins, as in the choice (`understudy.behavior.timing.conflicts`). Of two edits that overlap, the first wins. Between
two gestures of one hand enough time is left for the transition.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

from ..behavior.timing.conflicts import compete
from ..model import Behavior, Channel, SyncPoints
from ..model.limits.gesture_limits import Forms, transition_times
from ..model.tables.lexemes import GLANCE, LOOK

INSTANT_S = 0.001
"""How long it takes at least to leave a posture: one that ends where it relaxes is held for good."""


@dataclass(frozen=True, slots=True)
class SettledBehavior:
    """A behaviour that has its place. If its end is `free`, its retraction may be cut."""

    behavior: Behavior
    free: bool


def with_room(
    authored: Iterable[SettledBehavior], others: Iterable[Behavior], forms: Callable[[Behavior], Forms]
) -> tuple[Behavior, ...]:
    """All behaviours, without overlaps; those without room are marked as not kept. `others` must not overlap each
    other."""
    placed: tuple[SettledBehavior, ...] = ()
    left: list[Behavior] = []
    for each in authored:
        mine, placed = _among(each, placed, forms)
        if mine.kept:
            placed = (*placed, replace(each, behavior=mine))
        else:
            left.append(mine)
    for other in others:
        mine, placed = _among(SettledBehavior(other, True), placed, forms)
        left.append(mine)
    return (*(each.behavior for each in placed), *left)


def _among(
    newcomer: SettledBehavior, placed: tuple[SettledBehavior, ...], forms: Callable[[Behavior], Forms]
) -> tuple[Behavior, tuple[SettledBehavior, ...]]:
    """The newcomer as it fits among those placed (not kept if it does not fit), and those placed, shortened for it."""
    behavior, settled = newcomer.behavior, list[SettledBehavior]()
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
    """A look aside during an edited head movement is done with the eyes alone; other behaviours are unchanged."""
    apart = behavior.sync.end <= head.sync.start or head.sync.end <= behavior.sync.start
    if apart or (behavior.kind, behavior.lexeme, head.kind) != (Channel.GAZE, LOOK, Channel.HEAD):
        return behavior
    return replace(behavior, lexeme=GLANCE, reason=f"with the eyes alone: the head has its {head.lexeme}")


def _beside(
    behavior: Behavior, other: SettledBehavior, forms: Callable[[Behavior], Forms]
) -> tuple[Behavior, SettledBehavior] | None:
    """A behaviour and one already placed, shortened to fit; None where there is no room for both."""
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
    """The behaviour ending by then: retraction and if necessary hold are cut; None where its stroke ends later."""
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
    """What must not begin before the transition is over: the stroke, or else the ready point."""
    return next(each for each in (sync.stroke_start, sync.ready, sync.start) if each is not None)


def _way_s(first: Behavior, second: Behavior, forms: Callable[[Behavior], Forms]) -> float:
    """How long the transition takes; 0 except between gestures."""
    if first.kind is not Channel.GESTURE or second.kind is not Channel.GESTURE:
        return 0.0
    amounts = first.amount, second.amount
    return transition_times(forms(first), forms(second), amounts=amounts).shortest_s
