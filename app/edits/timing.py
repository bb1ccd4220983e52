"""Moves sync points as an author asked, and makes room for edited behaviours. Times are seconds, whole milliseconds.

The other points follow and keep their order. As in BML edited by hand (`understudy.bml.reading.reader`), strokes
are never stretched: moving `stroke`, `stroke_end`, `stroke_start` or `ready` moves the whole behaviour. `start` and
`relax` move alone, which lengthens or shortens the preparation or the hold, and `end` moves with `relax`. A behaviour
without a stroke moves with `ready`. Nothing begins before 0, no stroke ends after `end_s`.

What overlaps edited behaviours is shortened, starts later or is dropped (paper §3.5). They keep their place, except
that a retraction the author did not move is cut where the next behaviour begins, as in the choice
(`understudy.behavior.timing.conflicts`). Of two edits that overlap, the first wins. Between two gestures of one hand
enough time is left for the transition.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from ..behavior.timing.conflicts import compete
from ..model import Behavior, Channel, SyncPoints, Word
from ..model.edits import MARKS, Edge, MarkPlace
from ..model.limits import Forms, transition_times
from ..model.tables import GLANCE, LOOK
from .words import find_word

_LEADING = ("stroke", "stroke_end", "stroke_start", "ready")
"""The first of these that was moved takes the others with it."""

_STROKE = ("stroke_start", "stroke", "stroke_end")
_TOLERANCE_S = 0.0015
"""Times are rounded to milliseconds, twice."""


@dataclass(frozen=True, slots=True)
class MovedPoints:
    """The sync points after the move, and those that could not be moved all the way, with the time asked for."""

    sync: SyncPoints
    refused: tuple[tuple[str, float], ...] = ()


def place_s(place: MarkPlace, words: Sequence[Word]) -> float | None:
    """The time of a place, on the clock of the words; None if its word is gone or not spoken."""
    index = find_word(place.at, words)
    interval = None if index is None else words[index].interval
    if interval is None:
        return None
    return (interval.start_s if place.edge is Edge.START else interval.end_s) + place.offset_s


def moved(sync: SyncPoints, wanted_s: Mapping[str, float], *, end_s: float, lasting: bool = False) -> MovedPoints:
    """The sync points with those named in `wanted_s` moved there; names the behaviour does not have are ignored.

    A `lasting` behaviour changes a state and is over once that is reached, so its last three points coincide.
    """
    points = dict(sync.in_order())
    wanted_s = {name: round(at_s, 3) for name, at_s in wanted_s.items() if name in points}
    if lasting and "end" in wanted_s:
        wanted_s["ready"] = wanted_s.pop("end")
    points = _with_leading(points, wanted_s)
    if "start" in wanted_s:
        points["start"] = wanted_s["start"]
    if "relax" in wanted_s and "end" in points:
        points["end"] += wanted_s["relax"] - points["relax"]
        points["relax"] = wanted_s["relax"]
    if "end" in wanted_s:
        points["end"] = wanted_s["end"]
    if lasting:
        points |= dict.fromkeys(("relax", "end"), points["ready"]) if "ready" in points else {}
    points = _in_order(_within(points, end_s))
    refused = tuple((name, at_s) for name, at_s in wanted_s.items() if abs(points[name] - at_s) > _TOLERANCE_S)
    return MovedPoints(replace(sync, **{name: round(at_s, 3) + 0.0 for name, at_s in points.items()}), refused)


def _with_leading(points: dict[str, float], wanted_s: Mapping[str, float]) -> dict[str, float]:
    leading = next((name for name in _LEADING if name in wanted_s), None)
    if leading is None:
        return points
    later_s = wanted_s[leading] - points[leading]
    return {name: at_s + later_s for name, at_s in points.items()}


def _within(points: dict[str, float], end_s: float) -> dict[str, float]:
    """The points shifted together so that the stroke, or else the ready point, lies within the line."""
    held = [points[name] for name in (*_STROKE, "ready") if name in points] or [points["start"]]
    later_s = max(0.0, -min(held)) or min(0.0, end_s - max(held))
    return {name: max(0.0, at_s + later_s) for name, at_s in points.items()}


def _in_order(points: dict[str, float]) -> dict[str, float]:
    """The points in their order; the stroke, or else the ready point, stays where it is."""
    fixed = [name for name in (*_STROKE, "ready") if name in points]
    names = [name for name in MARKS if name in points]
    first = min((names.index(name) for name in fixed), default=0)
    for place in range(first - 1, -1, -1):
        points[names[place]] = min(points[names[place]], points[names[place + 1]])
    for place in range(first + 1, len(names)):
        points[names[place]] = max(points[names[place]], points[names[place - 1]])
    return points


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
    return replace(behavior, lexeme=GLANCE, reason=f"with the eyes alone: the head makes a {head.lexeme}")


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
    return replace(behavior, sync=sync, reason=behavior.reason or f"shortened to make room for {beside.lexeme}")


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
