"""Rest poses between gestures, and the durations of preparations and retractions.

A gesture unit ends in one retraction, whose rest pose depends on the time to the next unit: small clasped, medium at
the side, large in the pockets (towards-natural §3.3, without durations; ours are `SMALL_GAP_S` and `MEDIUM_GAP_S`).
From a hand posture in the schedule on (HANDS_FOLDED …) that pose is used instead, since it is the character's own way
to stand. A change of the weight-bearing leg ends it.

Conventions: wrists as in `understudy.realizer.gestures.gesture_space`, from the arm's own side; speeds are means over a
way.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...model import Behavior, Channel, FloatArray, Hand, Schedule
from ..arms.rest_poses import BEHIND_BACK, HANGING, RESTS
from ..arms.wrist_paths import distance_m
from ..torso.posture import reached_s

CLASPED, AT_SIDE, IN_POCKETS = "clasped", "at_side", "in_pockets"

FIRST_MOMENT_S = 1.0
SMALL_GAP_S = 3.0
MEDIUM_GAP_S = 10.0

POSTURES: Mapping[str, str | None] = MappingProxyType(
    {
        "HANDS_CLASPED": CLASPED,
        "HANDS_AT_SIDE": AT_SIDE,
        "HANDS_IN_POCKETS": IN_POCKETS,
        "HANDS_FOLDED": "folded",
        "HANDS_BEHIND_BACK": BEHIND_BACK,
        "HANDS_ON_HIPS": "on_hips",
        "ARMS_OPEN": "open",
        "WEIGHT_ON_LEFT_LEG": None,
        "WEIGHT_ON_RIGHT_LEG": None,
    }
)
"""The rest pose of a posture; None lets the gap's length decide again."""

PREPARATION_SPEED_M_S = 1.1
RETRACTION_SPEED_M_S = 1.0
"""Ours, for wrists as fast as storytellers' (docs/measurements/bodies.md, Liveliness)."""
TOP_SPEED_M_S = 1.25
"""The fastest mean speed of a way. Its peak is 1.9 times the mean: 2 m/s, people's 99th percentile."""
CHANGE_SPEED_M_S = 0.6
"""Between two rest poses, without hurry."""
SHORTEST_PREPARATION_S = 0.35
HURRIED_PREPARATION_S = 0.15
SHORTEST_RETRACTION_S = 0.40
HURRIED_RETRACTION_S = 0.28
SHORTEST_CHANGE_S = 0.6
SHORTEST_REST_S = 0.3
"""A shorter rest looks like a twitch."""


@dataclass(frozen=True, slots=True)
class RestChange:
    """From `from_s` on, resting hands take this pose."""

    from_s: float
    pose: str


def rest_pose_for_gap(gap_s: float, *, together: bool = True, waiting: str = CLASPED, waiting_s: float = 0.0) -> str:
    """The rest pose for a gap of this length until the next unit. Hands are clasped only where both gesture before or
    after it (`together`), which is ours: by the paper's rule the second hand stays before the belly alone. In a gap
    shorter than `waiting_s` they are in the pose `waiting`, and do not drop between two ideas."""
    if gap_s < waiting_s:
        return waiting
    if gap_s < SMALL_GAP_S and together:
        return CLASPED
    return AT_SIDE if gap_s < MEDIUM_GAP_S else IN_POCKETS


def posture_changes(schedule: Schedule) -> tuple[tuple[float, str | None], ...]:
    """The hand poses that the schedule's postures determine, in order of time: a shift lasts, a posture that ends
    returns to the pose of the latest shift."""
    postures = (each for each in schedule.behaviors if each.kept and each.kind is Channel.POSTURE)
    told = sorted((each for each in postures if each.lexeme in POSTURES), key=lambda each: each.sync.start)
    changes: list[tuple[float, str | None]] = []
    base: str | None = None
    for posture in told:
        pose = POSTURES[posture.lexeme]
        changes.append((_from_s(posture), pose))
        if posture.sync.end <= reached_s(posture):
            base = pose
        else:
            relax_s = posture.sync.relax
            changes.append((posture.sync.end - SHORTEST_CHANGE_S if relax_s is None else relax_s, base))
    return tuple(sorted(changes, key=lambda change: change[0]))


def _from_s(posture: Behavior) -> float:
    """A posture at the very beginning applies from the first frame instead of being reached during the line."""
    return 0.0 if posture.sync.start < FIRST_MOMENT_S else posture.sync.start


def posture_pose(changes: tuple[tuple[float, str | None], ...], time_s: float) -> str | None:
    """The hand pose determined by postures before `time_s`; None if there is none."""
    return next((pose for from_s, pose in reversed(changes) if from_s <= time_s), None)


def rest_m(pose: str, side: Hand) -> FloatArray:
    """The wrist's position (3,) in a rest pose."""
    left, right = RESTS[pose]
    return np.array((left if side is Hand.LEFT else right).wrist_m)


def rest_way_m(pose: str, side: Hand, place_m: FloatArray) -> float:
    """How far a wrist goes between a rest pose and a place (3,): from behind the back past where the arm hangs, and
    not through the body (`understudy.realizer.arms.arm_keys`)."""
    if pose != BEHIND_BACK:
        return distance_m(rest_m(pose, side), place_m)
    hanging_m = np.array(HANGING.wrist_m)
    return distance_m(rest_m(pose, side), hanging_m) + distance_m(hanging_m, place_m)


def preparation_s(way_m: float, natural_s: float) -> float:
    """The duration of a preparation without time pressure."""
    return max(natural_s, way_m / PREPARATION_SPEED_M_S, SHORTEST_PREPARATION_S)


def shortest_way_s(way_m: float) -> float:
    """The minimum duration of a way from or to rest."""
    return max(way_m / TOP_SPEED_M_S, HURRIED_PREPARATION_S)


def retraction_s(way_m: float, speed_m_s: float = RETRACTION_SPEED_M_S, *, pace: float = 1.0) -> float:
    """The duration of a retraction without time pressure, at that mean speed and `pace` times as fast."""
    return max(max(way_m / speed_m_s, SHORTEST_RETRACTION_S) / pace, HURRIED_RETRACTION_S)


def change_s(pose: str, to: str, side: Hand) -> float:
    """The duration of a change from one rest pose to another."""
    behind, other = (to, pose) if to == BEHIND_BACK else (pose, to)
    return max(rest_way_m(behind, side, rest_m(other, side)) / CHANGE_SPEED_M_S, SHORTEST_CHANGE_S)
