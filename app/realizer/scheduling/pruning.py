"""Resolves conflicts between gestures (paper §3.8): overlaps, and transitions too fast for a human arm.

Gestures are processed in order of their strokes. Of two that overlap the one with the lower priority is dropped, and of
equals the later one. For a transition that is too fast another clip of the category is tried first. What is too fast is
in `understudy.model.limits`, by which our own schedules are made: conflicts come from edited or foreign
BML.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import tee

from ...model import Hand
from ...model.limits import shortest_transition_s
from ..body.motion import Decision
from ..gestures.gesture_plan import PlacedGesture
from .rests import shortest_way_s
from .transitions import TransitionContext, blends, gap_s, stroke_speed_m_s, way_m


@dataclass(frozen=True, slots=True)
class Obstacle:
    """Why a gesture cannot be played, and the previous gesture that conflicts with it (None: the start of the line).
    `missing_s` is the time that the two lack; `replaceable` whether another clip may be tried."""

    reason: str
    rival: PlacedGesture | None = None
    missing_s: float = 0.0
    replaceable: bool = False


@dataclass(frozen=True, slots=True)
class KeptGestures:
    """The gestures kept so far, and the decisions about the one that was processed."""

    kept: tuple[PlacedGesture, ...]
    decisions: tuple[Decision, ...]


def admit(
    options: Iterable[PlacedGesture], kept: tuple[PlacedGesture, ...], setting: TransitionContext
) -> KeptGestures:
    """Try to add one gesture to those kept; `options` are its clips in order of preference."""
    decisions: list[Decision] = []
    while True:
        options, tried = tee(options)
        first = next(tried)
        hurdle = obstacle(first, kept, setting)
        if hurdle is None:
            return KeptGestures((*kept, first), tuple(decisions))
        others = tried if hurdle.replaceable else ()
        other = next((option for option in others if obstacle(option, kept, setting) is None), None)
        if other is not None:
            if other.clip.name != first.clip.name or first.request.slots:
                decisions.append(_replaced(first, other, hurdle))
            return KeptGestures((*kept, other), tuple(decisions))
        if hurdle.rival is None or hurdle.rival.request.priority >= first.request.priority:
            return KeptGestures(kept, (*decisions, _dropped(first, hurdle)))
        kept = tuple(each for each in kept if each is not hurdle.rival)
        decisions.append(_made_way(hurdle.rival, first, hurdle))


def _replaced(first: PlacedGesture, other: PlacedGesture, hurdle: Obstacle) -> Decision:
    return Decision(first.request.behavior, "replaced", f"{first.clip.name} by {other.clip.name}: {hurdle.reason}")


def _dropped(first: PlacedGesture, hurdle: Obstacle) -> Decision:
    if hurdle.rival is None:
        return Decision(first.request.behavior, "dropped", hurdle.reason)
    rival, own = hurdle.rival.request, first.request.priority
    stays = f"its priority is {rival.priority:g}, not {own:g}" if rival.priority > own else "it comes first"
    reason = f"{hurdle.reason}. {rival.behavior} is kept: {stays}. {_remedy(first, hurdle.rival, hurdle.missing_s)}"
    return Decision(first.request.behavior, "dropped", reason)


def _made_way(rival: PlacedGesture, winner: PlacedGesture, hurdle: Obstacle) -> Decision:
    """The reason is given from the point of view of the gesture that stays."""
    stays = f"{winner.request.behavior} is kept: its priority is {winner.request.priority:g}"
    reason = f"for {winner.request.behavior}: {hurdle.reason}. {stays}, not {rival.request.priority:g}."
    return Decision(rival.request.behavior, "dropped", f"{reason} {_remedy(winner, rival, hurdle.missing_s)}")


def _remedy(second: PlacedGesture, first: PlacedGesture, missing_s: float) -> str:
    """What would let both be played. Times are rounded up to what is surely enough."""
    enough_s = missing_s + _ROUNDING_S
    later = f"Both are played if {second.request.behavior} comes {enough_s:.2f} s later"
    if first.relax_s - enough_s < first.stroke_end_s:
        return later
    return f"{later}, or if {first.request.behavior} relaxes at {first.relax_s - enough_s:.2f} s"


_ROUNDING_S = 0.005


def obstacle(second: PlacedGesture, before: tuple[PlacedGesture, ...], setting: TransitionContext) -> Obstacle | None:
    """What prevents a gesture from being played after those before it; None if nothing does."""
    for side in second.arms:
        first = next((each for each in reversed(before) if side in each.arms), None)
        found = _too_early(second) if first is None else _in_the_way(first, second, side, setting)
        if found is not None:
            return found
    return None


def _too_early(placed: PlacedGesture) -> Obstacle | None:
    """Nothing moves before the first frame, so a stroke that would already have begun cannot be played."""
    if placed.stroke_start_s >= -_SLACK_S:
        return None
    return Obstacle(f"its stroke would start {-placed.stroke_start_s:.2f} s before the first frame")


def _in_the_way(first: PlacedGesture, second: PlacedGesture, side: Hand, setting: TransitionContext) -> Obstacle | None:
    """The paper's first and third rule. The ways to what shows a place or a size are as long as it is, and may be
    as fast as hands are."""
    between_s, whole_m, own_m_s = gap_s(first, second), way_m(first, second, side), stroke_speed_m_s(second)
    needed_s = shortest_transition_s(whole_m, own_m_s)
    if first.request.slots or second.request.slots:
        needed_s = min(needed_s, shortest_way_s(whole_m))
    if between_s >= needed_s - _SLACK_S or not blends(first, second, side, setting):
        return None
    times = f"its stroke would start at {second.stroke_start_s:.2f} s"
    relaxes = f"{first.request.behavior} relaxes at {first.relax_s:.2f} s"
    if between_s < 0:
        return Obstacle(f"{times}, before {relaxes}", first, needed_s - between_s)
    reason = f"{times} and {relaxes}, and the hand needs {needed_s:.2f} s for the {100 * whole_m:.0f} cm between them"
    return Obstacle(reason, first, needed_s - between_s, replaceable=True)


_SLACK_S = 0.002
"""Times of schedules are whole milliseconds."""
