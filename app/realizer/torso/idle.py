"""Idle motion: the body stands, breathes, sways, and is never quite still (paper §3.8).

All other controllers build on this motion. Conventions: degrees in the tables, radians and metres elsewhere; the arms
hang at the sides until gestures override them; neck and head are straight until the gaze turns them. The amplitudes are
ours: enough to look alive, too little to attract attention.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Hand, Schedule
from ..arms.rest_poses import rest_pose
from ..body.motion import BodyMotion
from ..body.movement_style import PLAIN, IdleLife
from ..body.skeleton import SIDES, Skeleton
from ..geometry.angles import from_pitch_yaw_roll
from ..geometry.noise import perlin
from ..geometry.rotations import IDENTITY, multiply
from ..gestures.arm_joints import arm_joints
from .balance import hips_height_m, set_legs
from .breathing import QUIET_CYCLE_S, lung_volume
from .idle_activity import IDLE_ACTIVITY, idle_activity
from .posture import TrunkPosture, trunk_postures

Degrees = tuple[float, float, float]
"""Pitch, yaw and roll of the left side; yaw and roll change sign on the right."""

UNEVEN_WEIGHT = 0.4
"""Nobody puts equal weight on both legs; which leg bears more is random and changes slowly."""

_HIPS_OVER_LEG_M = 0.05
"""The lateral shift of the hips when one leg bears all the weight, and how much higher its hip is."""
_PELVIS_DEGREES = 4.0
_HIPS_BACK_M = 0.22
"""How far the hips move back per radian of forward lean, to keep the balance."""

_LEAN: Mapping[str, float] = MappingProxyType({"hips": 0.4, "spine": 0.3, "chest": 0.3})
"""The joints' shares of a lean."""
_UPRIGHT: Mapping[str, float] = MappingProxyType({"hips": 1.0, "spine": -0.7, "chest": -0.5})
"""The joints' compensation of a tilted pelvis, which keeps the trunk upright."""

_BREATH: Mapping[str, Degrees] = MappingProxyType(
    {"spine": (0.4, 0.0, 0.0), "chest": (-1.4, 0.0, 0.0), "upperChest": (-0.7, 0.0, 0.0)}
)
"""Rotations with full lungs."""

_SLUMP: Mapping[str, float] = MappingProxyType({"hips": 0.0, "spine": 0.0, "chest": 0.45, "upperChest": 0.55})
"""The joints' shares of a rounded upper back."""

_STIRRING_HZ = 0.6
_STIRRING_DEGREES = 1.2
"""Noise of trunk and arms; the typical deviation is a quarter of the amplitude."""

_LOWERED = 0.6
"""How far the bobbing hips are lowered on average, as a share of the bob: they never rise beyond the legs' reach."""

_TRUNK = ("hips", "spine", "chest", "upperChest")
_STIRRED: Mapping[str, Degrees] = MappingProxyType(
    {"Shoulder": (0.0, 1.0, -1.0), "UpperArm": (1.0, 1.0, -1.0), "LowerArm": (2.0, 0.0, 0.0)}
)
"""Noise of the arm joints, about the axes in which they can rotate: the forearm twists."""


def idle_motion(
    skeleton: Skeleton,
    times_s: FloatArray,
    schedule: Schedule,
    *,
    seed: int,
    life: IdleLife = PLAIN.idle,
    with_legs: bool = True,
) -> BodyMotion:
    """The idle motion at `times_s` (T,), with the schedule's postures, and breaths in its speech pauses. The feet stay
    in place, unless legs are left straight (not `with_legs`) for a later controller that moves the hips and solves them
    again. Deterministic for a seed."""
    generator = np.random.default_rng(seed)
    held = trunk_postures(times_s, schedule.behaviors, weight=UNEVEN_WEIGHT * float(generator.choice([-1.0, 1.0])))
    wandering = life.weight * perlin(times_s, frequency_hz=life.weight_hz, seed=seed + 2)[:, 0]
    held = replace(held, weight=held.weight + (1 - schedule.stillness) * wandering)
    cycle_s, lively = QUIET_CYCLE_S / IDLE_ACTIVITY[schedule.agitation], idle_activity(schedule)
    breath = lung_volume(times_s, schedule.phrases, generator, cycle_s=cycle_s)
    rotations = np.tile(_hanging(skeleton), (len(times_s), 1, 1))
    sway = lively * perlin(times_s, frequency_hz=life.sway_hz, seed=seed, channels=14, in_step=False)
    bent_m = life.bob_m * lively * (_LOWERED + perlin(times_s, frequency_hz=life.bob_hz, seed=seed + 3)[:, 0])
    bends = np.radians(life.bend_deg) * sway[:, :12].reshape(-1, len(_TRUNK), 3)
    slump = 0.5 + 2 * lively * perlin(times_s, frequency_hz=life.slump_hz, seed=seed + 5)[:, 0]
    bends[:, :, 0] += np.radians(life.slump_deg) * slump[:, None] * list(_SLUMP.values())
    _hold_trunk(skeleton, rotations, held, breath, bends)
    stirring = lively * perlin(
        times_s, frequency_hz=_STIRRING_HZ, seed=seed + 1, channels=2 * len(_STIRRED), in_step=False
    )
    _stir_arms(skeleton, rotations, np.radians(life.breath_deg) * breath, stirring)
    hips_m = np.zeros((len(times_s), 3))
    hips_m[:, 0] = _HIPS_OVER_LEG_M * held.weight + life.sway_m * sway[:, 12]
    hips_m[:, 2] = -_HIPS_BACK_M * held.forward + life.sway_m * sway[:, 13]
    hips_m[:, 1] = hips_height_m(skeleton, hips_m, rotations[:, 0]) - bent_m
    if with_legs:
        set_legs(skeleton, rotations, hips_m)
    return BodyMotion(times_s, rotations, hips_m)


def _hold_trunk(
    skeleton: Skeleton, rotations: FloatArray, held: TrunkPosture, breath: FloatArray, bends: FloatArray
) -> None:
    """Set lean, weight shift, breath and further `bends` (T, 4, 3) of the joints from the hips up."""
    angles = bends
    for number, joint in enumerate(_TRUNK):
        angles[:, number] += np.radians(_BREATH.get(joint, (0.0, 0.0, 0.0))) * breath[:, None]
        angles[:, number, 0] += _LEAN.get(joint, 0.0) * held.forward
        angles[:, number, 2] += _UPRIGHT.get(joint, 0.0) * np.radians(_PELVIS_DEGREES) * held.weight
        angles[:, number, 2] -= _LEAN.get(joint, 0.0) * held.left
    rotations[:, skeleton.rows(*_TRUNK)] = from_pitch_yaw_roll(*np.moveaxis(angles, -1, 0))


@cache
def _hanging(skeleton: Skeleton) -> FloatArray:
    """The pose (J, 4) with arms at the sides. Cached, since solving it costs as much as a second of motion."""
    pose = np.tile(IDENTITY, (len(skeleton.names), 1))
    for side in (Hand.LEFT, Hand.RIGHT):
        pose[skeleton.rows(*arm_joints(side))] = rest_pose(skeleton, side, "at_side").rotations
    pose.setflags(write=False)
    return pose


def _stir_arms(skeleton: Skeleton, rotations: FloatArray, breath: FloatArray, stirring: FloatArray) -> None:
    """Raise the collarbones by the breath, in radians, and add noise (T, 2 × stirred) to the arm joints."""
    for side, noise in zip(SIDES, np.split(stirring, 2, axis=1), strict=True):
        stirs = np.radians(_STIRRING_DEGREES) * noise[:, :, None] * (_mirrored(side) * list(_STIRRED.values()))
        stirs[:, 0, 2] += _mirrored(side)[2] * breath
        stirred = skeleton.rows(*(side + name for name in _STIRRED))
        rotations[:, stirred] = multiply(rotations[0, stirred], from_pitch_yaw_roll(*np.moveaxis(stirs, -1, 0)))


def _mirrored(side: str) -> FloatArray:
    """The signs of pitch, yaw and roll on that side."""
    return np.array([1.0, 1.0, 1.0] if side == "left" else [1.0, -1.0, -1.0])
