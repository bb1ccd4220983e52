"""Arms and heads that would be too fast."""

import numpy as np

from understudy.model import FloatArray, Hand
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.dynamics.calming import calm, calm_arms, calm_fingers, calm_head
from understudy.realizer.geometry.rotations import IDENTITY, angle_between, from_axis_angle, multiply

RATE_HZ = 60
FASTEST_M_S = 3.0


def swinging(length_s: float) -> tuple[Skeleton, FloatArray, FloatArray]:
    """An arm that swings by a right angle within a fifth of a second, from 1 s on."""
    skeleton, times_s = Skeleton.standing(), np.arange(0.0, length_s, 1 / RATE_HZ)
    swings = np.radians(90) * np.clip((times_s - 1.0) / 0.2, 0.0, 1.0)
    hanging = np.stack([rest_pose(skeleton, side, "at_side").rotations for side in (Hand.LEFT, Hand.RIGHT)])
    arms = np.tile(hanging, (len(times_s), 1, 1, 1))
    arms[:, 1, 1] = multiply(from_axis_angle((1.0, 0.0, 0.0), -swings), arms[:, 1, 1])
    return skeleton, times_s, arms


def test_no_wrist_is_faster_than_hands_are() -> None:
    """An arm that swings by a right angle in a fifth of a second is calmed; its trunk will add its own speed."""
    skeleton, times_s, arms = swinging(2.0)
    before = arms[:, 1].copy()
    wrists_m = calm(skeleton, arms, times_s)
    assert np.linalg.norm(np.diff(wrists_m, axis=1), axis=2).max() * RATE_HZ < FASTEST_M_S
    assert np.allclose(arms[[0, -1], 1], before[[0, -1]])
    assert angle_between(arms[:, 1], before)[abs(times_s - 1.05) > 0.5].max() < 1e-6


def test_what_is_far_from_a_fast_move_neither_changes_nor_changes_it() -> None:
    skeleton, times_s, arms = swinging(2.5)
    wrists_m = calm(skeleton, arms, times_s)
    skeleton, longer_s, longer = swinging(12.0)
    before = longer[:, 1].copy()
    assert np.allclose(calm(skeleton, longer, longer_s)[:, : len(times_s)], wrists_m, atol=1e-9)
    assert np.array_equal(longer[len(times_s) :, 1], before[len(times_s) :])


def test_an_elbow_that_turns_too_fast_is_calmed_though_its_wrist_stays() -> None:
    """A quarter turn of the forearm about itself in a twentieth of a second."""
    skeleton, times_s, arms = swinging(2.0)
    arms[:, 1] = arms[0, 1]
    turns = np.radians(90) * np.clip((times_s - 1.0) / 0.05, 0.0, 1.0)
    arms[:, 1, 2] = multiply(arms[:, 1, 2], from_axis_angle((1.0, 0.0, 0.0), turns))
    assert angle_between(arms[1:, 1, 2], arms[:-1, 1, 2]).max() * RATE_HZ > 20
    calm(skeleton, arms, times_s)
    assert angle_between(arms[1:, 1, 2], arms[:-1, 1, 2]).max() * RATE_HZ < 18
    assert angle_between(arms[-1, 1, 2], arms[0, 1, 2]) > np.radians(80)


def carried(length_s: float) -> tuple[Skeleton, BodyMotion]:
    """A body whose stretched right arm swings from the side to the front in .3 s, as its hips turn with it."""
    skeleton, times_s = Skeleton.standing(), np.arange(0.0, length_s, 1 / RATE_HZ)
    share = np.clip((times_s - 1.0) / 0.3, 0.0, 1.0)
    rotations = np.tile(IDENTITY, (len(times_s), len(skeleton.names), 1))
    rotations[:, 0] = from_axis_angle((0.0, 1.0, 0.0), np.radians(20) * share)
    rotations[:, skeleton.index["rightUpperArm"]] = from_axis_angle((0.0, 1.0, 0.0), np.radians(80) * share)
    return skeleton, BodyMotion(times_s, rotations, np.tile(skeleton.offsets_m[0], (len(times_s), 1)))


def wrist_speeds_m_s(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    at_m, _turned = forward(skeleton, body.rotations, body.hips_m)
    wrists_m = at_m[:, skeleton.chain("leftHand", "rightHand")]
    return np.asarray(np.linalg.norm(np.diff(wrists_m, axis=0), axis=2) * RATE_HZ)


def test_what_the_trunk_adds_to_the_speed_of_a_wrist_is_calmed_in_the_world() -> None:
    skeleton, body = carried(2.0)
    by_itself = skeleton.arms(body.rotations).copy()
    wrists_m = calm(skeleton, by_itself, body.times_s)
    skeleton.arms(body.rotations)[:, 1] = by_itself[:, 1]
    assert np.linalg.norm(np.diff(wrists_m, axis=1), axis=2).max() * RATE_HZ < FASTEST_M_S
    assert wrist_speeds_m_s(skeleton, body).max() > FASTEST_M_S
    calmer = body.copy()
    assert calm_arms(skeleton, calmer)
    assert wrist_speeds_m_s(skeleton, calmer).max() < FASTEST_M_S
    assert np.allclose(calmer.rotations[[0, -1]], body.rotations[[0, -1]])
    others = [joint for joint in range(len(skeleton.names)) if not skeleton.names[joint].startswith("right")]
    assert np.array_equal(calmer.rotations[:, others], body.rotations[:, others])


def test_a_hand_that_turns_too_fast_is_calmed_though_its_wrist_stays() -> None:
    skeleton, body = carried(2.0)
    body.rotations[:] = body.rotations[0]
    hand = skeleton.index["rightHand"]
    turns = np.radians(40) * np.clip((body.times_s - 1.0) / 0.03, 0.0, 1.0)
    body.rotations[:, hand] = multiply(from_axis_angle((0.0, 0.0, 1.0), turns), body.rotations[:, hand])
    assert angle_between(body.rotations[1:, hand], body.rotations[:-1, hand]).max() * RATE_HZ > 20
    assert calm_arms(skeleton, body)
    calmer = body.rotations
    assert angle_between(calmer[1:, hand], calmer[:-1, hand]).max() * RATE_HZ < 20
    assert angle_between(calmer[-1, hand], calmer[0, hand]) > np.radians(38)


def test_a_body_that_is_calm_is_left_alone() -> None:
    skeleton, body = carried(2.0)
    body.rotations[:] = body.rotations[0]
    calm_already = body.rotations.copy()
    assert not calm_arms(skeleton, body)
    assert np.array_equal(body.rotations, calm_already)


def test_fingers_that_close_too_fast_are_calmed_and_nothing_else() -> None:
    skeleton, body = carried(2.0)
    finger = skeleton.index["rightMiddleIntermediate"]
    bends = np.radians(80) * np.clip((body.times_s - 1.0) / 0.06, 0.0, 1.0)
    body.rotations[:, finger] = from_axis_angle((0.0, 0.0, 1.0), bends)
    calmer = body.copy()
    assert angle_between(body.rotations[1:, finger], body.rotations[:-1, finger]).max() * RATE_HZ > 20
    assert calm_fingers(skeleton, calmer)
    assert angle_between(calmer.rotations[1:, finger], calmer.rotations[:-1, finger]).max() * RATE_HZ < 20
    assert angle_between(calmer.rotations[-1, finger], calmer.rotations[0, finger]) > np.radians(79)
    others = np.arange(len(skeleton.names)) != finger
    assert np.allclose(calmer.rotations[:, others], body.rotations[:, others])
    assert not calm_fingers(skeleton, calmer)


def turning(head_deg_s: float, trunk_deg_s: float) -> tuple[Skeleton, BodyMotion]:
    """A body that turns its head over its chest and its hips, to the same side, from .5 s to .8 s."""
    skeleton, times_s = Skeleton.standing(), np.arange(0.0, 2.0, 1 / RATE_HZ)
    rotations = np.tile(IDENTITY, (len(times_s), len(skeleton.names), 1))
    for joint, speed in (("head", head_deg_s), ("hips", trunk_deg_s)):
        turned = np.radians(speed) * np.clip(times_s - 0.5, 0.0, 0.3)
        rotations[:, skeleton.index[joint]] = from_axis_angle((0.0, 1.0, 0.0), turned)
    return skeleton, BodyMotion(times_s, rotations, np.zeros((len(times_s), 3)))


def head_in_the_world(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    _places_m, turned = forward(skeleton, body.rotations, body.hips_m)
    return np.asarray(turned[:, skeleton.index["head"]])


def test_a_head_that_is_slow_enough_with_its_trunk_is_as_it_was() -> None:
    skeleton, body = turning(140.0, 100.0)
    slow = body.rotations.copy()
    assert not calm_head(skeleton, body)
    assert np.array_equal(body.rotations, slow)


def test_a_head_that_the_trunk_makes_too_fast_comes_later_and_arrives() -> None:
    skeleton, body = turning(180.0, 120.0)
    calmer = body.copy()
    assert calm_head(skeleton, calmer)
    before, after = (head_in_the_world(skeleton, each) for each in (body, calmer))
    speeds = np.degrees(angle_between(after[1:], after[:-1])) * RATE_HZ
    assert np.degrees(angle_between(before[1:], before[:-1])).max() * RATE_HZ > 290
    assert 240 < speeds.max() < 250
    assert angle_between(after[-1], before[-1]) < 1e-6


def test_an_arm_that_is_fast_as_the_take_ends_is_calmed_there() -> None:
    skeleton, times_s, arms = swinging(1.2)
    before = arms[:, 1].copy()
    wrists_m = calm(skeleton, arms, times_s)
    assert np.linalg.norm(np.diff(wrists_m, axis=1), axis=2).max() * RATE_HZ < FASTEST_M_S
    assert np.allclose(arms[0, 1], before[0])
