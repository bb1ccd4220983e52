"""Reports what is played otherwise than the schedule asks: behaviours that no controller can play as they are (unknown
movements, unknown targets, too little time), and those that are played at other times.

Of what a document states, each sync point is compared. Of a schedule of ours start and end are, and what a decision
tells already, a blend or a longer hold, is not told twice.
"""

from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType

from ...model import Behavior, Channel, Schedule, SyncPoints
from ..body.motion import Decision
from ..gestures.gesture_plan import Position
from ..head_and_gaze.gaze_targets import DIRECTIONS, LISTENER
from ..head_and_gaze.head import MOVEMENTS, cycle_count
from ..torso.posture import POSTURES, SHORTEST_SHIFT_S, reached_s
from .rests import POSTURES as HAND_POSTURES

Trouble = tuple[str, str] | None
"""The action and reason of a decision."""


def unplayable_behaviors(
    schedule: Schedule, *, targets_m: Mapping[str, Position] = MappingProxyType({})
) -> tuple[Decision, ...]:
    """A decision for each kept head movement, posture or gaze that is not played, or not as scheduled.

    If all gazes have the same target, it is the other person, whose position is known under any name; coordinates that
    cannot be read are nobody's name.
    """
    kept = [behavior for behavior in schedule.behaviors if behavior.kept]
    looked_at = {each.target for each in kept if each.kind is Channel.GAZE and each.target}
    other = looked_at if len(looked_at) == 1 and not any("," in name for name in looked_at) else ()
    placed = {LISTENER, *targets_m, *other}
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
        return "shortened", f"there is only time for {cycle_count(behavior)} of {behavior.repetitions} repetitions"
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
        return "replaced", f"{behavior.target!r} has no position: the gaze goes to the listener"
    return None


NOTICEABLE_S = 0.05
"""Three frames at 60 a second."""

_STARTS_TOLD = frozenset({"blended", "shortened", "late", "dropped"})
_ENDS_TOLD = frozenset({"held", "cut", "dropped"})
_WORDS: Mapping[str, str] = {
    "start": "begins",
    "ready": "is ready",
    "stroke_start": "begins its stroke",
    "stroke": "strokes",
    "stroke_end": "ends its stroke",
    "relax": "relaxes",
    "end": "ends",
}


def timing_deviations(
    behaviors: Iterable[Behavior],
    realized: Mapping[str, SyncPoints],
    decisions: Iterable[Decision],
    asked: Mapping[str, frozenset[str]],
) -> Iterator[Decision]:
    """A decision `timed` for each kept behaviour of which a point that is `asked` for comes `NOTICEABLE_S` or more from
    its time; of behaviours that are not in it, start and end are."""
    told: dict[str, set[str]] = {}
    for decision in decisions:
        told.setdefault(decision.behavior, set()).add(decision.action)
    for behavior in behaviors:
        made = realized.get(behavior.id)
        if behavior.kept and made is not None:
            points = asked.get(behavior.id, _untold(told.get(behavior.id, set())))
            reason = "; ".join(_apart(behavior.sync, made, points))
            if reason:
                yield Decision(behavior.id, "timed", reason)


def _untold(told: set[str]) -> frozenset[str]:
    """The points of a behaviour of ours of which no decision tells."""
    starts, ends = {"start"} if not told & _STARTS_TOLD else set(), {"end"} if not told & _ENDS_TOLD else set()
    return frozenset(starts | ends)


def _apart(asked: SyncPoints, made: SyncPoints, points: frozenset[str]) -> Iterator[str]:
    made_s = dict(made.in_order())
    for name, asked_s in asked.in_order():
        if name in points and name in made_s and abs(made_s[name] - asked_s) >= NOTICEABLE_S:
            yield f"{_WORDS[name]} at {made_s[name]:.2f} s, not at {asked_s:.2f} s"
