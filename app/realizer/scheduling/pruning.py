"""Resolves conflicts between gestures (paper §3.8): overlaps, and transitions too fast for a human arm.

Gestures are processed in order of their strokes. In a conflict another clip of the same category is tried; if none
fits, the gesture with the lower priority is dropped, and of equals the later one.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from ...model import Hand
from ..body.motion import Decision
from ..gestures.gesture_plan import PlacedGesture
from .transitions import TransitionContext, blends, gap_s, stroke_speed_m_s, transition_speed_m_s

BLEND_SPEED_THRESHOLD_M_S = 0.5
"""The paper's v_th, which it does not quantify. A stroke of .6 m/s may be reached by a transition at 1.1 m/s, whose
peak is 2 m/s (people's 99th percentile)."""
SHORTEST_TRANSITION_S = 0.15
"""Even for hands that are close together, since orientation and shape must change as well."""


@dataclass(frozen=True, slots=True)
class Obstacle:
    """Why a gesture cannot be played, and the previous gesture that conflicts with it (None: the start of the line)."""

    reason: str
    rival: PlacedGesture | None = None


@dataclass(frozen=True, slots=True)
class Admission:
    """The gestures kept so far, and the decisions about the one that was processed."""

    kept: tuple[PlacedGesture, ...]
    decisions: tuple[Decision, ...]


def admit(options: Sequence[PlacedGesture], kept: tuple[PlacedGesture, ...], setting: TransitionContext) -> Admission:
    """Try to add one gesture to those kept; `options` are its clips in order of preference."""
    decisions: list[Decision] = []
    while True:
        obstacles = [obstacle(option, kept, setting) for option in options]
        first, hurdle = options[0], obstacles[0]
        if hurdle is None:
            return Admission((*kept, first), tuple(decisions))
        if None in obstacles:
            other = options[obstacles.index(None)]
            decisions.append(_replaced(first, other, hurdle))
            return Admission((*kept, other), tuple(decisions))
        if hurdle.rival is None or hurdle.rival.request.priority >= first.request.priority:
            return Admission(kept, (*decisions, _dropped(first, hurdle)))
        kept = tuple(each for each in kept if each is not hurdle.rival)
        decisions.append(_made_way(hurdle.rival, first, hurdle))


def _replaced(first: PlacedGesture, other: PlacedGesture, hurdle: Obstacle) -> Decision:
    return Decision(first.request.behavior, "replaced", f"{first.clip.name} by {other.clip.name}: {hurdle.reason}")


def _dropped(first: PlacedGesture, hurdle: Obstacle) -> Decision:
    if hurdle.rival is None:
        return Decision(first.request.behavior, "dropped", hurdle.reason)
    matters = f"which has priority {hurdle.rival.request.priority:g}, not {first.request.priority:g}"
    return Decision(first.request.behavior, "dropped", f"{hurdle.reason}, {matters}")


def _made_way(rival: PlacedGesture, winner: PlacedGesture, hurdle: Obstacle) -> Decision:
    """The reason is told from the point of view of the gesture that stays."""
    matters = f"priority {winner.request.priority:g}, not {rival.request.priority:g}"
    return Decision(rival.request.behavior, "dropped", f"for {winner.request.behavior}, of {matters}: {hurdle.reason}")


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
    if placed.stroke_start_s >= 0:
        return None
    return Obstacle(f"its stroke would start {-placed.stroke_start_s:.2f} s before the first frame")


def _in_the_way(first: PlacedGesture, second: PlacedGesture, side: Hand, setting: TransitionContext) -> Obstacle | None:
    """The paper's first and third rule."""
    name, between_s = first.request.behavior, gap_s(first, second)
    if between_s < 0:
        return Obstacle(f"its stroke starts {-between_s:.2f} s before {name} relaxes", first)
    if between_s < SHORTEST_TRANSITION_S:
        return Obstacle(f"its stroke starts {between_s:.2f} s after {name} relaxes", first)
    if not blends(first, second, side, setting):
        return None
    speed_m_s = transition_speed_m_s(first, second, side)
    own_m_s = stroke_speed_m_s(second)
    if speed_m_s - own_m_s <= BLEND_SPEED_THRESHOLD_M_S:
        return None
    return Obstacle(f"{speed_m_s:.2f} m/s from {name}, and its stroke has {own_m_s:.2f} m/s", first)
