"""The body's parts hang on its joints, are mirrored, and stand within the adult they are made for."""

import numpy as np

from understudy.model import FloatArray, Hand
from understudy.realizer.arms.posing import arm_rotations, pose_arm
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.contacts import (
    BUILD,
    LIMBS,
    PAIRS,
    ArmsOfBody,
    PosedBody,
    contacts,
    penetrations_m,
    radii_m,
)
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton, arm_joints, forward
from understudy.realizer.geometry.rotations import IDENTITY
from understudy.realizer.gestures.gesture import ArmKey, Depth, HeightSector, SectorPlace, Sideways

BODY = Skeleton.standing()


def test_every_part_hangs_on_a_joint_and_has_a_size() -> None:
    assert {capsule.joint for capsule in BUILD} <= set(BODY.names)
    assert all(capsule.radius_m > 0 for capsule in BUILD)


def test_the_build_is_an_adult_of_a_metre_seventy_three_and_its_own_mirror_image() -> None:
    at, _ = forward(BODY, np.tile(IDENTITY, (len(BODY.names), 1)), np.array([0.0, HIPS_HEIGHT_M, 0.0]))
    ends = {
        (capsule.part, capsule.joint.startswith("right")): at[BODY.index[capsule.joint]] + capsule.end_m
        for capsule in BUILD
    }
    top = max(end[1] + capsule.radius_m for capsule, end in zip(BUILD, ends.values(), strict=True))
    assert abs(top - 1.73) < 0.03
    for (part, right), end in ends.items():
        if right:
            assert np.allclose(end * [-1, 1, 1], ends[part, False])


def at(offset_m: tuple[float, float, float]) -> FloatArray:
    """The left hand before the belly, moved by an offset, the right at its side."""
    rotations = np.tile(IDENTITY, (1, len(BODY.names), 1))
    key = ArmKey(SectorPlace(Sideways.CC, HeightSector.LOWER_C, Depth.NEAR, offset_m))
    for side in (Hand.LEFT, Hand.RIGHT):
        pose = rest_pose(BODY, side, "at_side").as_partial()
        pose = pose_arm(BODY, side, key).over(pose) if side is Hand.LEFT else pose
        rotations[0, BODY.chain(*arm_joints(side))] = arm_rotations(pose.parts)
    return rotations


def test_pairs_are_limbs_against_the_body_and_the_other_arm() -> None:
    for limb, other in PAIRS:
        assert BUILD[limb].part in LIMBS
        assert BUILD[limb].joint[:4] != BUILD[other].joint[:4] or BUILD[other].part == "upper leg"
    assert len(radii_m(BODY)) == len(PAIRS) == 4 * 8 + 4


def test_a_hand_before_the_belly_is_clear_and_one_moved_into_it_is_inside_by_as_much() -> None:
    backs_m = (0.0, 0.08, 0.10)
    depths = [float(penetrations_m(BODY, at((0.0, 0.0, -back_m)), np.zeros((1, 3)))[0]) for back_m in backs_m]
    assert depths[0] == 0
    assert 0 < depths[1] < depths[2] < depths[1] + 0.03


def test_the_way_out_of_the_belly_is_forward() -> None:
    found = contacts(BODY, PosedBody.of(BODY, at((0.0, 0.0, -0.10)), np.zeros((1, 3))))
    column = int(found.depth_m[0].argmax())
    assert found.out[0, column, 2] > 0.5
    assert np.isclose(np.linalg.norm(found.out[0, column]), 1.0)
    assert np.all(found.out[0, found.depth_m[0] <= 0] == 0)


def test_arms_moved_alone_are_as_arms_placed_from_the_hips() -> None:
    start = PosedBody.of(BODY, at((0.0, 0.0, 0.0)), np.zeros((1, 3)))
    anew = PosedBody.of(BODY, at((0.1, 0.1, 0.1)), np.zeros((1, 3)))
    collarbones = BODY.chain("leftShoulder", "rightShoulder")
    rotations = anew.rotations.copy()
    rotations[:, collarbones] = start.rotations[:, collarbones]
    whole = contacts(BODY, PosedBody.of(BODY, rotations, np.zeros((1, 3))))
    again = ArmsOfBody.of(BODY, start).contacts(BODY.arms(rotations)[:, :, 1:4])
    assert np.allclose(again.depth_m, whole.depth_m)
    assert np.allclose(again.out, whole.out)
