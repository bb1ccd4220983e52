"""What servos are asked for: places in every step, and the torques that bear a pose."""

import numpy as np
import pytest

from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.physics.course import between, course_of, rotations_of, standing_torques
from understudy.realizer.physics.physical_body import STEP_S, physical_body

from .bodies import RATE_HZ, still_body, striking_body


def test_a_curve_passes_through_its_frames_and_keeps_straight_lines() -> None:
    values = np.array([[0.0, 1.0], [1.0, 0.0], [2.0, 5.0], [3.0, 2.0]])
    curve = between(values, 8)
    assert len(curve) == 25
    np.testing.assert_allclose(curve[::8], values, atol=1e-12)
    np.testing.assert_allclose(curve[8:17, 0], np.linspace(1, 2, 9), atol=1e-12)


@pytest.mark.parametrize("rate_hz", [30, 60])
def test_a_frame_is_a_whole_number_of_steps(rate_hz: int) -> None:
    assert 1 / rate_hz / STEP_S == pytest.approx(round(1 / rate_hz / STEP_S))


def test_positions_are_the_rotations_they_were_made_from() -> None:
    skeleton, body = Skeleton.standing(), still_body(Skeleton.standing())
    physical = physical_body(skeleton)
    back = rotations_of(physical, course_of(physical, skeleton, body).positions[:1])
    assert angle_between(back, body.rotations[:1, physical.rows]).max() < 1e-6


def test_a_body_at_rest_is_asked_for_no_torque_that_changes() -> None:
    skeleton = Skeleton.standing()
    physical = physical_body(skeleton)
    torques = course_of(physical, skeleton, still_body(skeleton)).torques
    np.testing.assert_allclose(np.ptp(torques, axis=0), 0, atol=1e-9)


def test_arms_are_asked_early_and_the_trunk_is_not() -> None:
    skeleton, body = Skeleton.standing(), striking_body(Skeleton.standing())
    physical = physical_body(skeleton)
    course = course_of(physical, skeleton, body)
    asked = rotations_of(physical, course.positions[:: course.steps_per_frame])
    elbow = physical.joints.index("leftLowerArm")
    earlier = round(0.033 * RATE_HZ)
    moved = body.rotations[:, skeleton.index["leftLowerArm"]]
    assert np.degrees(angle_between(asked[:-earlier, elbow], moved[earlier:]).max()) < 1.5


@pytest.mark.parametrize("leaning_m", [0.0, 0.03])
def test_nothing_is_left_over_that_moves_the_hips(leaning_m: float) -> None:
    skeleton = Skeleton.standing()
    physical = physical_body(skeleton)
    positions = course_of(physical, skeleton, still_body(skeleton, leaning_m=leaning_m)).positions[:1]
    torques = standing_torques(physical, positions)[0]
    np.testing.assert_allclose(torques[:6], 0, atol=1e-6)
    assert np.abs(torques[6:]).max() > 1
