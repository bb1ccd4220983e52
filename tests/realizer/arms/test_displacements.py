"""Displacements are blended in and out, and arms reach where they are displaced to."""

import numpy as np
import pytest

from tests.realizer.arms.test_collisions import BEFORE, BODY, moving
from understudy.model import FloatArray, Hand
from understudy.realizer.arms.displacements import Displacement, PosedArms, around, frames_in, stretches, taper
from understudy.realizer.body.contacts import PosedBody

SWELL = 6


def pushed(frames: int, at: int, by_m: float) -> FloatArray:
    push_m = np.zeros((frames, 3))
    push_m[at] = [by_m, 0.0, 0.0]
    return push_m


def test_weights_rise_from_the_ends_beyond_which_nothing_is_moved() -> None:
    weights = taper(30, SWELL, (True, False))[:, 0]
    assert weights[0] == 0
    assert np.all(np.diff(weights[: SWELL + 1]) > 0)
    assert weights[SWELL:] == pytest.approx(1.0)


def test_a_displacement_reaches_what_is_asked_for_and_comes_and_goes() -> None:
    push = Displacement.of_wrists(np.stack((pushed(60, 30, 0.05), pushed(60, 30, 0.0))))
    by_m = push.swelling(SWELL, np.ones((60, 1))).by_m
    size_m = by_m[0, 0, :, 0]
    assert size_m[30] == pytest.approx(0.05, rel=0.01)
    assert size_m[30 - 3 * SWELL] == size_m[30 + 3 * SWELL] == 0
    assert np.abs(np.diff(size_m)).max() < 2 * 0.05 / SWELL
    assert not by_m[0, 1].any()
    assert not by_m[1].any()


def test_displacements_that_add_up_stay_within_reach() -> None:
    far = Displacement.of_wrists(np.stack((pushed(1, 0, 0.2), pushed(1, 0, 0.2))))
    assert far.and_then(far).by_m[1, 0, 0] == pytest.approx([0.22, 0.0, 0.0])


def test_a_wrist_goes_where_it_is_displaced_to_and_the_hand_keeps_its_orientation() -> None:
    body = moving((Hand.RIGHT, BEFORE))
    posed = PosedBody.of(BODY, body.rotations, body.hips_m)
    push_m = np.zeros((2, len(body.times_s), 3))
    push_m[1, 80] = [-0.03, 0.02, 0.0]
    rotations = body.rotations.copy()
    BODY.arms(rotations)[:, :, 1:4] = PosedArms.of(BODY, posed).displaced(Displacement.of_wrists(push_m))
    after, wrist = PosedBody.of(BODY, rotations, body.hips_m), BODY.index["rightHand"]
    assert after.positions_m[80, wrist] - posed.positions_m[80, wrist] == pytest.approx(push_m[1, 80], abs=1e-6)
    assert after.orientations[80, wrist] == pytest.approx(posed.orientations[80, wrist], abs=1e-6)
    assert np.array_equal(rotations[:80], body.rotations[:80])


def test_stretches_are_the_runs_of_true_values_at_the_ends_too() -> None:
    inside = np.array([True, False, False, True, True, False, True])
    assert stretches(inside).tolist() == [[0, 1], [3, 5], [6, 7]]
    assert stretches(np.zeros(3, dtype=bool)).tolist() == []


def test_around_has_neighbours_on_both_sides() -> None:
    assert around(np.array([False, False, False, True, False]), 1).tolist() == [False, False, True, True, True]


@pytest.mark.parametrize(("rate_hz", "time_s", "frames"), [(60, 0.1, 6), (30, 0.1, 3), (30, 0.001, 1)])
def test_a_time_has_frames_by_the_rate_and_at_least_one(rate_hz: int, time_s: float, frames: int) -> None:
    assert frames_in(np.arange(90) / rate_hz, time_s) == frames
