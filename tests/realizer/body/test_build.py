"""The body's parts hang on its joints, are mirrored, and stand within the adult they are made for."""

import numpy as np

from understudy.realizer.body.build import BUILD
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton, forward
from understudy.realizer.geometry.rotations import IDENTITY

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
