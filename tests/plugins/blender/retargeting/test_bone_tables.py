"""The tables that are shipped, and what is said of wrong ones."""

from pathlib import Path

import pytest

from plugins.blender.retargeting.bone_tables import FOLDER, BoneTable, WrongTableError, load_tables, read_table
from plugins.rig_tables import SHARED, table

RIGHT = """
title = "Mine"
sides = {left = "L", right = "R"}
[middle]
hips = ["Pelvis", "Hip"]
[sided]
UpperArm = "{SIDE}_Arm.{side}"
"""


@pytest.mark.parametrize("table", load_tables(), ids=lambda table: table.name)
def test_every_table_names_a_humanoid_without_doubles(table: BoneTable) -> None:
    first = [names[0] for names in table.names.values()]
    assert len(set(first)) == len(first) >= 52
    assert {"hips", "head", "leftHand", "rightLittleDistal", "leftToes"} <= set(table.names)


@pytest.mark.parametrize("name", SHARED)
def test_rigs_that_the_realizer_knows_are_named_as_there(name: str) -> None:
    """Else run `python -m plugins.rig_tables`."""
    assert (FOLDER / f"{name}.toml").read_text(encoding="utf-8") == table(name)


def test_sides_are_filled_in(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(RIGHT.replace('left = "L"', 'left = "l"'))
    table = read_table(path)
    assert table.names == {"hips": ("Pelvis", "Hip"), "leftUpperArm": ("L_Arm.l",), "rightUpperArm": ("R_Arm.R",)}


def test_rigify_names_both_sides_of_what_its_constraints_ask_for() -> None:
    rigify = read_table(FOLDER / "rigify.toml")
    assert rigify.follows["f_index.01.R"] == "hand_fk.R"
    assert {(each.bone, each.name) for each in rigify.properties} >= {
        ("upper_arm_parent.L", "IK_FK"),
        ("upper_arm_parent.R", "IK_FK"),
        ("torso", "head_follow"),
    }


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("hips =", "hip ="), "middle.hip: the body has no such joint"),
        (('title = "Mine"', ""), "the key title is missing"),
        (('["Pelvis", "Hip"]', "[1]"), "middle.hips: expected a bone's name"),
        (("[middle]", "[centre]\n[middle]"), "there is no key centre"),
        (("UpperArm", "Arm"), "sided.Arm: the body has no such joint"),
        (("[sided]", '[also]\na = "hip"\n[sided]'), "also.a: the body has no joint hip"),
        (("[sided]", '[[properties]]\nbone = "a"\n[sided]'), r"properties\[0\]: expected bone, name and value"),
        (("[middle]", "[middle"), "mine.toml: "),
    ],
)
def test_a_wrong_table_says_what_is_wrong(tmp_path: Path, change: tuple[str, str], said: str) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(RIGHT.replace(*change))
    with pytest.raises(WrongTableError, match=said):
        read_table(path)
