"""What no controller can play as it is asked to: there is no such movement, or too little time. Each is told."""

from app.model import Behavior, Channel, Schedule
from app.realizer.head_movements import MOVEMENTS, waves_of
from app.realizer.looks import DIRECTIONS
from app.realizer.motion import Decision
from app.realizer.posture import POSTURES, SHORTEST_SHIFT_S
from app.realizer.rests import POSTURES as HAND_POSTURES


def unplayed(schedule: Schedule) -> tuple[Decision, ...]:
    """A decision for each kept head movement, posture or gaze that is not played, or not as it was asked for."""
    found = ((behavior.id, _trouble(behavior)) for behavior in schedule.behaviors if behavior.kept)
    return tuple(Decision(name, *trouble) for name, trouble in found if trouble is not None)


def _trouble(behavior: Behavior) -> tuple[str, str] | None:
    """The action and the reason."""
    if behavior.kind is Channel.HEAD and behavior.lexeme not in MOVEMENTS:
        return "dropped", f"no head movement {behavior.lexeme!r}, only {', '.join(sorted(MOVEMENTS))}"
    if behavior.kind is Channel.HEAD and waves_of(behavior) < (behavior.repetitions or 1):
        return "shortened", f"there is time for {waves_of(behavior)} of {behavior.repetitions} repetitions"
    if behavior.kind is Channel.POSTURE and behavior.lexeme not in {**POSTURES, **HAND_POSTURES}:
        return "dropped", f"no posture {behavior.lexeme!r}, only {', '.join(sorted({**POSTURES, **HAND_POSTURES}))}"
    if behavior.lexeme in POSTURES and (given_s := behavior.sync.end - behavior.sync.start) < SHORTEST_SHIFT_S:
        return "prolonged", f"a shift of the body takes {SHORTEST_SHIFT_S} s, not {given_s:.2f} s"
    if behavior.kind is Channel.GAZE and behavior.direction not in {None, *DIRECTIONS}:
        return "replaced", f"no direction {behavior.direction!r}: it goes straight to its target"
    return None
