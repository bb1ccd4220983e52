"""The head controller: adds head movements to the gaze's rotations of neck and head (paper §3.8), and what the head
does by itself.

Neck and head each take half of a movement; the neck leads by a phase shift. The eyes keep their direction. Between
movements head and trunk change their attitude (`understudy.realizer.head_and_gaze.attitudes`). Whatever is asked for,
and however much of it at once, the head turns no faster than `FASTEST_RAD_S` against the trunk and the eyes no faster
than `FASTEST_EYE_RAD_S`: it comes later, so nothing ever jumps.

A movement has a lexeme: nods and shakes are phase-shifted sine waves (paper §3.8), tilts and turns are held. A nod is a
wave that starts and ends at its crest, so that it goes down from the current position and returns to it; a shake swings
to both sides, its first and last quarter smoothed. Their phase advances such that the extreme nearest to `stroke` falls
on it. Tilts, turns and the like are reached at `stroke` and held until `relax`. None is cut: what has no time to return
returns later.

Conventions: degrees in the table, else radians; positive pitch is down, yaw left, roll to the right shoulder; rotations
are quaternions (T, 4), a frame each; seconds.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import hypot, radians
from types import MappingProxyType

import numpy as np

from ...model import Behavior, Channel, FloatArray, Schedule, SyncPoints
from ..body.limits import within_neck_limits
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.curves import clipped, plateau
from ..geometry.rotations import (
    at_times,
    from_axis_angle,
    from_pitch_yaw_roll,
    inverse,
    length,
    multiply,
    within_speed,
)
from .attitudes import HeadAttitude, head_attitude, waiting_for_words
from .gaze import EYES, TRUNK, chest, eye_rotations, face, fixation_point_m

Degrees = tuple[float, float, float]
"""Pitch, yaw and roll."""


@dataclass(frozen=True, slots=True)
class HeadMovement:
    """The components of a lexeme at amount 1: `nods` return to the start, `swings` go to both sides, `held` is kept."""

    nods: Degrees = (0.0, 0.0, 0.0)
    swings: Degrees = (0.0, 0.0, 0.0)
    held: Degrees = (0.0, 0.0, 0.0)


MOVEMENTS: Mapping[str, HeadMovement] = MappingProxyType(
    {
        "NOD": HeadMovement(nods=(20.0, 0.0, 0.0)),
        "TOSS": HeadMovement(nods=(-18.0, 3.0, 4.0)),
        "CHIN_RAISE": HeadMovement(nods=(-18.0, 0.0, 0.0)),
        "SHAKE": HeadMovement(swings=(0.0, 22.0, 0.0)),
        "SWAY": HeadMovement(swings=(0.0, 3.0, -15.0)),
        "TILT_LEFT": HeadMovement(held=(0.0, 0.0, -20.0)),
        "TILT_RIGHT": HeadMovement(held=(0.0, 0.0, 20.0)),
        "TILT_LEFT_NOD": HeadMovement(nods=(18.0, 0.0, 0.0), held=(0.0, 0.0, -14.0)),
        "TILT_RIGHT_NOD": HeadMovement(nods=(18.0, 0.0, 0.0), held=(0.0, 0.0, 14.0)),
        "BOW": HeadMovement(held=(30.0, 0.0, 0.0)),
        "RAISE": HeadMovement(held=(-18.0, 0.0, 0.0)),
        "LOWER": HeadMovement(held=(18.0, 0.0, 0.0)),
        "TURN_LEFT": HeadMovement(held=(0.0, 25.0, 0.0)),
        "TURN_RIGHT": HeadMovement(held=(0.0, -25.0, 0.0)),
    }
)
"""The amplitudes are ours: a big nod (amount .9) of 18°, a small one of 6°, well within the neck's range."""

DEFAULT_AMOUNT = 0.5

PHASE_SHIFT = np.radians(35.0)
"""How far the neck leads the head in the middle of a movement."""

_AHEAD: FloatArray = np.array([0.5, -0.5])
"""By which shares of that neck and head are ahead of the movement."""

DECAY = 0.65
"""The size of each nod relative to the one before."""

SHORTEST_WAVE_S = 0.2
FASTEST_WAVE_RAD_S = np.radians(95.0)
"""Nods and shakes are limited to 5 Hz, and each of the two joints to this, whatever the schedule says."""

LEAST_S, LEAST_S_PER_RADIAN = 0.08, 0.007 * 180 / np.pi
"""What the way to an extreme takes at least, and the way back: 18° peak at 160°/s. A movement for which the schedule
has less time begins earlier or ends later, as faces do."""

HELD_S, HELD_S_PER_RADIAN, LONGEST_WAY_S = 0.14, 0.012 * 180 / np.pi, 0.3
"""The same for what is held, which is a posture and no beat: a tilt of 10° takes .26 s, if the schedule has no more."""


@dataclass(frozen=True, slots=True)
class MovementTimes:
    """The times of a movement as it is made: it starts, is at its extreme, is left (if it is held), and is over."""

    start_s: float
    stroke_s: float
    relax_s: float
    end_s: float


def movement_angles(times_s: FloatArray, behavior: Behavior, *, ahead: FloatArray) -> FloatArray:
    """Pitch, yaw and roll (T, N, 3) of joints at frames within the movement. Its phase leads by the shares `ahead` (N,)
    of `PHASE_SHIFT` in the middle."""
    movement, waves, course = MOVEMENTS[behavior.lexeme], cycle_count(behavior), course_of(behavior)
    turned = np.zeros((len(times_s), len(ahead), 3))
    if any(movement.nods):
        turned += _nodding(_phase(times_s, course, waves, np.pi, ahead), waves)[..., None] * movement.nods
    if any(movement.swings):
        turned += _swinging(_phase(times_s, course, waves, np.pi / 2, ahead), waves)[..., None] * movement.swings
    if any(movement.held):
        held = plateau(times_s, course.start_s, course.stroke_s, course.relax_s, course.end_s)
        turned += held[:, None, None] * movement.held
    return turned * radians(_amount(behavior) / 2)


def course_of(behavior: Behavior) -> MovementTimes:
    """When the movement is made, with time enough to reach its extreme and to return."""
    sync, movement = behavior.sync, MOVEMENTS[behavior.lexeme]
    stroke_s = (sync.start + sync.end) / 2 if sync.stroke is None else sync.stroke
    relax_s = stroke_s if sync.relax is None else max(sync.relax, stroke_s)
    widest = max(hypot(*each) for each in (movement.nods, movement.swings, movement.held))
    angle = _amount(behavior) * radians(widest)
    least_s = LEAST_S + LEAST_S_PER_RADIAN * angle
    if any(movement.held):
        least_s = max(least_s, min(HELD_S + HELD_S_PER_RADIAN * angle, LONGEST_WAY_S))
    left_s = relax_s if any(movement.held) else stroke_s
    return MovementTimes(min(sync.start, stroke_s - least_s), stroke_s, relax_s, max(sync.end, left_s + least_s))


def realized_heads(behaviors: Iterable[Behavior]) -> dict[str, SyncPoints]:
    """The actual sync points of each kept head movement that is known, by its id."""
    found = {}
    for behavior in behaviors:
        if behavior.kept and behavior.kind is Channel.HEAD and behavior.lexeme in MOVEMENTS:
            course = course_of(behavior)
            found[behavior.id] = replace(behavior.sync, start=max(course.start_s, 0.0), end=course.end_s)
    return found


def cycle_count(behavior: Behavior) -> int:
    """The number of nods or shakes: as many as requested, if there is time for them."""
    time_for = int((behavior.sync.end - behavior.sync.start) / SHORTEST_WAVE_S)
    return max(1, min(behavior.repetitions or 1, time_for))


def limited_speed(turned: FloatArray, frame_s: float) -> FloatArray:
    """The same curves (T, N, 3), each reduced in size where it would exceed the greatest speed of a wave."""
    speeds = length(turned[1:] - turned[:-1]).max(axis=0, initial=0.0) / frame_s
    return np.asarray(turned * (FASTEST_WAVE_RAD_S / np.maximum(speeds, FASTEST_WAVE_RAD_S)))


def _phase(
    times_s: FloatArray, course: MovementTimes, waves: int, first_extreme: float, ahead: FloatArray
) -> FloatArray:
    """The phases (T, N) from 0 at the start to 2π × `waves` at the end, with an extreme at the stroke; they lead by the
    shares `ahead` (N,) of `PHASE_SHIFT` in the middle. After `first_extreme`, extremes are π apart in swings and 2π in
    nods."""
    last = 2 * np.pi * waves
    between = np.pi if first_extreme < np.pi else 2 * np.pi
    even = last * (course.stroke_s - course.start_s) / (course.end_s - course.start_s)
    extreme = first_extreme + between * min(max(round((even - first_extreme) / between), 0), round(last / between) - 1)
    phase = np.interp(times_s, [course.start_s, course.stroke_s, course.end_s], [0.0, extreme, last])
    return np.asarray(phase[:, None] + np.sin(np.pi * phase[:, None] / last) ** 2 * (PHASE_SHIFT * ahead))


def _nodding(phase: FloatArray, waves: int) -> FloatArray:
    """0 at each full wave, with peaks of decreasing height between."""
    sizes = DECAY ** np.arange(waves)
    return np.asarray((1 - np.cos(phase)) / 2 * sizes[clipped(phase / (2 * np.pi), 0, waves - 1).astype(int)])


def _swinging(phase: FloatArray, waves: int) -> FloatArray:
    """A sine whose first and last quarter are squared, so that it starts and ends with zero velocity."""
    left, quarter = 2 * np.pi * waves - phase, np.pi / 2
    return np.asarray(np.sin(phase) * np.sin(clipped(phase, 0, quarter)) * np.sin(clipped(left, 0, quarter)))


def _amount(behavior: Behavior) -> float:
    """Its size, in parts of that in the table."""
    return DEFAULT_AMOUNT if behavior.amount is None else behavior.amount


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
    """The body, changed in place, with the schedule's head movements on neck and head, and idle movement of trunk, neck
    and head.
    `seen_m` (T, 3) is where the eyes look, which saves finding it out; `trunk_s` (T,) are the times at which the trunk
    is as it is in the frames, if others than theirs."""
    times_s, rotations, frame_s = body.times_s, body.rotations, float(body.times_s[1] - body.times_s[0])
    joints, eyes, trunk = skeleton.chain("neck", "head"), skeleton.chain(*EYES), skeleton.rows(*TRUNK)
    seen_m = _seen_m(skeleton, body) if seen_m is None else seen_m
    waiting_s = waiting_for_words(times_s, schedule.words)
    before = at_times(rotations[:, skeleton.rows("neck", "head")], times_s, waiting_s)
    idle = head_attitude(times_s, schedule, seed=seed)
    trunk_s = times_s if trunk_s is None else trunk_s
    share = from_pitch_yaw_roll(*(np.interp(trunk_s, times_s, angle) / len(TRUNK) for angle in idle.trunk.T))
    rotations[:, trunk] = multiply(rotations[:, trunk], share[:, None])
    turned = multiply(before, from_pitch_yaw_roll(*_turns(times_s, schedule, idle).transpose(2, 0, 1)))
    neck, skull = turned[:, 0], turned[:, 1]
    over_chest = within_speed(within_neck_limits(multiply(neck, skull)), frame_s, FASTEST_RAD_S)
    neck = multiply(neck, from_axis_angle(_PITCH, idle.forward))
    skull = multiply(inverse(neck), over_chest)
    rotations[:, joints[0]], rotations[:, joints[1]] = neck, skull
    looking = eye_rotations(face(skeleton, chest(skeleton, rotations, body.hips_m), neck, skull), seen_m)
    for place, eye in enumerate(eyes):
        rotations[:, eye] = within_speed(looking[:, place], frame_s, FASTEST_EYE_RAD_S)
    return body


def _seen_m(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    """Where the eyes look (T, 3)."""
    neck, skull = (body.rotations[:, joint] for joint in skeleton.chain("neck", "head"))
    where = face(skeleton, chest(skeleton, body.rotations, body.hips_m), neck, skull)
    return fixation_point_m(where, body.rotations.take(skeleton.chain(*EYES), axis=1))


def _turns(times_s: FloatArray, schedule: Schedule, idle: HeadAttitude) -> FloatArray:
    """Pitch, yaw and roll (T, 2, 3) that neck and head turn beyond the gaze."""
    movements = [
        each for each in schedule.behaviors if each.kept and each.kind is Channel.HEAD and each.lexeme in MOVEMENTS
    ]
    turned = np.empty((len(times_s), 2, 3))
    calm = _calm(times_s, movements)[:, None]
    np.multiply(calm, idle.neck, out=turned[:, 0])
    np.multiply(calm, idle.head, out=turned[:, 1])
    turned += idle.held[:, None] / 2
    for movement in movements:
        _add(times_s, movement, turned)
    return turned


def _add(times_s: FloatArray, behavior: Behavior, turned: FloatArray) -> None:
    """Add the movement to pitch, yaw and roll (T, 2, 3) of neck and head."""
    course = course_of(behavior)
    first, last = np.searchsorted(times_s, [course.start_s, course.end_s])
    during, frame_s = slice(max(first - 1, 0), last + 1), float(times_s[1] - times_s[0])
    turned[during] += limited_speed(movement_angles(times_s[during], behavior, ahead=_AHEAD), frame_s)


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
