"""Inverse kinematics of the arm: bones keep their length, wrists go where they are sent, elbows hang or swing."""

import numpy as np

from understudy.model import FloatArray
from understudy.realizer.arms.arm_reach import (
    ELBOW_FLEXION_DEG,
    ArmBones,
    collarbone_for,
    reach,
    reach_by_elbow,
    shoulder_of,
    towards_elbow,
)
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import angle_between, multiply, rotate

BONES = ArmBones.of(Skeleton.standing())
AHEAD: FloatArray = np.array([0.20, 0.32, 0.40])
ANYWHERE: FloatArray = np.random.default_rng(0).uniform((-0.3, -0.2, 0.1), (0.6, 0.7, 0.5), (300, 3))
X: FloatArray = np.array([1.0, 0.0, 0.0])


def test_bones_keep_their_lengths_and_the_elbow_its_range() -> None:
    arms = reach(BONES, ANYWHERE, swivel_rad=np.zeros(300))
    shoulder_m = BONES.root_m + rotate(arms.collarbone, BONES.collarbone_m)
    assert np.allclose(np.linalg.norm(arms.elbow_m - shoulder_m, axis=-1), BONES.upper_m)
    assert np.allclose(np.linalg.norm(arms.wrist_m - arms.elbow_m, axis=-1), BONES.lower_m)
    flexion_deg = np.degrees(2 * np.arccos(np.clip(arms.elbow[:, 3], -1, 1)))
    assert flexion_deg.min() > ELBOW_FLEXION_DEG[0] - 1e-6
    assert flexion_deg.max() < ELBOW_FLEXION_DEG[1] + 1e-6


def test_what_is_within_reach_is_reached_exactly_and_what_is_not_is_pulled_in() -> None:
    arms = reach(BONES, ANYWHERE, swivel_rad=np.zeros(300))
    off_m = np.linalg.norm(arms.wrist_m - ANYWHERE, axis=-1)
    shoulder_m = BONES.root_m + rotate(arms.collarbone, BONES.collarbone_m)
    distance_m = np.linalg.norm(ANYWHERE - shoulder_m, axis=-1)
    easy = (distance_m > 0.24) & (distance_m < 0.49)
    assert np.mean(off_m[easy] < 1e-6) > 0.9
    assert np.all(off_m[distance_m > 0.54] > 0.01)


def test_reaching_out_is_smooth_where_the_arm_gets_straight() -> None:
    way = AHEAD / np.linalg.norm(AHEAD) * np.linspace(0.3, 1.0, 200)[:, None]
    arms = reach(BONES, way, swivel_rad=np.zeros(200))
    turned = angle_between(arms.upper_arm[1:], arms.upper_arm[:-1])
    assert np.abs(np.diff(turned)).max() < 0.01


def test_the_elbow_swings_outwards_and_up_by_its_swivel() -> None:
    arms = reach(BONES, np.tile(AHEAD, (3, 1)), swivel_rad=np.radians([0.0, 30.0, 60.0]))
    assert np.allclose(arms.wrist_m, arms.wrist_m[0])
    assert np.all(np.diff(arms.elbow_m[:, 0]) > 0.02)
    assert np.all(np.diff(arms.elbow_m[:, 1]) > 0.01)
    assert arms.elbow_m[0, 1] < BONES.shoulder_m[1] - 0.05


def test_collarbones_rise_with_high_hands_and_come_forward_with_far_ones() -> None:
    low, high, far = (
        rotate(collarbone_for(BONES, np.array(at)), X) for at in ((0.2, 0.0, 0.2), (0.2, 0.8, 0.2), AHEAD)
    )
    assert high[1] > low[1] + 0.2
    assert far[2] > low[2] + 0.05


def test_an_arm_solved_by_its_own_elbow_stays_as_it_is() -> None:
    arms = reach(BONES, ANYWHERE, swivel_rad=np.random.default_rng(1).uniform(-0.5, 0.8, 300))
    elbow = towards_elbow(multiply(arms.collarbone, arms.upper_arm), arms.elbow, BONES)
    again = reach_by_elbow(BONES, arms.collarbone, arms.wrist_m - shoulder_of(BONES, arms.collarbone), elbow)
    assert np.all(angle_between(arms.upper_arm, again.upper_arm) < 1e-5)
    assert np.all(angle_between(arms.elbow, again.elbow) < 1e-5)
