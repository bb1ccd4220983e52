"""The gaze controller: the eyes reach the target first, the head follows, the trunk contributes a little (paper §3.8).

Gaze overrides neck, head and eyes. Unlike in the paper, the trunk's rotation is added to its current motion, so that
the body still leans and breathes. While head and body move, the eyes stay on the target (vestibulo-ocular reflex) as
far as they can rotate. A line that opens with a turn to whom it is said begins with the eyes beside him.

Both eyes converge on a point, within their limits, which are those of the eye in the head. Conventions: metres and
radians in the world; an unrotated eye looks along the head's +Z. The eyes' rotations have no roll.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Schedule
from ..body.limits import within_neck_limits
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.curves import clipped, superposed_movements
from ..geometry.noise import perlin
from ..geometry.rotations import (
    from_axis_angle,
    from_pitch_yaw,
    from_rotation_vector,
    inverse,
    length,
    multiply,
    pitch_and_yaw,
    rotate,
    to_rotation_vector,
    unit_vector,
)
from ..gestures.gesture_plan import Position
from .gaze_targets import GazeTargets, gaze_targets

EYES = ("leftEye", "rightEye")
TRUNK = ("spine", "chest", "upperChest")

SIDEWAYS_LIMIT = np.radians(35.0)
UPRIGHT_LIMIT = np.radians(25.0)

FARTHEST_M = 20.0
"""The eyes are parallel for targets beyond this distance."""

_LIMITS = np.array([UPRIGHT_LIMIT, SIDEWAYS_LIMIT])[:, None, None]
_NEAR_ENOUGH = 0.4
"""Within this share of `FARTHEST_M` along each axis a point is nearer than that, and no eye's line ends before it."""
_PARALLEL = 1e-6
_AHEAD = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class Chest:
    """What carries the head: the upper chest's orientation in the world (T, 4), and the neck's position (T, 3)."""

    orientation: FloatArray
    neck_m: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Face:
    """The head's orientation in the world (T, 4), and the positions of the left and right eye (T, 2, 3)."""

    orientation: FloatArray
    eyes_m: FloatArray


def chest(skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> Chest:
    """The chest, from the rotations of the joints between hips and neck."""
    turned = [rotations[:, 0]]
    for joint in skeleton.chain(*TRUNK):
        turned.append(multiply(turned[-1], rotations[:, joint]))
    offsets_m = skeleton.offsets_m[skeleton.chain(*TRUNK, "neck")]
    return Chest(turned[-1], hips_m + rotate(np.array(turned), offsets_m[:, None]).sum(axis=0))


def face(skeleton: Skeleton, carried_by: Chest, neck: FloatArray, head: FloatArray) -> Face:
    """Head and eyes on the chest, for local rotations (T, 4) of neck and head."""
    joint, *eyes = skeleton.chain("head", *EYES)
    turned = multiply(carried_by.orientation, neck)
    head_m = carried_by.neck_m + rotate(turned, skeleton.offsets_m[joint])
    turned = multiply(turned, head)
    eyes_m = head_m + rotate(turned, skeleton.offsets_m[eyes, None])  # one eye after the other, for speed
    return Face(turned, eyes_m.swapaxes(0, 1))


def eye_rotations(where: Face, at_m: FloatArray) -> FloatArray:
    """The rotations (T, 2, 4) of the left and right eye towards the points `at_m` (T, 3), within their limits."""
    return from_pitch_yaw(*clipped(_asked_of_eyes(where, at_m), -_LIMITS, _LIMITS))


def _asked_of_eyes(where: Face, at_m: FloatArray) -> FloatArray:
    """Pitch and yaw (2, T, 2) at which the left and right eye look at the points (T, 3)."""
    ways_m = at_m - where.eyes_m.swapaxes(0, 1)
    return np.array(pitch_and_yaw(rotate(inverse(where.orientation), ways_m))).swapaxes(1, 2)


def looking(where: Face, at_m: FloatArray) -> tuple[FloatArray, FloatArray]:
    """`eye_rotations`, and the points (T, 3) at which the eyes look then: `at_m`, but where their limits keep them from
    it, or where it is so far that they are parallel."""
    asked = _asked_of_eyes(where, at_m)
    within = clipped(asked, -_LIMITS, _LIMITS)
    eyes, seen_m = from_pitch_yaw(*within), at_m
    missed = (np.abs(asked) >= _LIMITS).any(axis=(0, 2)) | (np.abs(at_m).max(axis=1) > _NEAR_ENOUGH * FARTHEST_M)
    if missed.any():
        seen_m = at_m.copy()
        seen_m[missed] = fixation_point_m(Face(where.orientation[missed], where.eyes_m[missed]), eyes[missed])
    return eyes, seen_m


def fixation_point_m(where: Face, eyes: FloatArray) -> FloatArray:
    """The points (T, 3) at which eyes with these rotations (T, 2, 4) look: where their lines of sight come nearest."""
    lines = rotate(multiply(where.orientation[:, None], eyes), _AHEAD)
    left, right = lines[:, 0], lines[:, 1]
    base = where.eyes_m[:, 0] - where.eyes_m[:, 1]
    cosine, on_left, on_right = (np.sum(a * b, axis=-1) for a, b in ((left, right), (base, left), (base, right)))
    sine_squared = 1.0 - cosine**2
    along = np.stack([cosine * on_right - on_left, on_right - cosine * on_left], axis=-1)
    along_m = clipped(along / np.maximum(sine_squared, _PARALLEL)[:, None], 0.0, FARTHEST_M)
    ends_m = where.eyes_m + np.where(sine_squared < _PARALLEL, FARTHEST_M, along_m.T).T[:, :, None] * lines
    return np.asarray(ends_m.mean(axis=1))


def point_in_direction(pitch: FloatArray, yaw: FloatArray, distance_m: FloatArray, from_m: FloatArray) -> FloatArray:
    """The points (T, 3) at a distance from `from_m` in the direction of `pitch` and `yaw`."""
    return np.asarray(from_m + distance_m[:, None] * unit_vector(pitch, yaw))


NECK_SHARE = np.array([0.6, 0.45, 0.75])
"""The neck's shares of the head's pitch, yaw and roll over the chest; the rest is the head joint's. Skull and upper two
vertebrae make about half of a turn, a third of a nod and a quarter of a tilt (Bogduk & Mercer 2000)."""

OPENING_DEGREES = (9.0, 16.0)
"""How far down and to one side a line is begun whose first look is to the listener, at most; at least half of it."""

HEAD_LAG_S = 0.06
"""The head is heavier and starts later than the eyes; the trunk starts later than the head."""
TRUNK_LAG_S = 0.12

HEAD_S, HEAD_S_PER_RADIAN = 0.22, 0.011 * 180 / np.pi
"""The minimum duration of a head movement, kept even if the schedule has less: 20° peak at about 85°/s."""
TRUNK_SLOWNESS = 1.8

_UPWARDS = (0.0, 1.0, 0.0)


def apply_gaze(
    skeleton: Skeleton,
    body: BodyMotion,
    schedule: Schedule,
    *,
    targets_m: Mapping[str, Position] = MappingProxyType({}),
    seed: int = 0,
) -> tuple[BodyMotion, FloatArray]:
    """The body, changed in place, with eyes, head and trunk following the schedule's gazes, and looking at the listener
    otherwise; and the points (T, 3) at which the eyes look.

    `targets_m` has the world positions of targets; any other target is the other person (`LISTENER_M`).
    """
    times_s, from_m = body.times_s, eyes_in_t_pose_m(skeleton)
    before = (1 - schedule.stillness) * _elsewhere(seed)
    line, head, trunk = _courses(times_s, gaze_targets(schedule, from_m, targets_m, before=before))
    rotations, joints = body.rotations, skeleton.rows(*TRUNK)
    rotations[:, joints] = multiply(rotations[:, joints], from_axis_angle(_UPWARDS, trunk / len(TRUNK))[:, None])
    carrying = chest(skeleton, rotations, body.hips_m)
    neck, skull = _shared_out(carrying, head)
    aside = (1 - schedule.stillness) * fixation_offsets(times_s, seed=seed)
    at_m = point_in_direction(line[:, 0] + aside[:, 0], line[:, 1] + aside[:, 1], 1.0 / line[:, 2], from_m)
    rotations[:, skeleton.index["neck"]], rotations[:, skeleton.index["head"]] = neck, skull
    rotations[:, skeleton.chain(*EYES)], seen_m = looking(face(skeleton, carrying, neck, skull), at_m)
    return body, seen_m


def _courses(times_s: FloatArray, aims: GazeTargets) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The eyes' pitch, yaw and inverse distance (T, 3), the head's pitch and yaw (T, 2), and the trunk's yaw (T,)."""
    eyes_by, head_by, trunk_by = (np.diff(each, axis=0) for each in (aims.eyes, aims.head, aims.trunk))
    eyes_s = saccade_s(length(eyes_by[:, :2])[:, 0])
    head_s = np.maximum(HEAD_S + HEAD_S_PER_RADIAN * length(head_by)[:, 0], aims.within_s - HEAD_LAG_S)
    starts_s = [aims.starts_s + lag_s for lag_s in (0.0, HEAD_LAG_S, TRUNK_LAG_S)]
    by = np.zeros((3, len(eyes_s), 6))
    by[0, :, :3], by[1, :, 3:5], by[2, :, 5:] = eyes_by, head_by, trunk_by
    durations_s = np.concatenate([eyes_s, head_s, TRUNK_SLOWNESS * head_s])
    course = superposed_movements(times_s, np.concatenate(starts_s), durations_s, by.reshape(-1, 6))
    course += np.concatenate([aims.eyes[0], aims.head[0], aims.trunk[0]])
    return course[:, :3], course[:, 3:5], course[:, 5]


def _shared_out(carrying: Chest, head: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The rotations (T, 4) of neck and head that give the head the pitch and yaw `head` (T, 2) in the world."""
    in_world = from_pitch_yaw(head[:, 0], head[:, 1])
    over_chest = within_neck_limits(multiply(inverse(carrying.orientation), in_world))
    neck = from_rotation_vector(NECK_SHARE * to_rotation_vector(over_chest))
    return neck, multiply(inverse(neck), over_chest)


@lru_cache(maxsize=64)
def _elsewhere(seed: int) -> FloatArray:
    """Pitch and yaw (2,) of a place beside the listener, a little down. Cached, since most lines have the same seed;
    never mutated."""
    generator = np.random.default_rng(seed + 8)
    side = float(generator.choice([-1.0, 1.0]))
    return np.asarray(np.radians(OPENING_DEGREES) * generator.uniform(0.5, 1.0, 2) * [1.0, side])


@lru_cache(maxsize=64)
def eyes_in_t_pose_m(skeleton: Skeleton) -> FloatArray:
    """The point between the eyes (3,). Cached; never mutated."""
    down = skeleton.chain("hips", "spine", "chest", "upperChest", "neck", "head")
    return np.asarray(skeleton.offsets_m[down].sum(axis=0) + skeleton.offsets_m[skeleton.chain(*EYES)].mean(axis=0))


SACCADE_S, SACCADE_S_PER_RADIAN = 0.021, 0.0022 * 180 / np.pi
"""The main sequence of saccades: 2.2 ms per degree plus 21 ms (Carpenter 1988)."""

PARTS = np.radians([[0.0, 1.2], [0.0, -1.2], [1.3, 0.2]])
"""For a face at 1.2 m with eyes 6 cm apart; at most 2° from its centre in all."""

SHORTEST_S, MEAN_S = 0.3, 1.1
"""Fixation durations: the first is a minimum, the rest is drawn from an exponential distribution."""

_FIXATIONS_AT_ONCE = 64
"""Drawn together: some 20 s of them at the shortest."""

DRIFT_DEGREES, DRIFT_HZ = 0.3, 1.7


def saccade_s(angle: FloatArray) -> FloatArray:
    """The durations of saccades of these angles."""
    return np.asarray(SACCADE_S + SACCADE_S_PER_RADIAN * angle)


def fixation_offsets(times_s: FloatArray, *, seed: int) -> FloatArray:
    """Pitch and yaw (T, 2) relative to the target's centre; deterministic for a seed."""
    count = int((times_s[-1] - times_s[0]) / SHORTEST_S) + 2
    starts_s, parts = _fixations(seed, -(-count // _FIXATIONS_AT_ONCE) * _FIXATIONS_AT_ONCE)
    starts_s, parts = times_s[0] + starts_s[:count], parts[: count + 1]
    by = parts[1:] - parts[:-1]
    drift = perlin(times_s, frequency_hz=DRIFT_HZ, seed=seed + 5, channels=2, in_step=False)
    jumps = superposed_movements(times_s, starts_s, saccade_s(length(by)[:, 0]), by)
    return np.asarray(parts[0] + jumps + np.radians(DRIFT_DEGREES) * drift)


@lru_cache(maxsize=64)
def _fixations(seed: int, count: int) -> tuple[FloatArray, FloatArray]:
    """When so many fixations begin, from the first frame on, and where (count + 1, 2) the eyes are before and in each.
    Cached, since most lines have the same seed; never mutated."""
    when, where = (np.random.default_rng(each) for each in np.random.SeedSequence(seed).spawn(2))
    starts_s = np.cumsum(SHORTEST_S + when.exponential(MEAN_S - SHORTEST_S, count))
    return starts_s, PARTS[np.cumsum(where.integers(1, len(PARTS), count + 1)) % len(PARTS)]
