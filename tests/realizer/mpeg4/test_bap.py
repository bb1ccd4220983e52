"""Body parameters, decoded by a reader of their own."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.support.motion.hand_made_motion import BODY, X, Y, Z, turned, waving
from tests.support.motion.mpeg4_reading import COLUMNS, RAD, Body, greta_world, read_parameters, world
from understudy.model import Behavior, Channel, Hand, Schedule, SyncPoints
from understudy.model.formats import BapVersion
from understudy.models import load_realizer
from understudy.realizer.body.motion import BodyMotion, Motion
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.mpeg4.bap import to_bap
from understudy.realizer.mpeg4.bap_reading import from_bap
from understudy.realizer.mpeg4.layout import BAPS, FAPS, arms_down, euler_rad, read_parameter_file, thumb_hinge
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


@pytest.mark.parametrize("version", list(BapVersion))
def test_what_is_read_back_is_where_we_have_it(acted: Motion, version: BapVersion) -> None:
    """Within a degree, from the hips to the fingers; where Greta's forearm cannot twist its direction is compared,
    and its collar bone lacks an angle that the arm below it has."""
    read = from_bap(read_parameter_file(to_bap(acted, BODY, version), BAPS, "x.bap"), BODY)
    pairs = zip(*(world(_joints(body), BODY.names, BODY.parents) for body in (acted.body, read)), strict=True)
    for name, (mine, found) in zip(BODY.names, pairs, strict=True):
        apart = (Rotation.from_matrix(mine) * Rotation.from_matrix(found).inv()).magnitude()
        if version is BapVersion.GRETA and name.endswith(("LowerArm", "LowerLeg")):
            along = np.array([1.0, 0.0, 0.0]) if name.endswith("Arm") else np.array([0.0, 1.0, 0.0])
            apart = np.linalg.norm((mine - found) @ along, axis=1)
        if not name.endswith("Eye"):
            collar = version is BapVersion.GRETA and name.endswith("Shoulder")
            assert np.degrees(apart.max()) < (2 if collar else 1), name
    assert np.abs(read.hips_m - acted.body.hips_m).max() <= 0.0005
    assert np.abs(read.times_s - acted.body.times_s).max() < 1e-9


def _joints(body: BodyMotion) -> dict[str, Rotation]:
    return {name: Rotation.from_quat(body.rotations[:, place]) for name, place in BODY.index.items()}


@pytest.mark.parametrize("order", ["XZY", "ZXY", "YZX"])
def test_angles_compose_to_the_rotation_even_where_two_axes_meet(order: str) -> None:
    given = np.array([[0.3, 0.2, -0.4], [2.0, -1.1, 0.5], [0.7, np.pi / 2, 0.4], [0.0, -np.pi / 2, 1.0]])
    rotations = Rotation.from_euler(order, given)
    again = Rotation.from_euler(order, euler_rad(rotations, order))
    assert (rotations * again.inv()).magnitude().max() < 1e-6


def test_greta_has_our_joints_where_we_have_them(acted: Motion) -> None:
    """Within a degree. A forearm, which cannot twist there, is compared by where it points, a thumb by its bends."""
    file = read_parameters(to_bap(acted, BODY, BapVersion.GRETA))
    theirs = greta_world(file)
    local = {name: Rotation.from_quat(acted.body.rotations[:, place]) for name, place in BODY.index.items()}
    ours = dict(zip(BODY.names, map(Rotation.from_matrix, world(local, BODY.names, BODY.parents)), strict=True))
    for name in theirs.keys() & ours.keys():
        side = "left" if name.startswith("left") else "right"
        of_an_arm = any(part in name for part in ("Arm", "Hand", "Index", "Middle", "Ring", "Little", "Thumb"))
        mine = ours[name] * arms_down(side).inv() if of_an_arm else ours[name]
        if name.endswith(("LowerArm", "Shoulder")):
            along = [0.0, -1.0, 0.0] if name.endswith("LowerArm") else [1.0, 0.0, 0.0]
            apart = np.arccos(np.clip(np.sum(mine.apply(along) * theirs[name].apply(along), axis=1), -1.0, 1.0))
        else:
            apart = (mine * theirs[name].inv()).magnitude()
        assert np.degrees(apart).max() < 1.0, name
    for offset, side in enumerate(("left", "right")):
        for part, place in (("Proximal", 5), ("Distal", 7)):
            hinge = thumb_hinge(side) / np.linalg.norm(thumb_hinge(side))
            bends = Rotation.from_rotvec(file.values[:, [COLUMNS["thumb"] + offset + place]] * RAD * hinge)
            assert (bends * local[f"{side}Thumb{part}"].inv()).magnitude().max() < 1e-4


@pytest.mark.parametrize(
    ("joint", "axis", "angle", "column", "value"),
    [
        ("leftLowerArm", Y, -1.5, COLUMNS["elbow"], -150_000),
        ("rightLowerArm", Y, 1.5, COLUMNS["elbow"] + 1, -150_000),
        ("leftLowerLeg", X, 0.5, COLUMNS["knee"], 50_000),
        ("head", X, 0.4, COLUMNS["skullbase"] + 2, 40_000),
        ("rightIndexIntermediate", Z, 1.7, COLUMNS["index"] + 9, 170_000),
    ],
)
def test_greta_bends_elbows_by_negative_angles(
    joint: str, axis: tuple[float, float, float], angle: float, column: int, value: int
) -> None:
    content = to_bap(turned(joint, from_axis_angle(axis, np.array(angle))), BODY, BapVersion.GRETA)
    assert read_parameters(content).values[0, column - 1] == pytest.approx(value, abs=1)


def test_greta_knows_no_parameter_that_we_leave_out() -> None:
    standard, greta = (read_parameters(to_bap(MOTION, BODY, version)).masks[0] for version in BapVersion)
    assert (greta >= standard).all()
