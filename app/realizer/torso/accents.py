"""The trunk's part in strokes: with each one the knees give way, the trunk bows and twists, its shoulders tip.

Lasseter's principle that movement starts at the body's middle: the trunk sets out before the hand and strikes with it.
Conventions: seconds, metres, radians; a rotation vector leans forward, turns to the left, tips to the right.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...model import FloatArray, Hand
from ..body.movement_style import StrokeLife
from ..geometry.easing import superposed_movements

AHEAD_S = 0.12
"""How much earlier than the hand the trunk sets out."""
RECOVERY_S = 0.5
SHORTEST_S = 0.22


@dataclass(frozen=True, slots=True)
class Accent:
    """A stroke of one hand, from its start to its emphasis; `strength` is 1 for a fast one."""

    start_s: float
    stroke_s: float
    strength: float
    side: Hand


@dataclass(frozen=True, slots=True, eq=False)
class AccentCourse:
    """What strokes add over time: `turns` (T, 3) of the trunk, `dip_m` (T,) and `aside_m` (T,) of the hips, and how far
    the `neck` (T,) reaches forward."""

    turns: FloatArray
    dip_m: FloatArray
    aside_m: FloatArray
    neck: FloatArray


def accent_course(times_s: FloatArray, accents: Sequence[Accent], life: StrokeLife, *, scale: float) -> AccentCourse:
    """The sum of all strokes; `scale` (0 to 1) is 1 - stillness."""
    by = np.array([scale * each.strength * _whole(each.side, life) for each in accents]).reshape(-1, 6)
    starts_s = np.array([each.start_s - AHEAD_S for each in accents])
    reached_s = np.array([max(each.stroke_s, each.start_s - AHEAD_S + SHORTEST_S) for each in accents])
    recovery_s = np.full(len(accents), RECOVERY_S)
    durations_s = np.concatenate([reached_s - starts_s, recovery_s])
    course = superposed_movements(
        times_s, np.concatenate([starts_s, reached_s]), durations_s, np.concatenate([by, -by])
    )
    return AccentCourse(course[:, :3], course[:, 3], course[:, 4], course[:, 5])


def _whole(side: Hand, life: StrokeLife) -> FloatArray:
    """A stroke of full strength: bow, twist, tip, dip, shift of the weight to the left, reach of the neck."""
    right = 1.0 if side is Hand.RIGHT else -1.0
    bow, twist, tip, neck = np.radians([life.bow_deg, life.twist_deg, life.shoulders_deg, life.neck_deg])
    return np.array([bow, right * twist, right * tip, life.dip_m, -right * life.weight_m, neck])
