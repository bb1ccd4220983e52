"""Decides which listener the speaker addresses, and where listeners are, if there are several or the scene places one.

The input does not say to whom each sentence is addressed, so the speaker turns to the next listener when another
sentence begins, in the order in which they were named. Listeners without a target stand in an arc before the speaker,
with their eyes at average height, each at the distance of a conversation of two, or farther where they would touch.
Metres, seconds.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import cos, pi, radians, sin

from ...model import Behavior, Channel, Target
from ...model.tables import SHIFT
from ...model.targets import LISTENER

DISTANCE_M = 1.25
EYES_M = 1.60
"""The default distance and eye height of a single listener (`understudy.realizer.head_and_gaze.gaze_targets`)."""

BETWEEN_DEG, WIDEST_DEG = 36.0, 120.0
ELBOW_ROOM_M = 0.70
"""The least distance between people who stand side by side."""

AT_THE_LISTENER = frozenset({"YOU", "OFFER"})
"""Gestures towards the person addressed."""


def placed_listeners(names: Sequence[str], targets: Sequence[Target]) -> tuple[Target, ...]:
    """The targets, and a place for each listener that has none, if there are several or the scene places one.

    Listeners without a place are distributed over the arc, the first on the speaker's left.
    """
    known = {target.name for target in targets}
    if len(names) < 2 and not known.intersection(names):
        return tuple(targets)
    unplaced = [name for name in names if name not in known]
    return (*targets, *(Target(name, place) for name, place in zip(unplaced, _arc(len(unplaced)), strict=True)))


def _arc(count: int) -> list[tuple[float, float, float]]:
    if count == 1:
        return [(0.0, EYES_M, DISTANCE_M)]
    between = radians(min(BETWEEN_DEG, WIDEST_DEG / max(count - 1, 1)))
    distance_m = max(DISTANCE_M, ELBOW_ROOM_M / (2 * sin(between / 2)))
    angles = [between * ((count - 1) / 2 - number) for number in range(count)]
    assert all(abs(angle) < pi / 2 for angle in angles), "all are before the speaker"
    return [(round(distance_m * sin(angle), 3), EYES_M, round(distance_m * cos(angle), 3)) for angle in angles]


def addressed(
    behaviors: Sequence[Behavior], listeners: Sequence[str], targets: Sequence[Target]
) -> tuple[Behavior, ...]:
    """The behaviours, those directed at the listener now directed at the addressee of their time; unchanged if no
    listener has a place."""
    known = {target.name for target in targets}
    placed = [name for name in listeners if name in known]
    if not placed:
        return tuple(behaviors)
    turns_s = [each.sync.start for each in behaviors if each.kept and _turns(each)]

    def addressee(time_s: float) -> str:
        turned = sum(turn_s <= time_s for turn_s in turns_s)
        return placed[max(0, turned - 1) % len(placed)]

    return tuple(
        replace(each, target=addressee(each.sync.start)) if _at_the_listener(each) else each for each in behaviors
    )


def _turns(behavior: Behavior) -> bool:
    return behavior.kind is Channel.GAZE and behavior.lexeme == SHIFT and behavior.target == LISTENER


def _at_the_listener(behavior: Behavior) -> bool:
    if behavior.kind is Channel.GESTURE:
        return behavior.lexeme in AT_THE_LISTENER and behavior.target is None
    return behavior.kind is Channel.GAZE and behavior.target == LISTENER
