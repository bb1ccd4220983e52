"""Shoulders that shrug and a neck that reaches forward, between a trunk and arms and head that are placed already.

Both collarbones rise with the gestures that say who knows, and sink as they relax; the arms keep their orientation, so
that hands rise with the shoulders and stay as they are turned. The neck is inclined in standing, nods along with
strokes, and is never quite still; the head keeps its orientation, so gaze and head movements remain what they are.

Conventions: radians, seconds; a raised left collarbone turns about z, the right one the other way; forward is positive.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Hand, Schedule
from ..body.motion import BodyMotion
from ..body.movement_style import IdleLife
from ..body.skeleton import Skeleton
from ..geometry.easing import plateau
from ..geometry.noise import perlin
from ..geometry.rotations import from_axis_angle, inverse, multiply
from ..gestures.gesture_plan import ArmGesture, GesturePlan
from .stance import idle_activity

LIFTS_DEG: Mapping[str, float] = MappingProxyType(
    {"SHRUG": 14.0, "UNCERTAINTY": 12.0, "INDIFFERENCE": 11.0, "QUESTION": 5.0}
)
"""How far each gesture lifts the shoulders in its usual size; people's go up by 10 to 15°."""

LEAST, MOST = 0.75, 1.2
"""Shares of that in the smallest and the largest of them: a shrug of which nothing is seen is none."""

SOONER_S = 0.06
"""The shoulders are up a little before the hands."""

SHORTEST_S = 0.35
"""How long they stay up at least."""
DOWN_S = 0.45
_AXIS = (0.0, 0.0, 1.0)
_UP: Mapping[Hand, float] = MappingProxyType({Hand.LEFT: 1.0, Hand.RIGHT: -1.0})

_WEAKER = 0.92
"""The shoulder of the arm that does not gesture rises less."""


def with_shrugs(skeleton: Skeleton, body: BodyMotion, plan: GesturePlan) -> BodyMotion:
    """The body with its shoulders lifted by the plan's shrugs."""
    shrugs = [each for each in plan.gestures if each.placed.clip.category in LIFTS_DEG]
    if not shrugs:
        return body
    rotations = body.rotations.copy()
    for side in (Hand.LEFT, Hand.RIGHT):
        raised = from_axis_angle(_AXIS, _UP[side] * _lift(body.times_s, shrugs, side))
        collarbone, arm = skeleton.chain(f"{side.value}Shoulder", f"{side.value}UpperArm")
        before = rotations[:, collarbone].copy()
        rotations[:, collarbone] = multiply(raised, before)
        rotations[:, arm] = multiply(multiply(inverse(rotations[:, collarbone]), before), rotations[:, arm])
    return replace(body, rotations=rotations)


def _lift(times_s: FloatArray, shrugs: Iterable[ArmGesture], side: Hand) -> FloatArray:
    """How far the shoulder of this side is lifted (T,): by the strongest shrug, if there are several at once."""
    lift = np.zeros(len(times_s))
    for arm in shrugs:
        markers, placed = arm.markers, arm.placed
        up_s = max(markers.stroke_end - SOONER_S, markers.stroke_start + 0.05)
        left_s = max(markers.relax, up_s + SHORTEST_S)
        size = min(max(placed.size, LEAST), MOST) * (1.0 if arm.side is side else _WEAKER)
        course = plateau(times_s, markers.stroke_start - 0.1, up_s, left_s, left_s + DOWN_S)
        lift = np.maximum(lift, np.radians(LIFTS_DEG[placed.clip.category]) * size * course)
    return lift


_NECK_HZ = 0.4


def with_neck_reaching(
    skeleton: Skeleton, body: BodyMotion, schedule: Schedule, strokes: FloatArray, *, seed: int, life: IdleLife
) -> BodyMotion:
    """The body with its neck inclined, by itself and by `strokes` (T,). Deterministic for a seed."""
    noise = perlin(body.times_s, frequency_hz=_NECK_HZ, seed=seed + 4)[:, 0]
    forward = np.radians(life.neck_forward_deg + life.neck_deg * idle_activity(schedule) * noise) + strokes
    neck, head = skeleton.chain("neck", "head")
    rotations = body.rotations.copy()
    before = body.rotations[:, neck]
    rotations[:, neck] = multiply(from_axis_angle((1.0, 0.0, 0.0), forward), before)
    rotations[:, head] = multiply(inverse(rotations[:, neck]), multiply(before, body.rotations[:, head]))
    return replace(body, rotations=rotations)
