from dataclasses import replace

import numpy as np

from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.physics.course import course_of
from understudy.realizer.physics.physical_body import physical_body
from understudy.realizer.physics.simulation import SimulatedMotion, simulate

from .bodies import still_body


def simulated(skeleton: Skeleton, body: BodyMotion) -> SimulatedMotion:
    physical = physical_body(skeleton)
    return simulate(physical, course_of(physical, skeleton, body))


def test_a_body_that_is_asked_to_stand_stands() -> None:
    skeleton = Skeleton.standing()
    found = simulated(skeleton, still_body(skeleton, leaning_m=0.04))
    assert not found.fell
    assert np.ptp(found.positions[:, :3], axis=0).max() < 0.002
    assert found.slide_m < 0.001


def test_a_body_that_begins_in_the_air_falls() -> None:
    """All of it hangs half a metre over the floor: it lands, and is where nobody asked it to be."""
    skeleton = Skeleton.standing()
    body = still_body(skeleton)
    found = simulated(skeleton, replace(body, hips_m=body.hips_m + np.array([0, 0.5, 0])))
    assert found.fell
    assert len(found.positions) < len(body.times_s)
