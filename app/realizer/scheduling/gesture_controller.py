"""The gesture controller (paper §3.8, the second): overrides arms and hands with a plan's gestures; the trunk follows.

Only the breathing of the collarbones is kept from the idle arms.
"""

from collections.abc import Iterator
from functools import lru_cache

import numpy as np

from ...model import FloatArray, Hand
from ..arms.arm_keys import arm_track
from ..arms.arms import set_arms
from ..arms.posing import wrists_of
from ..body.motion import BodyMotion
from ..body.movement_style import StrokeLife
from ..body.skeleton import Skeleton
from ..dynamics.dragging import drag
from ..dynamics.ends import eased_at_the_ends
from ..geometry.rotations import inverse, multiply, normalize, normalized
from ..geometry.smoothing import smooth
from ..gestures.arm_joints import arm_joints
from ..gestures.gesture_plan import GesturePlan
from ..torso.accents import Accent, AccentCourse, accent_course
from ..torso.trunk import follow_with_trunk
from .stroke_arcs import bend_strokes
from .track_offsets import add_offset_tracks
from .transitions import stroke_speed_m_s

SIDES = (Hand.LEFT, Hand.RIGHT)
_MUSCLE_S = 0.03
LEAST_ACCENT, FULL_ACCENT_M_S = 0.35, 0.8
"""The trunk's part in the slowest strokes, and the mean speed of a stroke in which it takes its full part."""


def apply_gestures(
    skeleton: Skeleton,
    body: BodyMotion,
    plan: GesturePlan,
    *,
    seed: int,
    noise_scale: float = 1.0,
    accents: AccentCourse | None = None,
) -> BodyMotion:
    """The body with the plan's arm motion, and the trunk following it and its `accents`. Deterministic for a seed.
    `noise_scale` (0 to 1) scales the arms' noise."""
    body = BodyMotion(body.times_s, body.rotations.copy(), body.hips_m.copy())
    rows = [_arm_rows(skeleton, side) for side in SIDES]
    collarbones = [joints.start for joints in rows]
    breath = _breath(body.rotations.take(collarbones, axis=1))
    arms = [body.rotations[:, joints] for joints in rows]
    tracks = [arm_track(skeleton, side, plan) for side in SIDES]
    eased_s = eased_at_the_ends(body.times_s, plan.style.ends.eased_s)
    set_arms(arms, tracks, eased_s, seed=seed, noise_scale=noise_scale)
    for arm in arms:
        _smooth(arm, body.times_s)
    wrists_m = wrists_of(skeleton, *arms)
    drag(arms, wrists_m, body.times_s, plan.style.dragging, seed=seed, life=noise_scale)
    follow_with_trunk(skeleton, body, wrists_m, accents)
    body.rotations[:, collarbones] = multiply(body.rotations.take(collarbones, axis=1), breath)
    bend_strokes(skeleton, body, plan)
    add_offset_tracks(skeleton, body.rotations, body.times_s, plan)
    return body


@lru_cache(maxsize=64)
def _arm_rows(skeleton: Skeleton, side: Hand) -> slice:
    return skeleton.rows(*arm_joints(side))


def accents_of(plan: GesturePlan, times_s: FloatArray, life: StrokeLife, *, scale: float) -> AccentCourse:
    """What the plan's strokes do to the trunk; `scale` (0 to 1) is 1 - stillness."""
    eased_s = eased_at_the_ends(times_s, plan.style.ends.eased_s)
    return accent_course(eased_s, list(_accents(plan)), life, scale=scale)


def _accents(plan: GesturePlan) -> Iterator[Accent]:
    """The strokes of the plan and their repetitions, each of either hand; the two of a gesture of both are half as
    strong."""
    for arm in plan.gestures:
        markers, placed = arm.markers, arm.placed
        strength = min(1.0, max(LEAST_ACCENT, stroke_speed_m_s(placed) / FULL_ACCENT_M_S)) / len(placed.arms)
        yield Accent(markers.stroke_start, markers.stroke, strength, arm.side)
        for repeat in placed.repeats:
            yield Accent(repeat.start_s, repeat.end_s, strength * repeat.amplitude, arm.side)


def _smooth(rotations: FloatArray, times_s: FloatArray) -> None:
    """Take from rotations (T, …, 4), in place, the steps in acceleration that splines have at their keys."""
    if len(times_s) > 1:
        smooth(rotations, _MUSCLE_S / float(times_s[1] - times_s[0]))
        normalize(rotations)


def _breath(collarbones: FloatArray) -> FloatArray:
    """The deviation of idle collarbones (T, 2, 4) from their mean."""
    mean = normalized(np.sum(collarbones * np.sign(collarbones[..., 3:]), axis=0))
    return multiply(inverse(mean), collarbones)
