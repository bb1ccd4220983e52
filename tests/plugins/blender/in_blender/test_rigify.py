"""Rigify: the rig that Blender's own add-on generates, whose deforming bones must point as our joints do."""

from typing import Any

import numpy as np
import pytest

from tests.plugins.blender.in_blender.test_armatures import FRAMES, performed

Bpy = Any
DEFORMING = {
    "UpperArm": "DEF-upper_arm.{side}",
    "LowerArm": "DEF-forearm.{side}",
    "Hand": "DEF-hand.{side}",
    "UpperLeg": "DEF-thigh.{side}",
    "LowerLeg": "DEF-shin.{side}",
    "Foot": "DEF-foot.{side}",
}
LIMBS = (("UpperArm", "LowerArm"), ("LowerArm", "Hand"), ("UpperLeg", "LowerLeg"), ("LowerLeg", "Foot"))


@pytest.fixture
def rig(blender: Bpy) -> Bpy:
    """A generated rig of the human without face and fingers, which takes an eighth of a second instead of fourteen."""
    import addon_utils

    addon_utils.enable("rigify", default_set=True)
    blender.ops.object.armature_basic_human_metarig_add()
    metarig = blender.context.object
    blender.ops.pose.rigify_generate()
    return next(each for each in blender.data.objects if each.type == "ARMATURE" and each is not metarig)


def test_deforming_bones_point_as_our_joints_do(blender: Bpy, rig: Bpy, mannequin: Bpy, line: Bpy) -> None:
    ours, theirs = performed(blender, mannequin), performed(blender, rig)
    assert line.text
    for frame in FRAMES:
        for side, letter in (("left", "L"), ("right", "R")):
            for start, end in LIMBS:
                one = ours[frame][side + end] - ours[frame][side + start]
                other = theirs[frame][DEFORMING[end].format(side=letter)]
                other = other - theirs[frame][DEFORMING[start].format(side=letter)]
                cosine = float(one @ other / np.linalg.norm(one) / np.linalg.norm(other))
                assert np.degrees(np.arccos(min(cosine, 1.0))) < 0.2, f"{side}{start} in frame {frame}"


def test_limbs_are_switched_to_forward_kinematics(blender: Bpy, rig: Bpy, line: Bpy) -> None:
    line.performer = rig
    blender.ops.understudy.perform()
    assert rig.pose.bones["upper_arm_parent.L"]["IK_FK"] == 1.0
    assert rig.pose.bones["torso"]["head_follow"] == 1.0


def test_the_metarig_itself_performs_too(blender: Bpy, rig: Bpy, line: Bpy) -> None:
    assert rig.name
    line.performer = next(each for each in blender.data.objects if each.type == "ARMATURE" and each is not rig)
    blender.ops.understudy.perform()
    assert line.performer.animation_data.nla_tracks
