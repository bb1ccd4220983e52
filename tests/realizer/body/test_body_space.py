"""Places around one body are as far from the flesh of another."""

from itertools import product

import numpy as np
import pytest

from understudy.model import FloatArray, Hand
from understudy.model.figure import Physique, Sex
from understudy.realizer.arms.rest_poses import RESTS, rest_pose
from understudy.realizer.body.body_space import on_body_m
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.body.proportions import Proportions
from understudy.realizer.body.skeleton import Skeleton, arm_joints
from understudy.realizer.geometry.rotations import IDENTITY

BELLY_M, HIP_M, BEHIND_M = np.array([[0.0, 0.13, 0.2], [0.25, 0.0, 0.0], [0.05, 0.0, -0.2]])


def body(**said: float) -> Skeleton:
    return Skeleton.standing(Proportions(Physique(**said)))  # type: ignore[arg-type]


def test_around_the_average_body_nothing_moves() -> None:
    assert on_body_m(Skeleton.standing(), BELLY_M) is BELLY_M


def test_around_a_taller_body_all_is_farther_out_in_proportion() -> None:
    tall = body(height_m=2.0)
    assert on_body_m(tall, HIP_M) == pytest.approx(tall.proportions.scale * HIP_M)


def test_a_broad_body_keeps_hands_off_before_beside_and_behind_it() -> None:
    broad = body(build=1.4)
    assert on_body_m(broad, BELLY_M)[2] > BELLY_M[2] + 0.03
    assert on_body_m(broad, HIP_M)[0] > HIP_M[0] + 0.03
    assert on_body_m(broad, BEHIND_M)[2] < BEHIND_M[2] - 0.03
    middle: FloatArray = np.array([0.0, 0.3, 0.0])
    assert on_body_m(broad, middle) == pytest.approx(middle), "the middle of the body stays where it is"


@pytest.mark.parametrize("build", [0.9, 1.25])
def test_hands_rest_outside_bodies_of_every_kind(build: float) -> None:
    """Rests keep 15 mm for idle noise on the average body; a little of it may go on others."""
    for sex, height_m, name in product(Sex, (1.5, 1.95), RESTS):
        other = Skeleton.standing(Proportions(Physique(sex, 40, height_m, build)))
        rotations = np.tile(IDENTITY, (1, len(other.names), 1))
        for side in (Hand.LEFT, Hand.RIGHT):
            rotations[0, other.chain(*arm_joints(side))] = rest_pose(other, side, name).rotations
        assert penetrations_m(other, rotations, other.offsets_m[:1])[0] < 0.01, (sex, height_m, name)
