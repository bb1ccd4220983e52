"""Adjusts the speed of transitions between gestures (paper §3.8, Figure 4): as fast as the next stroke, if possible.

Where a gesture joins the next and the transition would be faster than the stroke, its hold ends earlier, because a fast
transition looks as if it meant more than the stroke. That is our addition: the paper accepts transitions that are
faster by no more than v_th. Where the transition would be slower, the realizer prolongs the hold.
"""

from collections.abc import Iterable
from dataclasses import replace

from ...model import Behavior, Channel
from .anchoring import PlacedBehavior
from .conflicts import Kept, compete, transition

SHORTEST_HOLD_S = 0.2
"""The least hold that remains (people's holds last .20 to 1.10 s, docs/references.md)."""


def eased(kept: Kept) -> Kept:
    """The kept behaviours in their order, with transitions between joined gestures as slow as their holds permit."""
    gestures = sorted((each for each in kept if each.behavior.kind is Channel.GESTURE), key=_stroke_start_s)
    by_id: dict[str, Behavior] = {each.behavior.id: each.behavior for each in kept}
    for number, second in enumerate(gestures):
        earlier = [_current(each, by_id) for each in gestures[:number] if compete(each.behavior, second.behavior)]
        by_id |= {each.id: each for each in _eased(_current(second, by_id), earlier)}
    return tuple(_current(each, by_id) for each in kept)


def _current(placed: PlacedBehavior, by_id: dict[str, Behavior]) -> PlacedBehavior:
    return replace(placed, behavior=by_id[placed.behavior.id])


def _stroke_start_s(gesture: PlacedBehavior) -> float:
    sync = gesture.behavior.sync
    return sync.start if sync.stroke_start is None else sync.stroke_start


def _eased(second: PlacedBehavior, earlier: Iterable[PlacedBehavior]) -> Iterable[Behavior]:
    """The second gesture, beginning when the first may relax, and those that it joins."""
    start_s = second.behavior.sync.start
    joined = [each for each in earlier if each.behavior.sync.end == start_s]
    relax_s = max((_relax_s(each, second) for each in joined), default=start_s)
    if relax_s >= start_s or any(each.behavior.sync.end > relax_s for each in earlier if each not in joined):
        return
    yield replace(second.behavior, sync=replace(second.behavior.sync, start=relax_s))
    for first in joined:
        sync = first.behavior.sync
        relaxed = replace(sync, relax=min(sync.end if sync.relax is None else sync.relax, relax_s), end=relax_s)
        yield replace(first.behavior, sync=relaxed)


def _relax_s(first: PlacedBehavior, second: PlacedBehavior) -> float:
    """When the first gesture should relax so that its hand moves as fast as the second's stroke, with some of its hold
    left."""
    sync = first.behavior.sync
    relax_s = sync.end if sync.relax is None else sync.relax
    held_s = relax_s if sync.stroke_end is None else min(relax_s, sync.stroke_end + SHORTEST_HOLD_S)
    return round(max(held_s, min(relax_s, _stroke_start_s(second) - transition(first, second).equal_s)), 3)
