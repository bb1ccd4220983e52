"""Finds the targets of pointing gestures.

Conventions: world positions in metres (`understudy.realizer.body.skeleton`). The listener's position is that of the
gaze (`understudy.realizer.head_and_gaze.gaze_targets`), but hands point lower than eyes look.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from ..body.motion import Decision
from ..gestures.gesture_plan import PlacedGesture, Position
from .gaze_targets import LISTENER_M

LISTENER = "listener"
BELOW_THE_EYES_M = 0.35
"""Pointing at a person aims at the chest."""
AT_THE_LISTENER = "YOU"
"""The category that points at the listener, with or without a named target."""


def with_target(placed: PlacedGesture, targets_m: Mapping[str, Position]) -> PlacedGesture:
    """The gesture with its target position; if the target's position is unknown, the gesture as defined."""
    at_a_person = placed.clip.category == AT_THE_LISTENER
    target = placed.request.target or (LISTENER if at_a_person else None)
    if target is None or not placed.clip.aimed:
        return placed
    aim_m = targets_m.get(target, LISTENER_M if target == LISTENER else None)
    if aim_m is not None and (at_a_person or target == LISTENER):
        x, y, z = aim_m
        aim_m = (x, y - BELOW_THE_EYES_M, z)
    return replace(placed, aim_m=aim_m)


def unknown_target(placed: PlacedGesture) -> Iterator[Decision]:
    """A decision for a pointing gesture whose target has no known position."""
    if placed.clip.aimed and placed.request.target and placed.aim_m is None:
        where = f"where {placed.request.target!r} is nobody has said"
        yield Decision(placed.request.behavior, "replaced", f"{where}: it points as {placed.clip.name} is defined")
