"""Out of Blender: baked into one action, FBX and USD that play the same, and a timeline of the scene."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.plugins.blender.in_blender.tracks import heads, tracks

Bpy = Any
FRAMES = (20, 60, 120)


def keys_of(armature: Bpy) -> int:
    """How many keys a curve of the active action has at most. Actions have layers since Blender 4.4."""
    action = armature.animation_data.action
    if not hasattr(action, "layers"):
        return max(len(curve.keyframe_points) for curve in action.fcurves)
    bags = [bag for layer in action.layers for strip in layer.strips for bag in strip.channelbags]
    return max(len(curve.keyframe_points) for bag in bags for curve in bag.fcurves)


@pytest.mark.parametrize("sparse", [False, True])
def test_a_baked_action_plays_what_the_tracks_did(blender: Bpy, performed: Bpy, sparse: bool) -> None:
    before = {frame: heads(blender, performed, frame) for frame in FRAMES}
    blender.ops.understudy.bake(sparse=sparse)
    assert all(track.mute for track in performed.animation_data.nla_tracks)
    for frame, places in before.items():
        after = heads(blender, performed, frame)
        furthest = max(float(np.linalg.norm(after[bone] - place)) for bone, place in places.items())
        assert furthest < (0.02 if sparse else 1e-5)
    assert (keys_of(performed) < 150) is sparse
    blender.ops.understudy.unbake()
    assert performed.animation_data.action is None
    assert not any(track.mute for track in performed.animation_data.nla_tracks)


def test_the_mouth_is_baked_too(blender: Bpy, performed: Bpy) -> None:
    (face,) = [mesh for mesh in blender.data.objects if mesh.type == "MESH" and mesh.data.shape_keys]
    jaw = face.data.shape_keys.key_blocks["jawOpen"]
    opened = []
    for _time in range(2):
        found = []
        for frame in FRAMES:
            blender.context.scene.frame_set(frame)
            found.append(jaw.value)
        opened.append(found)
        blender.ops.understudy.bake(sparse=True)
    assert opened[1] == pytest.approx(opened[0], abs=0.02)
    assert performed.name


@pytest.mark.parametrize("kind", ["fbx", "usdc"])
def test_a_file_plays_the_same(blender: Bpy, performed: Bpy, tmp_path: Path, kind: str) -> None:
    """Read again by Blender: the wrists are where they were, and the scene is as it was."""
    path = tmp_path / f"ann.{kind}"
    before = {frame: heads(blender, performed, frame)["rightHand"] for frame in FRAMES}
    laid = {track: [each.name for each in strips] for track, strips in tracks(performed).items()}
    export = blender.ops.understudy.export_fbx if kind == "fbx" else blender.ops.understudy.export_usd
    export(filepath=str(path))
    assert performed.animation_data.action is None
    assert {track: [each.name for each in strips] for track, strips in tracks(performed).items()} == laid
    assert path.stat().st_size < 8e6
    blender.ops.wm.read_homefile(use_empty=True)
    blender.context.scene.render.fps = 30
    if kind == "fbx":
        blender.ops.import_scene.fbx(filepath=str(path))
    else:
        blender.ops.wm.usd_import(filepath=str(path))
    again = next(each for each in blender.data.objects if each.type == "ARMATURE")
    later = round(again.animation_data.action.frame_range[0]) - 1 if kind == "fbx" else 0
    for frame, place in before.items():
        wrist = heads(blender, again, frame + later)["rightHand"]
        assert np.linalg.norm(wrist - place) < 0.01


def test_what_is_not_performed_cannot_be_baked(blender: Bpy, mannequin: Bpy) -> None:
    assert mannequin.name
    with pytest.raises(RuntimeError, match="no performance yet"):
        blender.ops.understudy.bake()


def test_a_scene_as_a_timeline(blender: Bpy, performed: Bpy, tmp_path: Path) -> None:
    path = tmp_path / "scene.otio"
    blender.ops.understudy.export_otio(filepath=str(path))
    timeline = json.loads(path.read_bytes())
    names = [each["name"] for each in timeline["tracks"]["children"]]
    assert f"{performed.name} gesture" in names
    gestures = timeline["tracks"]["children"][names.index(f"{performed.name} gesture")]["children"]
    clip = next(each for each in gestures if each["OTIO_SCHEMA"] == "Clip.2")
    assert clip["name"].startswith("gesture: ")
    assert clip["metadata"]["understudy"]["words"]
    assert ("sound 1" in names) is blender.app.build_options.audaspace
