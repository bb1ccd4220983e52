"""Bones found by name: in the rigs that Understudy itself knows, and as other programs change their names."""

import pytest

from plugins.blender.retargeting.bone_tables import load_tables
from plugins.blender.retargeting.matching import find_bones
from plugins.blender.retargeting.skeleton import JOINTS
from understudy.files import resource_folder
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.exporting.retargeting import load_rigs

TABLES = load_tables()
RIGS = load_rigs(resource_folder("lexicon") / "retarget", Skeleton.standing())
OTHERS = ("Camera", "Root", "LeftEye_end", "spine_extra", "weapon.R")


@pytest.mark.parametrize("name", [name for name in RIGS if name != "hanim"])
def test_the_rigs_that_understudy_writes_are_found_whole(name: str) -> None:
    found = find_bones([*OTHERS, *RIGS[name].names.values()], TABLES)
    assert dict(found.bones) == dict(RIGS[name].names)
    assert found.missing == ()


@pytest.mark.parametrize("change", [str.upper, lambda name: f"mixamorig7:{name}", lambda name: f"Armature|{name}"])
def test_prefixes_and_case_do_not_matter(change: object) -> None:
    assert callable(change)
    names = {joint: change(bone) for joint, bone in RIGS["mixamo"].names.items()}
    assert dict(find_bones(names.values(), TABLES).bones) == names


def test_a_rig_without_fingers_and_eyes_can_perform() -> None:
    bones = [bone for joint, bone in RIGS["mixamo"].names.items() if "Hand" not in joint[:-4] and "Eye" not in joint]
    kept = [bone for bone in bones if not any(part in bone for part in ("Thumb", "Index", "Middle", "Ring", "Pinky"))]
    assert find_bones(kept, TABLES).missing == ()


def test_what_is_missing_is_named() -> None:
    bones = [bone for joint, bone in RIGS["vrm"].names.items() if joint != "leftLowerArm"]
    assert find_bones(bones, TABLES).missing == ("leftLowerArm",)


def test_no_bone_is_two_joints() -> None:
    assert len(set(find_bones(["hips", "Hips", "head"], TABLES).bones.values())) == 2


def test_joints_are_those_of_the_skeleton() -> None:
    assert set(JOINTS) == set(Skeleton.standing().names)
