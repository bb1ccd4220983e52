"""Key poses of clips on a standing body."""

from pathlib import Path

import numpy as np

from tests.support.motion.gesture_files import gesture, read_one
from understudy.model import FloatArray, Hand, Level
from understudy.realizer.arms.posing import wrist_of
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.skeleton import Skeleton, arm_joints
from understudy.realizer.gestures.gesture import FrameType
from understudy.realizer.gestures.gesture_space import sector_m
from understudy.realizer.gestures.library import clip
from understudy.realizer.pictures.gesture_sheet import REST, key_poses

SKELETON = Skeleton.standing()


def arm(rotations: FloatArray, side: Hand) -> FloatArray:
    return rotations[SKELETON.chain(*arm_joints(side))]


def test_wrists_are_where_the_keys_put_them(tmp_path: Path) -> None:
    """Both frames of the trial are in easy reach, seen from the own side of either hand."""
    definition = read_one(tmp_path, gesture(last="FRAMETYPE stroke_end\n  ARM XC YUpperC ZNear"))
    for side in (Hand.LEFT, Hand.RIGHT):
        poses = key_poses(SKELETON, clip(definition, Level.MEDIUM, side, "TRIAL"))
        for pose, frame in zip(poses, definition.frames, strict=True):
            assert frame.leading.place is not None
            place_m = wrist_of(SKELETON, side, arm(pose.rotations, side))
            assert np.linalg.norm(place_m - sector_m(frame.leading.place)) < 0.01


def test_an_arm_that_takes_no_part_hangs(tmp_path: Path) -> None:
    poses = key_poses(SKELETON, clip(read_one(tmp_path, gesture()), Level.MEDIUM, Hand.RIGHT, "TRIAL"))
    hanging = rest_pose(SKELETON, Hand.LEFT, REST).rotations
    for pose in poses:
        alike = np.abs(np.sum(arm(pose.rotations, Hand.LEFT) * hanging, axis=-1))
        assert np.allclose(alike, 1.0)


def test_a_key_that_says_nothing_is_no_pose(tmp_path: Path) -> None:
    text = gesture() + "STARTFRAME 1\nFRAMETYPE end\nENDFRAME\n"
    poses = key_poses(SKELETON, clip(read_one(tmp_path, text), Level.LOW, Hand.BOTH, "TRIAL"))
    assert [pose.key.type for pose in poses] == [FrameType.STROKE_START, FrameType.STROKE_END]
