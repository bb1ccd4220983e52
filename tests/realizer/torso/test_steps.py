"""In long takes the feet are moved, one after the other, and planted in between; in short ones they stay."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.movements import BODY
from understudy.model import FloatArray, Interval, Schedule
from understudy.realizer.body.limits import violations
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.torso.balance import feet_of, standing
from understudy.realizer.torso.idle import idle_motion
from understudy.realizer.torso.steps import LIFT_M, steps_of, with_steps

PHRASES = tuple(Interval(start_s, start_s + 3.0) for start_s in np.arange(1.0, 57.0, 4.0))
LONG = Schedule((), 60.0, phrases=PHRASES)
TIMES_S: FloatArray = np.arange(0, 60, 1 / 60)


def feet_m(planned: Schedule, seed: int = 1) -> tuple[FloatArray, FloatArray]:
    """The ankles (2, T, 3), and the rotations of the body."""
    body, _told = with_steps(BODY, idle_motion(BODY, TIMES_S, planned, seed=seed), planned, seed=seed)
    return feet_of(BODY, body.rotations, body.hips_m).ankles_m, body.rotations


@pytest.mark.parametrize("seed", range(3))
def test_feet_are_moved_at_least_three_times_a_minute_and_planted_otherwise(seed: int) -> None:
    places_m, rotations = feet_m(LONG, seed)
    moving = np.linalg.norm(np.diff(places_m, axis=1), axis=-1) * 60 > 0.002
    begun = [np.count_nonzero(foot[1:] & ~foot[:-1]) for foot in moving]
    assert min(begun) >= 3
    assert not (moving[0] & moving[1]).any()
    ground_m = [foot.ankle_m[1] for foot in standing(BODY)]
    for place_m, level_m, moved in zip(places_m, ground_m, moving, strict=True):
        assert place_m[:, 1].min() > level_m - 1e-6
        assert place_m[:-1][~moved, 1].max() < level_m + 1e-4
        assert place_m[:, 1].max() == pytest.approx(level_m + LIFT_M, abs=0.004)
        assert np.abs(place_m[:, 0] - place_m[0, 0]).max() < 0.1
    assert violations(BODY, rotations).max() == 0
    assert angle_between(rotations[1:], rotations[:-1]).max() * 60 < 8


def test_a_step_begins_before_a_phrase_and_the_hips_are_over_the_foot_that_stands() -> None:
    steps = steps_of(LONG, seed=1)
    starts_s = [phrase.start_s for phrase in PHRASES]
    assert all(any(0 < start_s - step.start_s < 0.5 for start_s in starts_s) for step in steps)
    body, (told,) = with_steps(BODY, idle_motion(BODY, TIMES_S, LONG, seed=1), LONG, seed=1)
    assert told.action == "stepped"
    assert f"{steps[0].start_s:.2f}" in told.reason
    feet = feet_of(BODY, body.rotations, body.hips_m).ankles_m
    for step in steps:
        middle = np.searchsorted(TIMES_S, np.mean(step.swing_s(step.first)))
        stands_m, lifted_m = feet[1 - step.first, middle, 0], feet[step.first, middle, 0]
        assert abs(body.hips_m[middle, 0] - stands_m) < abs(body.hips_m[middle, 0] - lifted_m) / 2


@pytest.mark.parametrize("planned", [Schedule((), 20.0, phrases=PHRASES), replace(LONG, stillness=0.6)])
def test_nobody_steps_in_a_short_or_a_still_take(planned: Schedule) -> None:
    body = idle_motion(BODY, TIMES_S[: 60 * 20], planned, seed=1)
    assert with_steps(BODY, body, planned, seed=1) == (body, ())


def test_the_feet_of_a_body_are_found() -> None:
    body = idle_motion(BODY, TIMES_S[:60], LONG, seed=1)
    found = feet_of(BODY, body.rotations, body.hips_m)
    for number, foot in enumerate(standing(BODY)):
        assert np.allclose(found.ankles_m[number], foot.ankle_m, atol=1e-6)
        assert np.allclose(found.yaws[number], foot.yaw, atol=1e-6)
    whole = forward(BODY, body.rotations, body.hips_m)[0]
    assert np.allclose(found.ankles_m[0], whole[:, BODY.index["leftFoot"]])
