from math import pi, sqrt

import mujoco
import numpy as np
import pytest

from understudy.model.figure import Physique, Sex
from understudy.realizer.body.masses import mass_kg
from understudy.realizer.body.proportions import Proportions
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.physics.course import course_of
from understudy.realizer.physics.physical_body import SERVOS, inertia_beyond_kg_m2, physical_body, servo_of

from .bodies import still_body

BODIES = [Physique(), Physique(Sex.FEMALE, 80, 1.5, 1.3), Physique(Sex.MALE, 25, 2.05, 0.8)]


@pytest.mark.parametrize("physique", BODIES, ids=str)
def test_a_body_weighs_what_it_weighs_and_stands_on_the_floor(physique: Physique) -> None:
    skeleton = Skeleton.standing(Proportions(physique))
    physical = physical_body(skeleton)
    assert physical.weight_n == pytest.approx(9.81 * mass_kg(skeleton), rel=1e-3)
    state = mujoco.MjData(physical.model)
    state.qpos[:] = course_of(physical, skeleton, still_body(skeleton)).positions[0]
    state.qpos[1] -= 0.001  # so that it is not by rounding alone whether they touch
    mujoco.mj_forward(physical.model, state)
    assert state.ncon == 8, "four corners of each sole"
    np.testing.assert_allclose(state.contact.dist, -0.001, atol=1e-6)


def test_a_joint_is_where_the_skeleton_has_it() -> None:
    skeleton = Skeleton.standing()
    physical = physical_body(skeleton)
    for joint, row in zip(physical.joints, physical.rows, strict=True):
        if joint != "hips":
            np.testing.assert_allclose(physical.model.body(joint).pos, skeleton.offsets_m[row], atol=1e-9)


def test_a_servo_swings_at_its_frequency() -> None:
    skeleton = Skeleton.standing()
    stiffness, damping = servo_of(skeleton, "leftHand")
    inertia, servo = inertia_beyond_kg_m2(skeleton, "leftHand"), SERVOS["Hand"]
    assert sqrt(stiffness / inertia) / (2 * pi) == pytest.approx(servo.frequency_hz)
    assert damping / (2 * sqrt(stiffness * inertia)) == pytest.approx(servo.damping)


def test_what_is_nearer_to_the_trunk_carries_more() -> None:
    skeleton = Skeleton.standing()
    carried = [inertia_beyond_kg_m2(skeleton, f"left{part}") for part in ("Hand", "LowerArm", "UpperArm", "Shoulder")]
    assert carried == sorted(carried)
    assert inertia_beyond_kg_m2(skeleton, "spine") > 2 * carried[-1], "both arms, the trunk and the head"
