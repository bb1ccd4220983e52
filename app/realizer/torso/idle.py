"""Idle motion: the body stands, breathes, sways, and is never quite still (paper §3.8).

All other controllers build on this motion. The arms hang at the sides until gestures override them; neck and head are
straight until the gaze turns them. The amplitudes are ours: enough to look alive, too little to attract attention.

Breathing: at rest people breathe about 15 times a minute, inhaling for two fifths of the cycle. Speakers inhale quickly
and more deeply in pauses and before the first word, and exhale slowly over whole phrases. Lung volume is 0 after quiet
expiration and 1 after deep inspiration.

TrunkLean: an agitated person leans forward with the chest lifted; a lax person leans back a little with a rounded upper
back. The angles are ours.

Conventions: seconds; degrees in the tables, radians and metres elsewhere; positive pitch is forward.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from ...model import FloatArray, Hand, Interval, Level, Schedule
from ..arms.rest_poses import rest_pose
from ..body.motion import BodyMotion
from ..body.movement_style import PLAIN, IdleLife
from ..body.skeleton import SIDES, Skeleton, arm_joints
from ..geometry.chance import generator_of
from ..geometry.curves import minimum_jerk_through
from ..geometry.noise import Noise, perlins
from ..geometry.rotations import IDENTITY, from_pitch_yaw_roll, multiply
from .balance import hips_height_m, set_legs
from .posture import TrunkPosture, trunk_postures
from .stance import IDLE_ACTIVITY, beside, idle_activity, stances

Degrees = tuple[float, float, float]
"""Pitch, yaw and roll of the left side; yaw and roll change sign on the right."""

UNEVEN_WEIGHT = 0.4
"""People rarely stand with equal weight on both legs; which leg bears more is random and changes slowly."""

_HIPS_OVER_LEG_M = 0.05
"""The lateral shift of the hips when one leg bears all the weight, and how much higher its hip is."""
_PELVIS_DEGREES = 4.0


def lean(level: Level) -> float:
    """The lean of the trunk in radians; the hips move the opposite way."""
    return float(np.radians(TRUNK_LEANS[level].lean_deg))


@cache
def bow(level: Level) -> FloatArray:
    """The pitch of the joints from the hips up (4,), without the lean. Never mutated."""
    return np.asarray(np.radians(TRUNK_LEANS[level].bow_deg) * np.array(list(_BOW.values())))


@dataclass(frozen=True, slots=True)
class TrunkLean:
    """The lean of the whole trunk from the hips, and the bow of the back above them."""

    lean_deg: float
    bow_deg: float


_BOW: Mapping[str, float] = MappingProxyType({"hips": 0.0, "spine": 0.25, "chest": 0.40, "upperChest": 0.35})
"""The joints' shares of a bow."""

TRUNK_LEANS: Mapping[Level, TrunkLean] = MappingProxyType(
    {Level.LOW: TrunkLean(-1.5, 5.0), Level.MEDIUM: TrunkLean(0.0, 0.0), Level.HIGH: TrunkLean(3.0, -3.0)}
)

_HIPS_BACK_M = 0.22
"""How far the hips move back per radian of forward lean, to keep the balance."""

_LEAN: Mapping[str, float] = MappingProxyType({"hips": 0.4, "spine": 0.3, "chest": 0.3})
"""The joints' shares of a lean."""

_UPRIGHT: Mapping[str, float] = MappingProxyType({"hips": 1.0, "spine": -0.7, "chest": -0.5})
"""The joints' compensation of a tilted pelvis, which keeps the trunk upright."""

_BREATH_DEGREES: Mapping[str, float] = MappingProxyType({"spine": 0.4, "chest": -1.4, "upperChest": -0.7})
"""The joints' pitch with full lungs."""

_SLUMP: Mapping[str, float] = MappingProxyType({"hips": 0.0, "spine": 0.0, "chest": 0.45, "upperChest": 0.55})
"""The joints' shares of a rounded upper back."""

_RIBS: Mapping[str, float] = MappingProxyType({"spine": 0.45, "chest": 0.35, "upperChest": 0.2})
"""The joints' shares of the rotation of the ribs against the pelvis."""

_STIRRING_HZ = 0.6

_STIRRING_DEGREES = 1.2
"""Noise of trunk and arms; the typical deviation is a quarter of the amplitude."""

_LOWERED = 0.6
"""How far the bobbing hips are lowered on average, as a share of the bob: they never rise beyond the legs' reach."""

_TRUNK = ("hips", "spine", "chest", "upperChest")

_SWAYS = 14
"""Three angles of each joint of the trunk, and the hips aside and forward."""

_STIRRED: Mapping[str, Degrees] = MappingProxyType(
    {"Shoulder": (0.0, 1.0, -1.0), "UpperArm": (1.0, 1.0, -1.0), "LowerArm": (2.0, 0.0, 0.0)}
)
"""Noise of the arm joints, about the axes in which they can rotate: the forearm twists."""

_ON_THE_RIGHT: FloatArray = np.array([1.0, -1.0, -1.0])
"""The signs of pitch, yaw and roll on the right side."""


def idle_motion(
    skeleton: Skeleton,
    times_s: FloatArray,
    schedule: Schedule,
    *,
    seed: int,
    life: IdleLife = PLAIN.idle,
    with_limbs: bool = True,
) -> BodyMotion:
    """The idle motion at `times_s` (T,), with the postures of the schedule and breaths in its pauses. The feet stay in
    place; without `with_limbs` legs are straight and arms below the collarbones hang still, for later controllers that
    move the hips, solve the legs and set the arms. Deterministic for a seed."""
    generator = generator_of(seed)
    held = trunk_postures(times_s, schedule.behaviors, weight=UNEVEN_WEIGHT * float(generator.choice([-1.0, 1.0])))
    noise = _noise(times_s, life, seed)
    stance = stances(times_s, schedule, life, seed=seed)
    wandering = (1 - schedule.stillness) * life.weight * noise.weight
    weight = beside(held.weight, stance.weight, uneven=UNEVEN_WEIGHT) + wandering
    held = replace(held, weight=weight, forward=held.forward + lean(schedule.agitation))
    cycle_s, lively = QUIET_CYCLE_S / IDLE_ACTIVITY[schedule.agitation], idle_activity(schedule)
    breath = lung_volume(times_s, schedule.phrases, generator, cycle_s=cycle_s)
    rotations = np.empty((len(times_s), len(skeleton.names), 4))
    rotations[:] = _hanging(skeleton)
    sway = lively * noise.sway
    bent_m = life.bob_m * lively * (_LOWERED + noise.bob)
    bends = np.radians(life.bend_deg) * sway[:, :12].reshape(-1, len(_TRUNK), 3)
    bends[:, :, 0] += np.radians(life.slump_deg) * (0.5 + 2 * lively * noise.slump)[:, None] * list(_SLUMP.values())
    bends[:, :, 0] += bow(schedule.agitation)
    bends[:, 1:] += stance.ribs[:, None] * np.array(list(_RIBS.values()))[:, None]
    bends[:, 0, 1] += stance.pelvis
    _hold_trunk(skeleton, rotations, held, breath, bends)
    stirred = tuple(_STIRRED) if with_limbs else ("Shoulder",)
    _stir_arms(skeleton, rotations, stirred, np.radians(life.breath_deg) * breath, lively * noise.stirring)
    hips_m = np.zeros((len(times_s), 3))
    hips_m[:, 0] = _HIPS_OVER_LEG_M * held.weight + life.sway_m * sway[:, 12]
    hips_m[:, 2] = -_HIPS_BACK_M * held.forward + life.sway_m * sway[:, 13]
    hips_m[:, 1] = hips_height_m(skeleton, hips_m, rotations[:, 0]) - bent_m
    if with_limbs:
        set_legs(skeleton, rotations, hips_m)
    return BodyMotion(times_s, rotations, hips_m)


class _IdleNoise(NamedTuple):
    """The idle movement of a standing body: weight (T,), sway (T, 14), bob (T,), slump (T,), and arms (T, 6)."""

    weight: FloatArray
    sway: FloatArray
    bob: FloatArray
    slump: FloatArray
    stirring: FloatArray


def _noise(times_s: FloatArray, life: IdleLife, seed: int) -> _IdleNoise:
    noise = perlins(
        times_s,
        Noise(life.weight_hz, seed + 2),
        Noise(life.bob_hz, seed + 3),
        Noise(life.slump_hz, seed + 5),
        Noise(life.sway_hz, seed, _SWAYS, in_step=False),
        Noise(_STIRRING_HZ, seed + 1, 2 * len(_STIRRED), in_step=False),
    )
    weight, bob, slump = noise[:, :3].T
    return _IdleNoise(weight, noise[:, 3 : 3 + _SWAYS], bob, slump, noise[:, 3 + _SWAYS :])


def _hold_trunk(
    skeleton: Skeleton, rotations: FloatArray, held: TrunkPosture, breath: FloatArray, bends: FloatArray
) -> None:
    """Set lean, weight shift, breath and further `bends` (T, 4, 3) of the joints from the hips up."""
    pitch, yaw, roll = bends[..., 0], bends[..., 1], bends[..., 2]
    breathing, lean, upright = _shares()
    pitch = pitch + breath[:, None] * breathing + held.forward[:, None] * lean
    roll = roll + held.weight[:, None] * upright - held.left[:, None] * lean
    rotations[:, skeleton.rows(*_TRUNK)] = from_pitch_yaw_roll(pitch, yaw, roll)


@cache
def _shares() -> tuple[FloatArray, FloatArray, FloatArray]:
    """Of the joints from the hips up (4,): pitch with full lungs, shares of a lean, and roll with all weight on the
    left leg. Never mutated."""
    breathing = np.radians([_BREATH_DEGREES.get(joint, 0.0) for joint in _TRUNK])
    lean = np.array([_LEAN.get(joint, 0.0) for joint in _TRUNK])
    upright = np.radians(_PELVIS_DEGREES) * np.array([_UPRIGHT.get(joint, 0.0) for joint in _TRUNK])
    return breathing, lean, upright


@cache
def _hanging(skeleton: Skeleton) -> FloatArray:
    """The pose (J, 4) with arms at the sides. Cached, since solving it costs as much as a second of motion."""
    pose = np.tile(IDENTITY, (len(skeleton.names), 1))
    for side in (Hand.LEFT, Hand.RIGHT):
        pose[skeleton.rows(*arm_joints(side))] = rest_pose(skeleton, side, "at_side").rotations
    pose.setflags(write=False)
    return pose


def _stir_arms(
    skeleton: Skeleton, rotations: FloatArray, joints: Sequence[str], breath: FloatArray, stirring: FloatArray
) -> None:
    """Raise the collarbones by the breath, in radians, and add noise (T, 2 × `_STIRRED`) to these first `joints` of
    either arm."""
    stirs = np.radians(_STIRRING_DEGREES) * stirring.reshape(len(breath), len(SIDES), -1)[:, :, : len(joints)]
    pitch, yaw, roll = (stirs * amplitudes[:, : len(joints)] for amplitudes in _stirs())
    roll[:, :, 0] += breath[:, None] * [1.0, _ON_THE_RIGHT[2]]
    turned = from_pitch_yaw_roll(pitch, yaw, roll)
    stirred = skeleton.arms(rotations)[:, :, : len(joints)]
    stirred[...] = multiply(stirred[0], turned)


@cache
def _stirs() -> FloatArray:
    """Pitch, yaw and roll (3, 2, stirred) of either side's arm joints. Never mutated."""
    left = np.array(list(_STIRRED.values())).T
    return np.stack((left, left * _ON_THE_RIGHT[:, None]), axis=1)


QUIET_CYCLE_S = 4.0
INHALING_SHARE = 0.4
QUIET_DEPTH = 0.6
QUICK_BREATH_S = (0.35, 0.8)
SHORTEST_PAUSE_S = 0.25

SHORTEST_BETWEEN_S = 1.5
"""A pause sooner than this after the last breath gets no breath of its own."""


def lung_volume(
    times_s: FloatArray,
    phrases: Sequence[Interval],
    generator: np.random.Generator,
    *,
    cycle_s: float = QUIET_CYCLE_S,
) -> FloatArray:
    """The lung volume (T,), with breaths in the pauses between `phrases` (in order), and quiet breathing with a period
    of about `cycle_s` where nobody speaks."""
    during = Interval(float(times_s[0]), float(times_s[-1]))
    at_s, volumes = np.array(list(_knots(during, phrases, generator, cycle_s))).T
    return minimum_jerk_through(times_s, at_s, volumes)


def _knots(
    during: Interval, phrases: Sequence[Interval], generator: np.random.Generator, usual_s: float
) -> Iterator[tuple[float, float]]:
    """The times of empty and full lungs with their volumes, from before the first time to after the last."""
    pauses = list(_pauses(phrases))
    now_s = during.start_s - usual_s * float(generator.uniform(1.0, 2.0))
    while now_s <= during.end_s:
        cycle_s, depth = usual_s * float(generator.uniform(0.85, 1.15)), QUIET_DEPTH
        inhaled_s = now_s + INHALING_SHARE * cycle_s
        for pause in pauses:
            if pause.start_s <= now_s < pause.end_s:
                inhaled_s, depth = now_s + float(np.clip(pause.end_s - now_s, *QUICK_BREATH_S)), 1.0
        yield now_s, 0.0
        yield inhaled_s, depth * float(generator.uniform(0.85, 1.0))
        due_s = now_s + cycle_s
        due_s = next((phrase.end_s for phrase in phrases if phrase.start_s <= due_s < phrase.end_s), due_s)
        soon_s = inhaled_s + SHORTEST_BETWEEN_S
        now_s = min([max(due_s, soon_s), *(pause.start_s for pause in pauses if pause.start_s >= soon_s)])
    yield now_s, 0.0


def _pauses(phrases: Sequence[Interval]) -> Iterator[Interval]:
    """The intervals in which to inhale: before the first phrase and between phrases."""
    if phrases:
        yield Interval(phrases[0].start_s - QUICK_BREATH_S[1], phrases[0].start_s)
    for phrase, following in pairwise(phrases):
        if following.start_s - phrase.end_s >= SHORTEST_PAUSE_S:
            yield Interval(phrase.end_s, following.start_s)
