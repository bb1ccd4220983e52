"""What no controller can play: words of other people's BML that we have no movement for. Each is told."""

from app.model import Behavior, Channel, Schedule
from app.realizer.head import MOVEMENTS
from app.realizer.looks import DIRECTIONS
from app.realizer.motion import Decision
from app.realizer.posture import POSTURES
from app.realizer.rests import POSTURES as HAND_POSTURES


def unplayed(schedule: Schedule) -> tuple[Decision, ...]:
    """A decision for each kept head movement, posture or gaze that is not played, or not as it was asked for."""
    found = ((behavior.id, _trouble(behavior)) for behavior in schedule.behaviors if behavior.kept)
    return tuple(Decision(name, *trouble) for name, trouble in found if trouble is not None)


def _trouble(behavior: Behavior) -> tuple[str, str] | None:
    """The action and the reason."""
    if behavior.kind is Channel.HEAD and behavior.lexeme not in MOVEMENTS:
        return "dropped", f"no head movement {behavior.lexeme!r}, only {', '.join(sorted(MOVEMENTS))}"
    if behavior.kind is Channel.POSTURE and behavior.lexeme not in {**POSTURES, **HAND_POSTURES}:
        return "dropped", f"no posture {behavior.lexeme!r}, only {', '.join(sorted({**POSTURES, **HAND_POSTURES}))}"
    if behavior.kind is Channel.GAZE and behavior.direction not in {None, *DIRECTIONS}:
        return "replaced", f"no direction {behavior.direction!r}: it goes straight to its target"
    return None
