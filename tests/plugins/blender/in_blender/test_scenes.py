"""Others in the scene: what is spoken of is pointed at, who is spoken to is looked at, and listens."""

from typing import Any

import numpy as np
import pytest

from plugins.blender.motion.rotations import Array
from tests.plugins.blender.in_blender.tracks import heads, tracks

Bpy = Any


@pytest.fixture
def lamp(blender: Bpy, mannequin: Bpy, line: Bpy) -> Bpy:
    """A lamp to the left of the character, which the line is about; the character stands aside and is turned."""
    from mathutils import Vector

    mannequin.location, mannequin.rotation_euler = (2.0, 1.0, 0.0), (0.0, 0.0, 0.7)
    mannequin.rotation_mode = "XYZ"
    blender.context.view_layer.update()
    blender.ops.mesh.primitive_cube_add(size=0.2, location=mannequin.matrix_world @ Vector((1.6, -1.2, 0.9)))
    lamp = blender.context.object
    lamp.name = "Lights"
    line.targets.add().thing = lamp
    line.performer = mannequin
    return lamp


def test_a_thing_that_words_name_is_pointed_at(blender: Bpy, mannequin: Bpy, lamp: Bpy, line: Bpy) -> None:
    """Those lights: in the frame of the gesture's stroke the arm points to the lamp."""
    assert line.targets
    blender.ops.understudy.perform()
    (pointing,) = [each for strips in tracks(mannequin).values() for each in strips if "point" in each.name]
    frame = round(pointing.frame_start + pointing.action.pose_markers["stroke"].frame)
    joints = heads(blender, mannequin, frame)
    shoulder, (x, y, z) = joints["leftUpperArm"], lamp.location
    assert angle_deg(joints["leftIndexDistal"] - shoulder, np.array([x, z, -y]) - shoulder) < 12


def angle_deg(one: Array, other: Array) -> float:
    return float(np.degrees(np.arccos(one @ other / np.linalg.norm(one) / np.linalg.norm(other))))


def test_the_listener_is_looked_at_and_listens(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    blender.ops.understudy.add_mannequin(character="reserved")
    other = blender.context.object
    other.location, other.rotation_mode, other.rotation_euler = (0.9, -1.1, 0.0), "XYZ", (0.0, 0.0, 2.5)
    line.performer, line.listener = mannequin, other
    blender.ops.understudy.perform()
    assert set(tracks(other)) >= {"Understudy body", "Understudy head"}
    assert [each.name for each in other.understudy.performances] == ["example"]
    joints, theirs = heads(blender, mannequin, 75), heads(blender, other, 75)
    eye = joints["leftEye"]
    turned = mannequin.pose.bones["leftEye"].matrix.to_3x3()
    rest = mannequin.data.bones["leftEye"].matrix_local.to_3x3().inverted()
    from mathutils import Vector

    x, y, z = turned @ rest @ Vector((0, -1, 0))
    assert angle_deg(np.array([x, z, -y]), theirs["leftEye"] - eye) < 12


def test_the_listener_may_be_an_object_or_a_camera(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    camera = blender.data.objects.new("Eye", blender.data.cameras.new("Eye"))
    blender.context.collection.objects.link(camera)
    camera.location = (0.5, -3.0, 1.7)
    blender.context.view_layer.update()
    line.performer, line.camera = mannequin, camera
    blender.ops.understudy.perform()
    bml = mannequin.understudy.performances[0].bml.as_string()
    assert '<pawn name="camera" x="0.500' in bml
    assert '<pawn name="listener" x="0.500' in bml


def test_a_larger_armature_sees_things_in_its_own_size(blender: Bpy, mannequin: Bpy, lamp: Bpy, line: Bpy) -> None:
    """Twice as large and twice as far away: the same numbers for the service."""
    blender.ops.understudy.perform()
    mannequin.scale = (2.0, 2.0, 2.0)
    lamp.location = mannequin.location + (lamp.location - mannequin.location) * 2
    blender.context.view_layer.update()
    blender.ops.understudy.perform()
    written = (each.bml.as_string() for each in mannequin.understudy.performances)
    first, second = (bml.split("<pawn")[1].split("/>")[0] for bml in written)
    assert first == second
    assert line.targets


def test_targets_are_added_from_the_selection(blender: Bpy, mannequin: Bpy, lamp: Bpy, line: Bpy) -> None:
    line.targets.clear()
    for each in (mannequin, lamp):
        each.select_set(True)
    blender.ops.understudy.add_target()
    blender.ops.understudy.add_target()
    assert [each.thing for each in line.targets] == [lamp, None]
    line.active_target = 1
    blender.ops.understudy.remove_target()
    assert [each.thing for each in line.targets] == [lamp]


def test_a_speakers_way_of_gesturing_is_asked_for(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    assert line.text
    mannequin.understudy.profile = "nobody"
    with pytest.raises(RuntimeError, match="nobody"):
        blender.ops.understudy.perform()
    mannequin.understudy.profile = "sweeping"
    blender.ops.understudy.perform()
    assert '"profile": "sweeping"' in mannequin.understudy.performances[0].order
