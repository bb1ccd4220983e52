"""Small steps in long takes: at the beginning of a sentence the body steps a little to the side, forward or back.

First the weight shifts to one leg while the other foot is lifted and put down, then vice versa; between steps the feet
stay planted. There are no steps in short takes. Conventions: metres in the world, seconds, radians; the feet's course
is that of `understudy.realizer.torso.balance`.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...model import Channel, FloatArray, Schedule
from ..body.motion import BodyMotion, Decision
from ..body.skeleton import Skeleton
from ..geometry.curves import minimum_jerk, plateau
from .balance import FeetCourse, FootPlacement, hips_height_m, set_legs, standing

SHORTEST_TAKE_S = 20.0
FIRST_S = 5.0
APART_S = (8.0, 15.0)
"""The minimum and maximum time between steps. A step comes with the first sentence or phrase that begins after the
minimum, at the latest after the maximum: four to seven times a minute, both feet each time. Actors step more often,
resting story tellers less often."""
_STILL = 0.5
"""From this stillness on there are no steps."""

AHEAD_S = 0.25
"""The time from lifting the first foot to the start of the voice."""
SWING_S, BETWEEN_S, SETTLING_S = 0.40, 0.12, 0.30
LIFT_M = 0.035
WAY_M = (0.035, 0.075)
"""The range of steps to the side, and back the next time; steps forward and back are two thirds of that."""
_FORWARD = 0.66
_TURN = np.radians(5.0)
_OVER_LEG = 0.75
"""How far the hips shift over the standing foot while the other one is in the air."""


@dataclass(frozen=True, slots=True)
class FootStep:
    """The target of a step relative to the initial position, and the turn of the feet; `first` is the foot that moves
    first, 0 for the left."""

    start_s: float
    to_m: tuple[float, float]
    turn: float
    first: int

    def swing_s(self, foot: int) -> tuple[float, float]:
        """The times at which a foot is lifted and put down."""
        start_s = self.start_s + (0.0 if foot == self.first else SWING_S + BETWEEN_S)
        return start_s, start_s + SWING_S


def with_steps(
    skeleton: Skeleton, body: BodyMotion, schedule: Schedule, *, seed: int
) -> tuple[BodyMotion, tuple[Decision, ...]]:
    """The body, changed in place, with steps, and the decisions about them; deterministic for a seed."""
    steps = steps_of(schedule, seed=seed)
    if not steps:
        return body, ()
    times_s, rotations, hips_m = body.times_s, body.rotations, body.hips_m
    feet = _course(times_s, standing(skeleton), steps)
    before_m = hips_height_m(skeleton, hips_m, rotations[:, 0])
    hips_m[:, [0, 2]] += _carried(times_s, steps)
    hips_m[:, 0] = _over_the_standing_leg(times_s, hips_m[:, 0], feet, steps)
    hips_m[:, 1] += hips_height_m(skeleton, hips_m, rotations[:, 0], feet) - before_m
    set_legs(skeleton, rotations, hips_m, feet)
    told = ", ".join(f"{step.start_s:.2f}" for step in steps)
    return body, (Decision("", "stepped", f"both feet move at {told} s"),)


def steps_of(schedule: Schedule, *, seed: int) -> tuple[FootStep, ...]:
    """The steps of a take; none in a short or a still one."""
    if schedule.duration_s <= SHORTEST_TAKE_S or schedule.stillness >= _STILL:
        return ()
    generator = np.random.default_rng(seed + 10)
    side = float(generator.choice([-1.0, 1.0]))
    steps: list[FootStep] = []
    for start_s in _starts_s(schedule):
        aside_m = side * float(generator.uniform(*WAY_M))
        away_m = _FORWARD * float(generator.choice([-1.0, 1.0])) * abs(aside_m)
        turn = float(generator.uniform(-_TURN, _TURN))
        before_m = steps[-1].to_m[0] if steps else 0.0
        steps.append(FootStep(start_s, (aside_m, away_m), turn, 0 if aside_m > before_m else 1))
        side = -side
    return tuple(steps)


def _starts_s(schedule: Schedule) -> Iterator[float]:
    """The times of steps: with changes of posture, which mark a new topic, otherwise with phrases, otherwise after the
    maximum time."""
    shifts = [each.sync.start for each in schedule.behaviors if each.kept and each.kind is Channel.POSTURE]
    phrases = [each.start_s - AHEAD_S for each in schedule.phrases]
    whole_s = 2 * (SWING_S + BETWEEN_S) + SETTLING_S
    last_s = FIRST_S - APART_S[0]
    while True:
        from_s, until_s = last_s + APART_S[0], last_s + APART_S[1]
        near = [[at_s for at_s in times_s if from_s <= at_s <= until_s] for times_s in (shifts, phrases)]
        last_s = min(near[0] or near[1] or [until_s])
        if last_s + whole_s > schedule.duration_s:
            return
        yield last_s


def _course(
    times_s: FloatArray, planted: tuple[FootPlacement, FootPlacement], steps: tuple[FootStep, ...]
) -> FeetCourse:
    """The course of both feet."""
    ankles_m = np.array([np.tile(foot.ankle_m, (len(times_s), 1)) for foot in planted])
    yaws = np.array([np.full(len(times_s), foot.yaw) for foot in planted])
    for foot in (0, 1):
        from_m, turned = (0.0, 0.0), 0.0
        for step in steps:
            lifted_s, down_s = step.swing_s(foot)
            share = minimum_jerk((times_s - lifted_s) / SWING_S)
            ankles_m[foot, :, 0] += share * (step.to_m[0] - from_m[0])
            ankles_m[foot, :, 2] += share * (step.to_m[1] - from_m[1])
            yaws[foot] += share * (step.turn - turned)
            middle_s = (lifted_s + down_s) / 2
            ankles_m[foot, :, 1] += LIFT_M * plateau(times_s, lifted_s, middle_s, middle_s, down_s)
            from_m, turned = step.to_m, step.turn
    return FeetCourse(ankles_m, yaws)


def _carried(times_s: FloatArray, steps: tuple[FootStep, ...]) -> FloatArray:
    """The path of the hips with the feet (T, 2), sideways and forward."""
    way_m, from_m = np.zeros((len(times_s), 2)), np.zeros(2)
    for step in steps:
        whole_s = 2 * SWING_S + BETWEEN_S + SETTLING_S
        share = minimum_jerk((times_s - step.start_s) / whole_s)
        way_m += share[:, None] * (np.array(step.to_m) - from_m)
        from_m = np.array(step.to_m)
    return way_m


def _over_the_standing_leg(
    times_s: FloatArray, aside_m: FloatArray, feet: FeetCourse, steps: tuple[FootStep, ...]
) -> FloatArray:
    """The lateral position of the hips (T,), over one foot while the other is in the air."""
    for step in steps:
        for foot in (0, 1):
            lifted_s, down_s = step.swing_s(foot)
            ease_s = SETTLING_S if foot == step.first else BETWEEN_S
            share = plateau(times_s, lifted_s - ease_s, lifted_s + 0.1, down_s - 0.1, down_s + SETTLING_S)
            middle_m = feet.ankles_m[:, :, 0].mean(axis=0)
            over_m = middle_m + _OVER_LEG * (feet.ankles_m[1 - foot, :, 0] - middle_m)
            aside_m = aside_m + share * (over_m - aside_m)
    return aside_m
