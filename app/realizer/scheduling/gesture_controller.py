"""The gesture controller (paper §3.8, the second): overrides arms and hands with a plan's gestures; the trunk follows.

Only the breathing of the collarbones is kept from the idle arms.
"""

from collections.abc import Iterator

import numpy as np

from ...model import FloatArray, Hand
from ..arms.arm_keys import arm_track
from ..arms.arms import arm_motions
from ..arms.posing import wrist_of
from ..body.motion import BodyMotion
from ..body.movement_style import StrokeLife
from ..body.skeleton import Skeleton
from ..geometry.rotations import inverse, length, multiply, normalized
from ..geometry.smoothing import smoothed
from ..gestures.arm_joints import arm_joints
from ..gestures.gesture_plan import GesturePlan
from ..torso.accents import Accent, AccentCourse, accent_course
from ..torso.trunk import with_trunk_following
from .transitions import stroke_speed_m_s

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
    tracks = [arm_track(skeleton, side, plan) for side in (Hand.LEFT, Hand.RIGHT)]
    both = _smooth(arm_motions(tracks, body.times_s, seed=seed, noise_scale=noise_scale), body.times_s)
    arms = {track.side: both[:, number] for number, track in enumerate(tracks)}
    wrists_m = [wrist_of(skeleton, side, arm) for side, arm in arms.items()]
    followed = with_trunk_following(skeleton, body, wrists_m[0], wrists_m[1], accents)
    for side, arm in arms.items():
        joints = skeleton.rows(*arm_joints(side))
        arm[:, 0] = multiply(arm[:, 0], _breath(body.rotations[:, joints.start]))
        followed.rotations[:, joints] = arm
    return followed


def accents_of(plan: GesturePlan, times_s: FloatArray, life: StrokeLife, *, scale: float) -> AccentCourse:
    """What the plan's strokes do to the trunk; `scale` (0 to 1) is 1 - stillness."""
    return accent_course(times_s, list(_accents(plan)), life, scale=scale)


def _accents(plan: GesturePlan) -> Iterator[Accent]:
    """The strokes of the plan and their repetitions, each of either hand; the two of a gesture of both are half as
    strong."""
    for arm in plan.gestures:
        markers, placed = arm.markers, arm.placed
        strength = min(1.0, max(LEAST_ACCENT, stroke_speed_m_s(placed) / FULL_ACCENT_M_S)) / len(placed.arms)
        yield Accent(markers.stroke_start, markers.stroke, strength, arm.side)
        for repeat in placed.repeats:
            yield Accent(repeat.start_s, repeat.end_s, strength * repeat.amplitude, arm.side)


def _smooth(rotations: FloatArray, times_s: FloatArray) -> FloatArray:
    """Rotations (T, …, 4) without the steps in acceleration that splines have at their keys."""
    if len(times_s) < 2:
        return rotations
    width = _MUSCLE_S / float(times_s[1] - times_s[0])
    smooth = smoothed(rotations, width)
    smooth /= length(smooth)
    return smooth


def _breath(collarbone: FloatArray) -> FloatArray:
    """The deviation of an idle collarbone (T, 4) from its mean."""
    mean = normalized(np.sum(collarbone * np.sign(collarbone[:, 3:]), axis=0))
    return multiply(inverse(mean), collarbone)
