"""The head controller: adds head movements to the gaze's rotations of neck and head (paper §3.8), and what the head
does by itself.

Neck and head each take half of a movement; the neck leads by a phase shift. The eyes keep their direction. Between
movements head and trunk change their attitude (`understudy.realizer.head_and_gaze.attitudes`). Whatever is asked for,
and however much of it at once, the head turns no faster than `FASTEST_RAD_S` against the trunk and the eyes no faster
than `FASTEST_EYE_RAD_S`: it comes later, so nothing ever jumps.

Conventions: radians; positive pitch is down, yaw left, roll to the right shoulder; rotations are quaternions (T, 4), a
frame each; seconds.
"""

from collections.abc import Sequence

import numpy as np

from ...model import Behavior, Channel, FloatArray, Schedule
from ..body.limits import within_neck_limits
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.angles import from_pitch_yaw_roll
from ..geometry.easing import plateau
from ..geometry.rotations import angle_between, from_axis_angle, inverse, multiply, nearest_sign, slerp
from .attitudes import HeadAttitude, head_attitude
from .gaze_geometry import EYES, TRUNK, chest, eye_rotations, face, fixation_point_m
from .head_movements import MOVEMENTS, course_of, limited_speed, movement_angles

FASTEST_RAD_S = np.radians(190.0)
"""Of the head over the chest; with the trunk's own movement no head turns faster than 250°/s."""

FASTEST_EYE_RAD_S = np.radians(850.0)
"""Saccades of 60° reach 700 to 850°/s (Carpenter 1988), and none is faster."""

_PITCH = (1.0, 0.0, 0.0)

_CALMED = 0.75
"""The share of idle movement that is suppressed in the middle of a movement; how the head is held stays."""


def apply_head_movements(
    skeleton: Skeleton,
    body: BodyMotion,
    schedule: Schedule,
    *,
    seed: int,
    seen_m: FloatArray | None = None,
    trunk_s: FloatArray | None = None,
) -> BodyMotion:
    """The body with the schedule's head movements on neck and head, and idle movement of trunk, neck and head.
    `seen_m` (T, 3) is where the eyes look, which saves finding it out; `trunk_s` (T,) are the times at which the trunk
    is as it is in the frames, if others than theirs."""
    times_s, rotations, frame_s = body.times_s, body.rotations.copy(), float(body.times_s[1] - body.times_s[0])
    joints, eyes, trunk = skeleton.chain("neck", "head"), skeleton.chain(*EYES), skeleton.rows(*TRUNK)
    seen_m = _seen_m(skeleton, body) if seen_m is None else seen_m
    neck, skull = (rotations[:, joint] for joint in joints)
    idle = head_attitude(times_s, schedule, seed=seed)
    trunk_s = times_s if trunk_s is None else trunk_s
    share = from_pitch_yaw_roll(*(np.interp(trunk_s, times_s, angle) / len(TRUNK) for angle in idle.trunk.T))
    rotations[:, trunk] = multiply(rotations[:, trunk], share[:, None])
    neck_turn, head_turn = _turns(times_s, schedule, idle)
    neck, skull = multiply(neck, from_pitch_yaw_roll(*neck_turn.T)), multiply(skull, from_pitch_yaw_roll(*head_turn.T))
    over_chest = within_speed(within_neck_limits(multiply(neck, skull)), frame_s, FASTEST_RAD_S)
    neck = multiply(neck, from_axis_angle(_PITCH, idle.forward))
    skull = multiply(inverse(neck), over_chest)
    rotations[:, joints[0]], rotations[:, joints[1]] = neck, skull
    looking = eye_rotations(face(skeleton, chest(skeleton, rotations, body.hips_m), neck, skull), seen_m)
    for place, eye in enumerate(eyes):
        rotations[:, eye] = within_speed(looking[:, place], frame_s, FASTEST_EYE_RAD_S)
    return BodyMotion(times_s, rotations, body.hips_m)


def _seen_m(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    """Where the eyes look (T, 3)."""
    neck, skull = (body.rotations[:, joint] for joint in skeleton.chain("neck", "head"))
    where = face(skeleton, chest(skeleton, body.rotations, body.hips_m), neck, skull)
    return fixation_point_m(where, body.rotations.take(skeleton.chain(*EYES), axis=1))


def _turns(times_s: FloatArray, schedule: Schedule, idle: HeadAttitude) -> tuple[FloatArray, FloatArray]:
    """Pitch, yaw and roll (T, 3) that neck and head turn beyond the gaze."""
    movements = [
        each for each in schedule.behaviors if each.kept and each.kind is Channel.HEAD and each.lexeme in MOVEMENTS
    ]
    calm = _calm(times_s, movements)[:, None]
    held = idle.held / 2
    neck_turn, head_turn = held + calm * idle.neck, held + calm * idle.head
    for movement in movements:
        _add(times_s, movement, neck_turn, head_turn)
    return neck_turn, head_turn


def _add(times_s: FloatArray, behavior: Behavior, neck_turn: FloatArray, head_turn: FloatArray) -> None:
    """Add the movement to pitch, yaw and roll (T, 3) of neck and head."""
    course = course_of(behavior)
    first, last = np.searchsorted(times_s, [course.start_s, course.end_s])
    during, frame_s = slice(max(first - 1, 0), last + 1), float(times_s[1] - times_s[0])
    for turned, ahead in ((neck_turn, 0.5), (head_turn, -0.5)):
        turned[during] += limited_speed(movement_angles(times_s[during], behavior, ahead=ahead), frame_s)


def _calm(times_s: FloatArray, movements: Sequence[Behavior]) -> FloatArray:
    """The weight (T,) of idle movement: less during nods and shakes, so that their extremes are on time."""
    busy = np.zeros(len(times_s))
    for movement in movements:
        sync, kind = movement.sync, MOVEMENTS[movement.lexeme]
        if not any((*kind.nods, *kind.swings)):
            continue
        during = slice(*np.searchsorted(times_s, [sync.start, sync.end]))
        edge_s = (sync.end - sync.start) / 4
        around = plateau(times_s[during], sync.start, sync.start + edge_s, sync.end - edge_s, sync.end)
        busy[during] = np.maximum(busy[during], around)
    return np.asarray(1.0 - _CALMED * busy)


def within_speed(rotations: FloatArray, frame_s: float, fastest_rad_s: float) -> FloatArray:
    """The same rotations where none is farther from the one before than the speed allows; where one is, those that
    follow go after it at that speed until they have caught up."""
    most = fastest_rad_s * frame_s
    cosines = np.abs(np.einsum("tk,tk->t", rotations[1:], rotations[:-1]))
    too_far = np.flatnonzero(cosines < np.cos(most / 2)) + 1
    if not len(too_far):
        return rotations
    kept = rotations.copy()
    frame = int(too_far[0])
    while frame < len(kept):
        away = float(angle_between(kept[frame], kept[frame - 1]))
        if away > most:
            reached = slerp(kept[frame - 1], kept[frame], np.array(most / away))
            kept[frame] = nearest_sign(reached, rotations[frame])
            frame += 1
        else:
            later = too_far[too_far > frame]
            frame = int(later[0]) if len(later) else len(kept)
    return kept
