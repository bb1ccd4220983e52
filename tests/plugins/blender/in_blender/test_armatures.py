"""Other rigs, built here: called and resting as Mixamo's, VRoid's, Rigify's, they make the same gestures."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from plugins.blender.motion.rotations import Array
from plugins.blender.retargeting.bone_tables import FOLDER, read_table
from tests.plugins.blender.in_blender.tracks import heads

Bpy = Any
SIDES = ("left", "right")
"""Directions that an audience sees: limbs, and where the palms face (by the knuckles)."""
LIMBS = (
    ("UpperArm", "LowerArm"),
    ("LowerArm", "Hand"),
    ("Hand", "MiddleProximal"),
    ("LittleProximal", "IndexProximal"),
)
FINGERS = (("IndexProximal", "IndexIntermediate"), ("LittleIntermediate", "LittleDistal"))
FRAMES = (25, 60, 110, 190)


def first_names(table: str) -> dict[str, str]:
    return {joint: names[0] for joint, names in read_table(FOLDER / f"{table}.toml").names.items()}


def rebuilt(blender: Bpy, mannequin: Bpy, names: Mapping[str, str], arms_down_rad: float = 0.0) -> Bpy:
    """The mannequin's skeleton with bones of these names that point to their children, its arms lowered by an angle."""
    armature = blender.data.objects.new("Rebuilt", blender.data.armatures.new("Rebuilt"))
    blender.context.collection.objects.link(armature)
    blender.context.view_layer.objects.active = armature
    places = {bone.name: np.array(mannequin.matrix_world @ bone.head_local) for bone in mannequin.data.bones}
    for side, sign in (("left", 1), ("right", -1)):
        shoulder = places[f"{side}UpperArm"].copy()
        cosine, sine = np.cos(arms_down_rad), np.sin(arms_down_rad)
        for joint, (x, y, z) in list(places.items()):
            if joint.startswith(side) and any(
                part in joint for part in ("Arm", "Hand", "Thumb", "Index", "Middle", "Ring", "Little")
            ):
                outward, up = sign * (x - shoulder[0]), z - shoulder[2]
                turned = (outward * cosine + up * sine, y, up * cosine - outward * sine)
                places[joint] = np.array([shoulder[0] + sign * turned[0], turned[1], shoulder[2] + turned[2]])
    blender.ops.object.mode_set(mode="EDIT")
    for bone in mannequin.data.bones:
        made = armature.data.edit_bones.new(names[bone.name])
        made.head = places[bone.name]
        child = next((each.name for each in bone.children), None)
        made.tail = places[child] if child else places[bone.name] + np.array([0, 0, 0.05])
        if bone.parent:
            made.parent = armature.data.edit_bones[names[bone.parent.name]]
    blender.ops.object.mode_set(mode="OBJECT")
    return armature


def performed(blender: Bpy, armature: Bpy) -> dict[int, dict[str, Array]]:
    blender.context.scene.frame_current = 1
    blender.context.scene.understudy.performer = armature
    blender.ops.understudy.perform()
    return {frame: heads(blender, armature, frame) for frame in FRAMES}


def directions(places: Mapping[str, Array], names: Mapping[str, str]) -> dict[str, Array]:
    found = {}
    for side in SIDES:
        for start, end in (*LIMBS, *FINGERS):
            way = places[names[side + end]] - places[names[side + start]]
            found[f"{side} {start} {end}"] = way / np.linalg.norm(way)
    return found


def widest_deg(
    ours: Mapping[int, dict[str, Array]], theirs: Mapping[int, dict[str, Array]], names: Mapping[str, str]
) -> float:
    """The largest angle between a direction of ours and of theirs."""
    own = {joint: joint for joint in names}
    cosines = [
        float(directions(ours[frame], own)[way] @ directions(theirs[frame], names)[way])
        for frame in ours
        for way in directions(ours[frame], own)
    ]
    return float(np.degrees(np.arccos(min(*cosines, 1.0))))


@pytest.mark.parametrize(
    ("table", "arms_down_rad"), [("mixamo", 0.0), ("vroid", 0.0), ("unreal", 0.9), ("rigify_metarig", 0.7)]
)
def test_hands_point_as_ours_do(blender: Bpy, mannequin: Bpy, line: Bpy, table: str, arms_down_rad: float) -> None:
    names = first_names(table)
    rig = rebuilt(blender, mannequin, names, arms_down_rad)
    ours, theirs = performed(blender, mannequin), performed(blender, rig)
    assert widest_deg(ours, theirs, names) < 0.5
    assert line.text


def test_a_mixamo_file_is_in_centimetres_with_y_up(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    """As Blender imports its FBX: the object is turned by 90° and a hundredth in size, the bones have a prefix."""
    names = {joint: f"mixamorig:{name}" for joint, name in first_names("mixamo").items()}
    rig = rebuilt(blender, mannequin, names)
    from mathutils import Matrix

    upright = Matrix.Rotation(np.pi / 2, 4, "X") @ Matrix.Scale(0.01, 4)
    rig.data.transform(upright.inverted())
    rig.matrix_world = upright
    ours, theirs = performed(blender, mannequin), performed(blender, rig)
    for frame in FRAMES:
        for joint, name in names.items():
            assert np.allclose(theirs[frame][name], ours[frame][joint], atol=0.001), joint
    assert line.text


@pytest.mark.parametrize("mode", ["XYZ", "ZXY", "AXIS_ANGLE"])
def test_bones_are_keyed_in_their_own_rotation_mode(blender: Bpy, mannequin: Bpy, line: Bpy, mode: str) -> None:
    ours = performed(blender, mannequin)
    blender.ops.understudy.forget(name="example")
    for bone in mannequin.pose.bones:
        bone.rotation_mode = mode
    again = performed(blender, mannequin)
    assert line.text
    for frame in FRAMES:
        assert all(np.allclose(again[frame][joint], place, atol=1e-4) for joint, place in ours[frame].items())


def test_the_list_of_bones_is_found_and_can_be_changed(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    blender.context.view_layer.objects.active = mannequin
    mannequin.data.bones["leftHand"].name = "Handle"
    blender.ops.understudy.find_bones()
    found = {each.joint: each.bone for each in mannequin.understudy.bones}
    assert (found["rightHand"], found["leftHand"]) == ("rightHand", "")
    with pytest.raises(RuntimeError, match="no bones for leftHand"):
        blender.ops.understudy.perform()
    next(each for each in mannequin.understudy.bones if each.joint == "leftHand").bone = "Handle"
    blender.ops.understudy.perform()
    assert line.text
