"""Gaze: the eyes get to their target first, the head follows, the trunk gives a little (paper §3.8).

The gaze takes the place of what neck, head and eyes did before. The trunk's joints turn in addition to what they do,
unlike the paper's, so that the body still leans and breathes while it looks somewhere. While head and body move the
eyes stay on the target (vestibulo-ocular reflex), as far as they can turn.

Conventions: radians, metres and seconds; pitch and yaw in the world, as seen from where the eyes are in the T-pose.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Schedule
from ..body.limits import within_neck_limits
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.angles import turn
from ..geometry.easing import changes
from ..geometry.rotations import from_rotation_vector, inverse, multiply, to_rotation_vector
from .fixation import fixating, saccade_s
from .gaze_geometry import EYES, Chest, aimed, chest, face, toward
from .looks import Aims, Position, looks

_TRUNK = ("spine", "chest", "upperChest")

HEAD_LAG_S = 0.04
"""The head is heavier and starts later than the eyes, the trunk later than the head."""
TRUNK_LAG_S = 0.12
HEAD_S, HEAD_S_PER_RADIAN = 0.2, 0.008 * 180 / np.pi
"""The head takes no less time, and gets there late if the schedule has less: 20° have a peak of about 100°/s."""
TRUNK_SLOWNESS = 1.8


def gaze(
    skeleton: Skeleton,
    body: BodyMotion,
    schedule: Schedule,
    *,
    targets_m: Mapping[str, Position] = MappingProxyType({}),
    seed: int = 0,
) -> BodyMotion:
    """`body` with eyes, head and trunk turned by the schedule's gazes, looking at the listener before and between.

    `targets_m` places targets in the world; one that it does not name is the other in the talk (`LISTENER_M`).
    """
    times_s, from_m = body.times_s, _eyes_in_t_pose(skeleton)
    line, head, trunk = _courses(times_s, looks(schedule, from_m, targets_m))
    rotations = body.rotations.copy()
    share = turn(np.zeros_like(trunk), trunk / len(_TRUNK), np.zeros_like(trunk))
    for joint in skeleton.chain(*_TRUNK):
        rotations[:, joint] = multiply(rotations[:, joint], share)
    carrying = chest(skeleton, rotations, body.hips_m)
    half = _half_turned(carrying, head)
    aside = (1 - schedule.stillness) * fixating(times_s, seed=seed)
    at_m = toward(line[:, 0] + aside[:, 0], line[:, 1] + aside[:, 1], 1.0 / line[:, 2], from_m)
    rotations[:, skeleton.chain("neck", "head")] = half[:, None]
    rotations[:, skeleton.chain(*EYES)] = aimed(face(skeleton, carrying, half, half), at_m)
    return BodyMotion(times_s, rotations, body.hips_m)


def _courses(times_s: FloatArray, aims: Aims) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The eyes' pitch, yaw and nearness (T, 3), the head's pitch and yaw (T, 2), the trunk's yaw (T,)."""
    eyes_by, head_by, trunk_by = (np.diff(each, axis=0) for each in (aims.eyes, aims.head, aims.trunk))
    eyes_s = saccade_s(np.linalg.norm(eyes_by[:, :2], axis=-1))
    head_s = np.maximum(HEAD_S + HEAD_S_PER_RADIAN * np.linalg.norm(head_by, axis=-1), aims.within_s - HEAD_LAG_S)
    trunk = aims.trunk[0] + changes(times_s, aims.starts_s + TRUNK_LAG_S, TRUNK_SLOWNESS * head_s, trunk_by)
    return (
        aims.eyes[0] + changes(times_s, aims.starts_s, eyes_s, eyes_by),
        aims.head[0] + changes(times_s, aims.starts_s + HEAD_LAG_S, head_s, head_by),
        trunk[:, 0],
    )


def _half_turned(carrying: Chest, head: FloatArray) -> FloatArray:
    """The rotations (T, 4) of neck and of head, half of it each, that give the head the pitch and yaw `head` (T, 2) in
    the world."""
    over_chest = multiply(inverse(carrying.turned), turn(head[:, 0], head[:, 1], np.zeros(len(head))))
    return from_rotation_vector(to_rotation_vector(within_neck_limits(over_chest)) / 2)


def _eyes_in_t_pose(skeleton: Skeleton) -> FloatArray:
    """The place between the eyes (3,)."""
    down = skeleton.chain("hips", "spine", "chest", "upperChest", "neck", "head")
    return np.asarray(skeleton.offsets_m[down].sum(axis=0) + skeleton.offsets_m[skeleton.chain(*EYES)].mean(axis=0))
