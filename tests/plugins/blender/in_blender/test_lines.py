"""A line performed in Blender: on our own skeleton, with its sound, its markers and its strips."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import requests

from plugins.blender.motion.clip import read_clip
from tests.plugins.blender.in_blender.conftest import ADDON, AUDIO, COMMAND, WORDS
from tests.plugins.blender.in_blender.tracks import heads, joints_m, strip, tracks

Bpy = Any
"""Blender's data has no types."""
LAYERS = {"Understudy body", "Understudy head", "Understudy gaze"}


def test_joints_are_where_the_realizer_has_them(blender: Bpy, mannequin: Bpy, line: Bpy, service: str) -> None:
    blender.ops.understudy.perform()
    form = {
        "bml": ("line.bml", mannequin.understudy.performances[0].bml.as_string().encode()),
        "audio": ("line.flac", AUDIO.read_bytes()),
        "options": (None, json.dumps({"fps": 30})),
    }
    answer = requests.post(f"{service}/realize", files=form, headers={"Accept": "application/json"}, timeout=60)
    clip = read_clip(answer.content)
    first = blender.context.scene.frame_start
    for frame in range(0, clip.frames, 20):
        found, ours = heads(blender, mannequin, first + frame), joints_m(clip, frame)
        furthest = max(float(np.linalg.norm(found[joint] - ours[joint])) for joint in ours)
        assert furthest < 0.001, f"{furthest * 1000:.2f} mm in frame {frame}"
    assert line.set_range


def test_layers_lie_on_tracks_with_their_reasons(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    blender.ops.understudy.perform()
    scene = blender.context.scene
    there = tracks(mannequin)
    assert set(there) >= LAYERS
    (face,) = [mesh for mesh in blender.data.objects if mesh.type == "MESH" and mesh.data.shape_keys]
    assert set(tracks(face.data.shape_keys)) == {"Understudy face"}
    body = strip(mannequin, "example body").action
    reasons = json.loads(body["understudy_behaviors"])
    assert [marker.name for marker in body.pose_markers] == [
        f"{each['lexeme']} · " + " by ".join(part for part in (each["function"], each["rule"]) if part)
        for each in reasons
    ]
    assert all(each["kind"] in {"gesture", "posture"} for each in reasons)
    assert any(each["function"] == "negation" and "never" in each["words"] for each in reasons)
    assert (scene.frame_start, scene.frame_end) == (1, 216)
    assert line.set_range


@pytest.mark.usefixtures("sounds")
def test_the_sound_is_placed_where_the_motion_begins(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    scene = blender.context.scene
    scene.frame_current = 50
    line.lead_in_s = 0.5
    blender.ops.understudy.perform()
    (sound,) = scene.sequence_editor.strips_all
    assert (sound.frame_final_start, Path(sound.sound.filepath)) == (50, AUDIO)
    assert strip(mannequin, "example body").frame_start == 35
    assert scene.frame_start == 35


def test_the_mouth_opens_with_the_words(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    blender.ops.understudy.perform()
    assert mannequin.understudy.performances[0].name == "example"
    (face,) = [mesh for mesh in blender.data.objects if mesh.type == "MESH" and mesh.data.shape_keys]
    opened = {}
    for frame in range(1, 216, 3):
        blender.context.scene.frame_set(frame)
        opened[frame] = face.data.shape_keys.key_blocks["jawOpen"].value
    assert max(opened.values()) > 0.2
    assert opened[1] < 0.05
    assert line.text == WORDS


@pytest.mark.usefixtures("sounds")
def test_a_strip_of_the_sequencer_with_its_words(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    """The words stand in text strips beside it; the strip's middle alone is performed where it is cut."""
    scene = blender.context.scene
    editor = scene.sequence_editor_create()
    sound = (editor.strips if hasattr(editor, "strips") else editor.sequences).new_sound("line", str(AUDIO), 1, 100)
    sound["text"] = WORDS
    line.source, line.strip, line.text = "STRIP", "line", ""
    blender.ops.understudy.perform()
    (record,) = mannequin.understudy.performances
    assert (record.name, record.zero_frame) == ("line", 100)
    assert json.loads(record.order)["text"] == WORDS
    assert len(scene.sequence_editor.strips_all) == 1


@pytest.mark.usefixtures("sounds")
def test_a_cut_strip_is_performed_as_it_is_heard(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    scene = blender.context.scene
    editor = scene.sequence_editor_create()
    sound = (editor.strips if hasattr(editor, "strips") else editor.sequences).new_sound("cut", str(AUDIO), 1, 1)
    sound.frame_offset_start, sound.frame_offset_end = 104, 60
    line.source, line.strip, line.text = "STRIP", "cut", "Are you really sure"
    blender.ops.understudy.perform()
    body = strip(mannequin, "cut body")
    assert body.frame_start == 105
    assert body.frame_end - body.frame_start == pytest.approx(sound.frame_final_duration, abs=2)


def test_two_lines_share_the_tracks_and_the_same_line_is_laid_anew(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    blender.ops.understudy.perform()
    blender.context.scene.frame_current = 300
    blender.ops.understudy.perform()
    assert [each.frame_start for each in tracks(mannequin)["Understudy body"]] == [1, 300]
    assert [each.name for each in mannequin.understudy.performances] == ["example", "example 2"]
    assert (blender.context.scene.frame_start, blender.context.scene.frame_end) == (1, 515)
    blender.ops.understudy.forget(name="example")
    assert [each.frame_start for each in tracks(mannequin)["Understudy body"]] == [300]
    assert [each.name for each in mannequin.understudy.performances] == ["example 2"]
    assert line.set_range


def test_it_is_there_after_saving_and_reopening(blender: Bpy, mannequin: Bpy, line: Bpy, tmp_path: Path) -> None:
    blender.ops.understudy.perform()
    name, before = mannequin.name, heads(blender, mannequin, 60)
    assert line.text
    blender.ops.wm.save_as_mainfile(filepath=str(tmp_path / "line.blend"))
    blender.ops.wm.read_homefile(use_empty=True)
    blender.ops.wm.open_mainfile(filepath=str(tmp_path / "line.blend"))
    again = blender.data.objects[name]
    after = heads(blender, again, 60)
    assert all(np.allclose(after[bone], place, atol=1e-6) for bone, place in before.items())
    assert set(tracks(again)) >= LAYERS
    assert "<gesture" in again.understudy.performances[0].bml.as_string()


def test_undo_takes_the_performance_back(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    name = mannequin.name
    blender.ops.ed.undo_push(message="before")
    blender.ops.understudy.perform()
    assert line.text
    blender.ops.ed.undo_push(message="performed")
    blender.ops.ed.undo()
    again = blender.data.objects[name]
    assert tracks(again) == {}
    assert len(again.understudy.performances) == 0
    blender.ops.ed.redo()
    assert set(tracks(blender.data.objects[name])) >= LAYERS


def test_a_local_install_performs_the_same(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    blender.ops.understudy.perform()
    by_service = mannequin.understudy.performances[0].bml.as_string()
    chosen = blender.context.preferences.addons[ADDON].preferences
    chosen.performer, chosen.command = "LOCAL", COMMAND
    blender.ops.understudy.perform()
    assert line.text
    first, again = (
        each.split("<description")[1] for each in (by_service, mannequin.understudy.performances[1].bml.as_string())
    )
    assert first == again


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"text": " "}, "there are no words"),
        ({"audio": "/nowhere.wav"}, "there is no file /nowhere.wav"),
        ({"source": "STRIP", "strip": ""}, "choose a sound strip"),
        ({"source": "STRIP", "strip": "gone"}, "no sound strip 'gone'"),
        ({"audio": __file__}, r"test_lines\.py"),
    ],
)
def test_what_is_missing_is_told(blender: Bpy, mannequin: Bpy, line: Bpy, change: dict[str, str], said: str) -> None:
    for name, value in change.items():
        setattr(line, name, value)
    with pytest.raises(RuntimeError, match=said):
        blender.ops.understudy.perform()
    assert tracks(mannequin) == {}


def test_what_the_service_refuses_is_told_in_its_words(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    mannequin.understudy.character = "nobody"
    assert line.text
    with pytest.raises(RuntimeError, match="nobody"):
        blender.ops.understudy.perform()


def test_no_service_is_told(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    blender.context.preferences.addons[ADDON].preferences.url = "http://127.0.0.1:9"
    assert mannequin.name
    assert line.text
    with pytest.raises(RuntimeError, match="no service answers"):
        blender.ops.understudy.perform()


def test_an_armature_that_is_no_humanoid_is_told_what_is_missing(blender: Bpy, line: Bpy) -> None:
    armature = blender.data.objects.new("Crane", blender.data.armatures.new("Crane"))
    blender.context.collection.objects.link(armature)
    line.performer = armature
    with pytest.raises(RuntimeError, match="Crane has no bones for hips, head"):
        blender.ops.understudy.perform()


def test_a_line_that_begins_before_the_last_has_ended_is_faded_in(blender: Bpy, mannequin: Bpy, line: Bpy) -> None:
    """With a tail of 1 s the next line begins in it: no joint jumps (without the fades one does by .2 and
    .5 m), and a third line goes back to the first track."""
    line.tail_s = 1.0
    for start in (1, 230, 459):
        blender.context.scene.frame_current = start
        blender.ops.understudy.perform()
    there = tracks(mannequin)
    assert [each.frame_start for each in there["Understudy body"]] == [1, 459]
    assert [each.frame_start for each in there["Understudy body 2"]] == [230]
    for begins in (230, 459):
        before = heads(blender, mannequin, begins - 1)
        for frame in range(begins, begins + 25):
            after = heads(blender, mannequin, frame)
            furthest = max(float(np.linalg.norm(after[bone] - place)) for bone, place in before.items())
            assert furthest < 0.08, f"{furthest:.3f} m from frame {frame - 1} to {frame}"
            before = after
