"""Reports behaviours that no controller can play as scheduled: unknown movements, unknown targets, too little time."""

from collections.abc import Mapping
from types import MappingProxyType

from ...model import Behavior, Channel, Schedule
from ..body.motion import Decision
from ..head_and_gaze.gaze_targets import DIRECTIONS, LISTENER, Position
from ..head_and_gaze.head_movements import MOVEMENTS, cycle_count
from ..torso.posture import POSTURES, SHORTEST_SHIFT_S, reached_s
from .rests import POSTURES as HAND_POSTURES

Trouble = tuple[str, str] | None
"""The action and reason of a decision."""


def unplayable_behaviors(
    schedule: Schedule, *, targets_m: Mapping[str, Position] = MappingProxyType({})
) -> tuple[Decision, ...]:
    """A decision for each kept head movement, posture or gaze that is not played, or not as scheduled.

    If all gazes have the same target, it is the other person, whose position is known under any name.
    """
    kept = [behavior for behavior in schedule.behaviors if behavior.kept]
    looked_at = {each.target for each in kept if each.kind is Channel.GAZE and each.target}
    placed = {LISTENER, *targets_m, *(looked_at if len(looked_at) == 1 else ())}
    found = ((behavior.id, _trouble(behavior, placed)) for behavior in kept)
    return tuple(Decision(name, *trouble) for name, trouble in found if trouble is not None)


def _trouble(behavior: Behavior, placed: set[str]) -> Trouble:
    match behavior.kind:
        case Channel.HEAD:
            return _head(behavior)
        case Channel.POSTURE:
            return _posture(behavior)
        case Channel.GAZE:
            return _gaze(behavior, placed)
    return None


def _head(behavior: Behavior) -> Trouble:
    if behavior.lexeme not in MOVEMENTS:
        return "dropped", f"no head movement {behavior.lexeme!r}, only {', '.join(sorted(MOVEMENTS))}"
    if cycle_count(behavior) < (behavior.repetitions or 1):
        return "shortened", f"there is time for {cycle_count(behavior)} of {behavior.repetitions} repetitions"
    return None


def _posture(behavior: Behavior) -> Trouble:
    known, given_s = {**POSTURES, **HAND_POSTURES}, reached_s(behavior) - behavior.sync.start
    if behavior.lexeme not in known:
        return "dropped", f"no posture {behavior.lexeme!r}, only {', '.join(sorted(known))}"
    if behavior.lexeme in POSTURES and given_s < SHORTEST_SHIFT_S:
        return "prolonged", f"a shift of the body takes {SHORTEST_SHIFT_S} s, not {given_s:.2f} s"
    return None


def _gaze(behavior: Behavior, placed: set[str]) -> Trouble:
    if behavior.direction not in {None, *DIRECTIONS}:
        return "replaced", f"no direction {behavior.direction!r}: it goes straight to its target"
    if behavior.target and behavior.target not in placed:
        return "replaced", f"nobody has placed {behavior.target!r}: it goes to the other in the talk"
    return None
