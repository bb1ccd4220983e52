"""The head controller: adds head movements to the gaze's rotations of neck and head (paper §3.8), and idle movement.

Neck and head each take half of a movement; the neck leads by a phase shift. The eyes keep their direction. Between
movements the head is never quite still.

Conventions: degrees in the constants, else radians; positive pitch is down, yaw left, roll to the right shoulder;
seconds.
"""

from collections.abc import Sequence

import numpy as np

from ...model import Behavior, Channel, FloatArray, Schedule
from ..body.limits import within_neck_limits
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.angles import from_pitch_yaw_roll
from ..geometry.easing import plateau, superposed_movements
from ..geometry.noise import perlin
from ..geometry.rotations import inverse, multiply
from ..torso.idle_activity import idle_activity
from .gaze_geometry import EYES, chest, eye_rotations, face, fixation_point_m
from .head_movements import MOVEMENTS, limited_speed, movement_angles

_IDLE_DEGREES, _IDLE_HZ = (3.0, 4.0, 2.6), 0.5
_TREMBLE_DEGREES, _TREMBLE_HZ = 0.25, 2.3
"""Amplitudes of idle noise; the typical deviation is a quarter of them."""

_CALMED = 0.75
"""The share of idle noise that is suppressed in the middle of a movement."""

_EMPHASIS_DEGREES, _EMPHASIS_S = 1.6, 0.18
"""Emphasized words show in the head a little without any behaviour: down within this time, and back in twice as
much."""


def apply_head_movements(skeleton: Skeleton, body: BodyMotion, schedule: Schedule, *, seed: int) -> BodyMotion:
    """The body with the schedule's head movements, and idle movement between them, on neck and head."""
    times_s = body.times_s
    movements = [
        each for each in schedule.behaviors if each.kept and each.kind is Channel.HEAD and each.lexeme in MOVEMENTS
    ]
    neck_turn, head_turn = _still_moving(times_s, schedule, seed)
    calm = _calm(times_s, movements)[:, None]
    neck_turn *= calm
    head_turn *= calm
    for movement in movements:
        _add(times_s, movement, neck_turn, head_turn)
    neck, skull = (body.rotations[:, joint] for joint in skeleton.chain("neck", "head"))
    eyes = skeleton.chain(*EYES)
    carrying = chest(skeleton, body.rotations, body.hips_m)
    at_m = fixation_point_m(face(skeleton, carrying, neck, skull), body.rotations[:, eyes])
    neck, skull = multiply(neck, from_pitch_yaw_roll(*neck_turn.T)), multiply(skull, from_pitch_yaw_roll(*head_turn.T))
    skull = multiply(inverse(neck), within_neck_limits(multiply(neck, skull)))
    rotations = body.rotations.copy()
    rotations[:, skeleton.index["neck"]], rotations[:, skeleton.index["head"]] = neck, skull
    rotations[:, eyes] = eye_rotations(face(skeleton, carrying, neck, skull), at_m)
    return BodyMotion(times_s, rotations, body.hips_m)


def _add(times_s: FloatArray, behavior: Behavior, neck_turn: FloatArray, head_turn: FloatArray) -> None:
    """Add the movement to pitch, yaw and roll (T, 3) of neck and head."""
    during = slice(*np.searchsorted(times_s, [behavior.sync.start, behavior.sync.end]))
    frame_s = float(times_s[1] - times_s[0])
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


def _still_moving(times_s: FloatArray, schedule: Schedule, seed: int) -> tuple[FloatArray, FloatArray]:
    """Pitch, yaw and roll (T, 3) of idle neck and head movement: noise, and a dip at each emphasis."""
    slow = perlin(times_s, frequency_hz=_IDLE_HZ, seed=seed + 3, channels=3, in_step=False)
    slow *= idle_activity(schedule) * np.radians(_IDLE_DEGREES) / 2
    tremble = perlin(times_s, frequency_hz=_TREMBLE_HZ, seed=seed + 4, channels=6, in_step=False)
    tremble *= (1 - schedule.stillness) * np.radians(_TREMBLE_DEGREES)
    stressed_s = np.array(schedule.emphases_s)
    dips = np.full((len(stressed_s), 1), np.radians(_EMPHASIS_DEGREES) / 2)
    down = superposed_movements(times_s, stressed_s - _EMPHASIS_S, np.full(len(dips), _EMPHASIS_S), dips)
    back = superposed_movements(times_s, stressed_s, np.full(len(dips), 2 * _EMPHASIS_S), dips)
    slow[:, :1] += (1 - schedule.stillness) * (down - back)
    return slow + tremble[:, :3], slow + tremble[:, 3:]
