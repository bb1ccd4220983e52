"""Units laid over a realized motion: hands stay out of the body, whosever body was recorded."""

import numpy as np
import pytest

from understudy.model import Schedule
from understudy.models import load_realizer
from understudy.motion_models.performing import UnitMotion, laid_over
from understudy.realizer.arms.collisions import depths_where_near_m
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import from_rotation_vector, multiply
from understudy.realizer.realizing import Realizer, realize

ARMS = ("leftUpperArm", "leftLowerArm")


@pytest.fixture(scope="module")
def realizer() -> Realizer:
    return load_realizer()


def test_an_arm_that_would_be_inside_the_body_is_moved_out_and_told(realizer: Realizer) -> None:
    """The left arm hangs, and the forearm is bent across the belly, as in a body that has none."""
    skeleton = Skeleton.standing()
    plain = realize(realizer, Schedule((), 3.0), frame_rate_hz=30)
    hanging, inwards = from_rotation_vector(np.radians([[0.0, 0.0, -80.0], [70.0, 0.0, 0.0]]))
    bent = from_rotation_vector(np.radians([0.0, -95.0, 0.0]))
    moved = UnitMotion((), ARMS, np.tile([multiply(hanging, inwards), bent], (120, 1, 1)))
    laid = laid_over(plain, moved, skeleton)
    assert depths_where_near_m(skeleton, laid.body).max() < 0.002
    told = [each.reason for each in laid.decisions if each.action == "moved"]
    assert any(reason.startswith("the left forearm would have been") for reason in told)
