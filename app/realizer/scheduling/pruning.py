"""Which gesture gives way to which (paper §3.8): those that overlap, and those that no human speed could join.

Gestures are taken in the order of their strokes. One that meets an obstacle is played by another clip of its category
if one gets past; otherwise the less important of the two that meet is dropped. Of equals the earlier stays.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from ...model import Hand
from ..body.motion import Decision
from ..gestures.gesture_plan import Placed
from .transitions import Setting, flow_together, gap_s, stroke_speed_m_s, transition_speed_m_s

BLEND_SPEED_THRESHOLD_M_S = 0.5
"""The paper's v_th, for which it gives no figure. A stroke of .6 m/s may so be reached by a way of 1.1 m/s, whose peak
is at 2 m/s (people's 99th percentile)."""
SHORTEST_TRANSITION_S = 0.15
"""However near the hands are: they must be turned and shaped as well."""


@dataclass(frozen=True, slots=True)
class Obstacle:
    """Why a gesture cannot be played, and the gesture before it that is in its way (None: the start of the line)."""

    reason: str
    rival: Placed | None = None


@dataclass(frozen=True, slots=True)
class Admission:
    """The gestures that are played so far, and what was decided about one more."""

    kept: tuple[Placed, ...]
    decisions: tuple[Decision, ...]


def admitted(options: Sequence[Placed], kept: tuple[Placed, ...], setting: Setting) -> Admission:
    """The gesture that `options` are clips for, in the order of preference, among those kept."""
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


def _replaced(first: Placed, other: Placed, hurdle: Obstacle) -> Decision:
    return Decision(first.request.behavior, "replaced", f"{first.clip.name} by {other.clip.name}: {hurdle.reason}")


def _dropped(first: Placed, hurdle: Obstacle) -> Decision:
    if hurdle.rival is None:
        return Decision(first.request.behavior, "dropped", hurdle.reason)
    matters = f"which has priority {hurdle.rival.request.priority:g}, not {first.request.priority:g}"
    return Decision(first.request.behavior, "dropped", f"{hurdle.reason}, {matters}")


def _made_way(rival: Placed, winner: Placed, hurdle: Obstacle) -> Decision:
    """The reason is told from the side of the gesture that stays."""
    matters = f"priority {winner.request.priority:g}, not {rival.request.priority:g}"
    return Decision(rival.request.behavior, "dropped", f"for {winner.request.behavior}, of {matters}: {hurdle.reason}")


def obstacle(second: Placed, before: tuple[Placed, ...], setting: Setting) -> Obstacle | None:
    """What keeps a gesture from being played behind those before it; None when nothing does."""
    for side in second.arms:
        first = next((each for each in reversed(before) if side in each.arms), None)
        found = _too_early(second) if first is None else _in_the_way(first, second, side, setting)
        if found is not None:
            return found
    return None


def _too_early(placed: Placed) -> Obstacle | None:
    """Nothing moves before the first frame: a stroke that would have begun by then cannot be played."""
    if placed.stroke_start_s >= 0:
        return None
    return Obstacle(f"its stroke would start {-placed.stroke_start_s:.2f} s before the first frame")


def _in_the_way(first: Placed, second: Placed, side: Hand, setting: Setting) -> Obstacle | None:
    """The paper's first and third rule."""
    name, between_s = first.request.behavior, gap_s(first, second)
    if between_s < 0:
        return Obstacle(f"its stroke starts {-between_s:.2f} s before {name} relaxes", first)
    if between_s < SHORTEST_TRANSITION_S:
        return Obstacle(f"its stroke starts {between_s:.2f} s after {name} relaxes", first)
    if not flow_together(first, second, side, setting):
        return None
    speed_m_s = transition_speed_m_s(first, second, side)
    own_m_s = stroke_speed_m_s(second)
    if speed_m_s - own_m_s <= BLEND_SPEED_THRESHOLD_M_S:
        return None
    return Obstacle(f"{speed_m_s:.2f} m/s from {name}, and its stroke has {own_m_s:.2f} m/s", first)
