"""Body parameters, decoded by a reader of their own."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.support.hand_made_motion import BODY, X, Y, Z, turned, waving
from tests.support.mpeg4_reading import COLUMNS, Body, read_parameters, world
from understudy.loading import load_realizer
from understudy.model import Behavior, Channel, Hand, Schedule, SyncPoints
from understudy.motion_formats import BapVersion
from understudy.realizer.body.motion import Motion
from understudy.realizer.exporting.mpeg4.bap import euler_rad, to_bap
from understudy.realizer.exporting.mpeg4.layout import BAPS, FAPS
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.realizing import realize

MOTION = waving(0.5, 30)


@pytest.fixture(scope="module")
def acted() -> Motion:
    """Three gestures of the library with both hands, and a nod."""
    shown = [("NEGATION", Hand.BOTH), ("POINT_UP", Hand.RIGHT), ("PRECISION", Hand.LEFT)]
    gestures = [
        Behavior(
            f"g{number}",
            Channel.GESTURE,
            lexeme,
            SyncPoints(2.0 * number, 2.0 * number + 1.9, stroke=2.0 * number + 0.9, relax=2.0 * number + 1.3),
            0,
            0,
            1.0,
            hand=hand,
        )
        for number, (lexeme, hand) in enumerate(shown)
    ]
    nod = Behavior("h", Channel.HEAD, "NOD", SyncPoints(0.5, 1.8, stroke=1.0), 0, 0, 1.0, amount=0.8)
    return realize(load_realizer(), Schedule((*gestures, nod), 6.0), frame_rate_hz=30)


def test_the_first_line_and_the_mask_are_as_players_read_them() -> None:
    file = read_parameters(to_bap(MOTION, BODY))
    assert (file.version, file.name, file.rate_hz) == ("3.1", "understudy.bap", 30)
    assert file.masks.shape == (len(MOTION.body.times_s), 186)
    assert (file.masks == file.masks[0]).all()
    assert read_parameters(to_bap(MOTION, BODY, BapVersion.GRETA)).version == "2.1"


def test_columns_are_where_mpeg4_has_them() -> None:
    """Numbers as in the standard's table of body animation parameters, counted from 1."""
    assert (len(BAPS), len(FAPS)) == (186, 68)
    told = {"r_elbow_flexion": 39, "l_wrist_twisting": 46, "skullbase_roll": 48, "vt1_roll": 72, "vl5_tilt": 122}
    told |= {
        "l_pinky0_flexion": 123,
        "r_index3_flexion": 170,
        "r_thumb3_flexion": 180,
        "HumanoidRoot_rt_body_tilt": 186,
    }
    assert {name: BAPS.index(name) + 1 for name in told} == told
    faces = {"open_jaw": 3, "close_t_l_eyelid": 19, "pitch_r_eyeball": 26, "head_roll": 50, "pull_r_ear": 68}
    assert {name: FAPS.index(name) + 1 for name in faces} == faces


@pytest.mark.parametrize(
    ("joint", "axis", "angle", "column", "value"),
    [
        ("head", X, 0.4, COLUMNS["skullbase"] + 2, -40_000),
        ("head", Y, 0.4, COLUMNS["skullbase"] + 1, 40_000),
        ("leftLowerArm", Y, -0.4, COLUMNS["elbow"], 40_000),
        ("rightLowerArm", Y, 0.4, COLUMNS["elbow"] + 1, 40_000),
        ("leftIndexIntermediate", Z, -1.7, COLUMNS["index"] + 8, 170_000),
        ("rightIndexIntermediate", Z, 1.7, COLUMNS["index"] + 9, 170_000),
        ("rightUpperLeg", X, -0.4, COLUMNS["hip"] + 1, 40_000),
    ],
)
def test_one_turn_is_one_parameter(
    joint: str, axis: tuple[float, float, float], angle: float, column: int, value: int
) -> None:
    """In the T-pose a forearm bends forward about the vertical, and fingers towards the palm about Z."""
    values = read_parameters(to_bap(turned(joint, from_axis_angle(axis, np.array(angle))), BODY)).values[0]
    assert values[column - 1] == pytest.approx(value, abs=1)


def test_arms_that_hang_have_no_angles() -> None:
    motion = turned("leftUpperArm", from_axis_angle(Z, np.array(-np.pi / 2)))
    values = read_parameters(to_bap(motion, BODY)).values[0]
    assert [values[COLUMNS["shoulder"] - 1 + 2 * place] for place in range(3)] == [0, 0, 0]


def test_our_joints_come_back_within_a_hundredth_of_a_radian(acted: Motion) -> None:
    """A collar bone, which has two angles of three, within half a hundredth; the arm below it is right again."""
    motion = acted
    decoded = Body(read_parameters(to_bap(motion, BODY)))
    ours = {name: Rotation.from_quat(motion.body.rotations[:, place]) for name, place in BODY.index.items()}
    found = decoded.joints()
    for joint, turn in ours.items():
        if not joint.endswith(("Eye", "Shoulder", "UpperArm")):
            assert (turn * found[joint].inv()).magnitude().max() < 1e-4, joint
    pairs = zip(world(ours, BODY.names, BODY.parents), world(found, BODY.names, BODY.parents), strict=True)
    for name, (mine, read) in zip(BODY.names, pairs, strict=True):
        if not name.endswith("Eye"):
            apart = Rotation.from_matrix(mine) * Rotation.from_matrix(read).inv()
            assert apart.magnitude().max() < (0.005 if name.endswith("Shoulder") else 0.001), name
    moved_mm = 1000 * (motion.body.hips_m - BODY.offsets_m[0])
    assert np.abs(decoded.place_mm[:, [1, 0, 2]] - moved_mm).max() <= 0.5


@pytest.mark.parametrize("order", ["XZY", "ZXY", "YZX"])
def test_angles_compose_to_the_rotation_even_where_two_axes_meet(order: str) -> None:
    given = np.array([[0.3, 0.2, -0.4], [2.0, -1.1, 0.5], [0.7, np.pi / 2, 0.4], [0.0, -np.pi / 2, 1.0]])
    rotations = Rotation.from_euler(order, given)
    again = Rotation.from_euler(order, euler_rad(rotations, order))
    assert (rotations * again.inv()).magnitude().max() < 1e-6
