"""What pointing hands point at.

Conventions: places in the world, metres (`app.realizer.skeleton`). Where the other of the talk is, the gaze says
(`app.realizer.looks`); hands point lower than eyes look.
"""

from collections.abc import Mapping
from dataclasses import replace

from app.realizer.gesture_plan import Placed, Position
from app.realizer.looks import LISTENER_M
from app.realizer.motion import Decision

LISTENER = "listener"
BELOW_THE_EYES_M = 0.35
"""Who is pointed at is pointed at at the chest."""
AT_THE_LISTENER = frozenset({"YOU", "OFFER"})
"""Categories that mean the listener, whether a target is named or not."""


def aimed(placed: Placed, targets_m: Mapping[str, Position]) -> tuple[Placed, tuple[Decision, ...]]:
    """The gesture with what it points at; a target whose place nobody has said leaves it as it is defined."""
    target = placed.request.target or (LISTENER if placed.clip.category in AT_THE_LISTENER else None)
    if target is None or not placed.clip.aimed:
        return placed, ()
    if target in targets_m:
        return replace(placed, aim_m=targets_m[target]), ()
    if target == LISTENER:
        x, y, z = LISTENER_M
        return replace(placed, aim_m=(x, y - BELOW_THE_EYES_M, z)), ()
    reason = f"where {target!r} is nobody has said: it points as {placed.clip.name} is defined"
    return placed, (Decision(placed.request.behavior, "replaced", reason),)
