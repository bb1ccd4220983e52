"""The tables of joint names are whole, and mistakes in them are told at their place."""

import json
import struct
from pathlib import Path

import pytest

from tests.support.shared_data import AVATAR, needs
from understudy.errors import AuthoringError, InputError
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.exporting.retargeting import find_rig, load_rigs

BODY = Skeleton.standing()
FOLDER = Path(__file__).parents[3] / "lexicon" / "retarget"
RIGS = load_rigs(FOLDER, BODY)


@pytest.mark.parametrize("rig", RIGS)
def test_tables_name_every_joint_once(rig: str) -> None:
    names = RIGS[rig].names
    assert tuple(names) == BODY.names
    assert len(set(names.values())) == len(names)


@pytest.mark.parametrize(
    ("rig", "joint", "name"),
    [
        ("mixamo", "upperChest", "Spine2"),
        ("mixamo", "leftLowerArm", "LeftForeArm"),
        ("mixamorig", "rightLittleDistal", "mixamorig:RightHandPinky3"),
        ("ready_player_me", "leftToes", "LeftToeBase"),
        ("vrm", "leftThumbMetacarpal", "leftThumbMetacarpal"),
        ("unreal", "rightUpperArm", "upperarm_r"),
        ("unreal", "leftEye", "FACIAL_L_Eye"),
        ("hanim", "leftShoulder", "l_sternoclavicular"),
        ("hanim", "head", "skullbase"),
    ],
)
def test_names_are_those_of_the_rigs(rig: str, joint: str, name: str) -> None:
    assert RIGS[rig].names[joint] == name


def test_unreals_axes_and_unit_are_noted() -> None:
    assert (RIGS["unreal"].unit_m, RIGS["unreal"].up, RIGS["unreal"].rest) == (0.01, "Z", "A-pose")


@needs(AVATAR)
def test_ready_player_mes_names_are_those_of_an_avatar() -> None:
    content = AVATAR.read_bytes()
    described = json.loads(content[20 : 20 + struct.unpack("<I", content[12:16])[0]])
    assert set(RIGS["ready_player_me"].names.values()) <= {node["name"] for node in described["nodes"]}


def test_mistakes_are_told_all_at_once_with_their_lines(tmp_path: Path) -> None:
    wrong = (FOLDER / "mixamo.yaml").read_text().replace("  neck: Neck\n", "  neck: Head\n  tail: Tail\n")
    (tmp_path / "wrong.yaml").write_text(wrong.replace('  Eye: "{side}Eye"\n', ""))
    with pytest.raises(AuthoringError) as caught:
        load_rigs(tmp_path, BODY)
    told = [(mistake.line, mistake.message) for mistake in caught.value.mistakes]
    assert (14, "the body has no joint tail") in told
    assert (13, "Head names two joints") in told
    assert any(message == "no name for leftEye, rightEye" for _line, message in told)


def test_an_unknown_skeleton_is_refused_with_those_there_are() -> None:
    with pytest.raises(InputError, match="mixamo, mixamorig") as caught:
        find_rig(RIGS, "biped")
    assert caught.value.code == "unknown_skeleton"


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ("like: mixamoo\n", "no rig mixamoo beside this file"),
        ("like: mixamo\nmiddle: {neck: Neck}\n", "give none here"),
    ],
)
def test_a_rig_like_another_has_its_names_alone(tmp_path: Path, more: str, told: str) -> None:
    (tmp_path / "mixamo.yaml").write_text((FOLDER / "mixamo.yaml").read_text())
    (tmp_path / "mine.yaml").write_text("unit_m: 1\nup: Y\nforward: +Z\nrest: T-pose\n" + more)
    with pytest.raises(AuthoringError, match=told) as caught:
        load_rigs(tmp_path, BODY)
    assert [mistake.line for mistake in caught.value.mistakes] == [5]
