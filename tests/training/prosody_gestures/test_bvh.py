"""Rotations out of BVH."""

from pathlib import Path

import numpy as np
import pytest

from training.prosody_gestures.bvh import read_rotations
from understudy.errors import InputError

FILE = """HIERARCHY
ROOT Hips
{
    OFFSET 0 0 0
    CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation
    JOINT LeftArm
    {
        OFFSET 1 0 0
        CHANNELS 3 Zrotation Xrotation Yrotation
        End Site
        {
            OFFSET 1 0 0
        }
    }
}
MOTION
Frames: 3
Frame Time: 0.0333333
1 2 3 10 20 30 170 0 45
1 2 3 10 20 30 -170 0 45
1 2 3 10 20 30 -150 0 45
"""


@pytest.fixture
def path(tmp_path: Path) -> Path:
    (tmp_path / "one.bvh").write_text(FILE)
    return tmp_path / "one.bvh"


def test_a_joint_has_its_own_columns_without_jumps(path: Path) -> None:
    """From 170 to -170 degrees is a turn by 20."""
    read = read_rotations(path, ["LeftArm", "Hips"])
    assert read.frame_s == pytest.approx(1 / 30, abs=1e-5)
    assert np.degrees(read.angles[:, 0]) == pytest.approx(np.array([[170, 0, 45], [190, 0, 45], [210, 0, 45]]))
    assert np.degrees(read.angles[0, 1]) == pytest.approx([10, 20, 30])


def test_a_missing_joint_is_named_with_those_there_are(path: Path) -> None:
    with pytest.raises(InputError, match="no rotations of LeftForeArm; it has Hips, LeftArm"):
        read_rotations(path, ["LeftArm", "LeftForeArm"])


@pytest.mark.parametrize("text", ["", "HIERARCHY\n", FILE.replace("Frame Time", "Time")])
def test_what_is_no_bvh_is_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "one.bvh").write_text(text)
    with pytest.raises(InputError, match="bvh"):
        read_rotations(tmp_path / "one.bvh", ["LeftArm"])
