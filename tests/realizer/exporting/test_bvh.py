"""BVH as other tools read it: read back here with scipy's rotations, not with ours."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.support.motion.hand_made_motion import BODY, X, Y, Z, still, turned, waving
from understudy.model import FloatArray
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.exporting.bvh import to_bvh
from understudy.realizer.exporting.retargeting import load_rigs
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle, multiply

RIGS = load_rigs(Path(__file__).parents[3] / "lexicon" / "retarget", BODY)
MIXAMO = RIGS["mixamo"]


@dataclass
class Read:
    """What a reader makes of a BVH file: joints in file order, and the numbers of each frame."""

    names: list[str] = field(default_factory=list)
    parents: list[int] = field(default_factory=list)
    offsets: list[list[float]] = field(default_factory=list)
    ends: list[list[float]] = field(default_factory=list)
    channels: list[list[str]] = field(default_factory=list)
    frame_time_s: float = 0.0
    rows: FloatArray = field(default_factory=lambda: np.zeros((0, 0)))

    def row(self, joint: str, frame: int = 0) -> list[float]:
        first = sum(len(each) for each in self.channels[: self.names.index(joint)])
        return list(self.rows[frame, first : first + len(self.channels[self.names.index(joint)])])

    def rest_cm(self) -> FloatArray:
        """Where the offsets alone put the joints (J, 3)."""
        places: list[FloatArray] = []
        for parent, offset in zip(self.parents, self.offsets, strict=True):
            places.append(np.array(offset) + (places[parent] if parent >= 0 else 0.0))
        return np.stack(places)

    def positions_cm(self) -> FloatArray:
        """Where the joints are, by matrices (T, J, 3); the root's positions are absolute, as for Blender."""
        places, turns, column = [], [], 0
        for joint, channels in enumerate(self.channels):
            values = self.rows[:, column : column + len(channels)]
            column += len(channels)
            axes = "".join(name[0] for name in channels if name.endswith("rotation"))
            turn = Rotation.from_euler(axes, values[:, -3:], degrees=True)
            if self.parents[joint] < 0:
                places.append(values[:, :3])
                turns.append(turn)
            else:
                above = turns[self.parents[joint]]
                places.append(places[self.parents[joint]] + above.apply(self.offsets[joint]))
                turns.append(above * turn)
        return np.stack(places, axis=1)


def read(content: bytes) -> Read:
    found, in_end = Read(), False
    open_joints: list[int] = []
    lines = content.decode("ascii").split("\n")
    motion = lines.index("MOTION")
    for words in (line.split() for line in lines[:motion]):
        if words[0] in {"ROOT", "JOINT"}:
            found.parents.append(open_joints[-1] if open_joints else -1)
            found.names.append(words[1])
            open_joints.append(len(found.names) - 1)
        elif words[0] == "End":
            in_end = True
        elif words[0] == "OFFSET":
            (found.ends if in_end else found.offsets).append([float(word) for word in words[1:]])
        elif words[0] == "CHANNELS":
            found.channels.append(words[2:])
            assert int(words[1]) == len(words[2:])
        elif words[0] == "}":
            if not in_end:
                open_joints.pop()
            in_end = False
    assert not open_joints
    found.frame_time_s = float(lines[motion + 2].removeprefix("Frame Time: "))
    found.rows = np.array([[float(word) for word in line.split()] for line in lines[motion + 3 : -1]])
    assert len(found.rows) == int(lines[motion + 1].removeprefix("Frames: "))
    return found


def exported(motion: Motion, *, t_pose: bool = False) -> Read:
    return read(to_bvh(motion, BODY, MIXAMO, t_pose=t_pose))


def test_the_root_has_six_channels_and_stands_in_centimetres() -> None:
    found = exported(still(2))
    assert found.names[0] == "Hips"
    assert found.channels[0] == ["Xposition", "Yposition", "Zposition", "Zrotation", "Xrotation", "Yrotation"]
    assert found.row("Hips") == [0, 95, 0, 0, 0, 0]
    assert found.offsets[found.names.index("LeftForeArm")] == [28, 0, 0]


def test_at_rest_the_feet_are_on_the_ground_and_the_hips_at_their_height() -> None:
    found = exported(still(2))
    ours, _turns = forward(BODY, still(1).body.rotations, still(1).body.hips_m)
    order = [list(MIXAMO.names.values()).index(name) for name in found.names]
    assert np.abs(found.rest_cm() / 100 - ours[0, order]).max() < 1e-5
    assert found.rest_cm()[found.names.index("Hips"), 1] == 95
    assert 0 <= found.rest_cm()[:, 1].min() < 5


def test_readers_that_add_the_roots_offset_get_none() -> None:
    found = read(to_bvh(waving(), BODY, MIXAMO, root_at_origin=True))
    assert found.offsets[0] == [0, 0, 0]
    assert np.array_equal(found.rows, exported(waving()).rows)


def test_a_t_pose_may_come_first() -> None:
    with_pose, without = exported(waving(), t_pose=True), exported(waving())
    assert with_pose.row("Hips") == [0, 95, 0, 0, 0, 0]
    assert not with_pose.rows[0, 6:].any()
    assert np.array_equal(with_pose.rows[1:], without.rows)


def test_zero_rotation_is_the_t_pose() -> None:
    found = exported(still(1))
    assert not found.rows[0, 3:].any()


@pytest.mark.parametrize(("axis", "channel"), [(Z, 0), (X, 1), (Y, 2)])
@pytest.mark.parametrize("degrees", [-80.0, 30.0, 89.0])
def test_an_elbow_bent_about_one_axis_moves_that_channel_only(
    axis: tuple[float, float, float], channel: int, degrees: float
) -> None:
    found = exported(turned("leftLowerArm", from_axis_angle(axis, np.array(np.radians(degrees)))))
    expected = [0.0, 0.0, 0.0]
    expected[channel] = degrees
    assert found.row("LeftForeArm") == pytest.approx(expected, abs=1e-3)


def test_an_elbow_at_a_right_angle_about_y_reads_90() -> None:
    found = exported(turned("leftLowerArm", from_axis_angle(Y, np.array(-np.pi / 2))))
    assert found.row("LeftForeArm") == pytest.approx([0, 0, -90], abs=1e-3)


@pytest.mark.parametrize("degrees", [90.0, -90.0])
def test_where_two_axes_fall_together_the_rotation_is_still_the_same(degrees: float) -> None:
    locked = multiply(from_axis_angle(Z, np.array(0.4)), from_axis_angle(X, np.array(np.radians(degrees))))
    found = exported(turned("leftLowerArm", locked))
    read_back = Rotation.from_euler("ZXY", found.row("LeftForeArm"), degrees=True).as_quat()
    assert abs(float(read_back @ locked)) == pytest.approx(1.0, abs=1e-9)


def test_a_reader_of_another_make_puts_every_joint_where_we_have_it() -> None:
    motion = waving()
    found = exported(motion)
    ours, _turns = forward(BODY, motion.body.rotations, motion.body.hips_m)
    order = [list(MIXAMO.names.values()).index(name) for name in found.names]
    assert np.abs(found.positions_cm() / 100 - ours[:, order]).max() < 1e-5


def test_angles_run_on_where_a_joint_turns_past_half_a_turn() -> None:
    spin = from_axis_angle(Z, np.linspace(0, 6, 200))
    found = exported(turned("leftLowerArm", spin, frames=200))
    angles = [found.row("LeftForeArm", frame)[0] for frame in range(200)]
    assert np.abs(np.diff(angles)).max() < 2
    assert angles[-1] == pytest.approx(np.degrees(6), abs=1e-3)


def test_frame_times_have_digits_enough_for_ten_minutes() -> None:
    assert exported(waving(0.1, 60)).frame_time_s * 36_000 == pytest.approx(600, abs=1e-4)


def test_lines_end_plainly_and_no_number_is_minus_zero() -> None:
    motion = turned("head", multiply(IDENTITY, from_axis_angle(X, np.array(-1e-9))))
    content = to_bvh(motion, BODY, MIXAMO)
    assert b"\r" not in content
    assert b"-0.0000 " not in content
    assert content.endswith(b"\n")


def test_other_rigs_only_rename() -> None:
    motion = waving()
    mixamo, unreal = exported(motion), read(to_bvh(motion, BODY, RIGS["unreal"]))
    assert unreal.names[0] == "pelvis"
    assert np.array_equal(mixamo.rows, unreal.rows)
    assert mixamo.offsets == unreal.offsets


def test_the_right_hand_ends_to_the_right() -> None:
    found = exported(still(1))
    assert min(end[0] for end in found.ends) == pytest.approx(-2.0)
    assert max(end[0] for end in found.ends) == pytest.approx(2.0)
