"""Statics: floor and joints together bear a pose, whatever it is."""

import numpy as np
import pytest

from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.physics.course import course_of
from understudy.realizer.physics.physical_body import physical_body
from understudy.realizer.physics.standing import standing_torques

from .bodies import still_body


@pytest.mark.parametrize("leaning_m", [0.0, 0.03])
def test_nothing_is_left_over_that_moves_the_hips(leaning_m: float) -> None:
    skeleton = Skeleton.standing()
    physical = physical_body(skeleton)
    positions = course_of(physical, skeleton, still_body(skeleton, leaning_m=leaning_m)).positions[:1]
    torques = standing_torques(physical, positions)[0]
    np.testing.assert_allclose(torques[:6], 0, atol=1e-6)
    assert np.abs(torques[6:]).max() > 1
