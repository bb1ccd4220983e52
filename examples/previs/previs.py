"""A scene from recordings to a sheet of pictures, by one script in Blender (paper §4.1).

    .venv-bpy/bin/python examples/previs/previs.py -o out/previs.png
    blender --background --python examples/previs/previs.py -- -o out/previs.png

It installs the extension, builds the set of `scene.toml`, has the characters perform line after line, speaker and
listener, cuts from camera to camera, saves the blend file beside the sheet, and renders the moments in which most is
seen of each line. Recordings named after the options take the place of the scene's own, in the order of the lines.
"""

import argparse
import json
import sys
import tomllib
from collections.abc import Mapping, Sequence
from math import radians
from pathlib import Path
from typing import Any

import bpy

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT)]

from contact_sheet import COLUMNS, Panel, render_sheet  # noqa: E402 -- beside this script, which Blender does not search
from stage import add_camera, build_stage  # noqa: E402

from plugins.build_blender import build  # noqa: E402

ADDON = "bl_ext.user_default.understudy"
LAYER, BEHAVIORS = "understudy_layer", "understudy_behaviors"
"""Custom properties of actions (docs/blender.md)."""
APART_FRAMES = 8
"""Pictures are so far apart at least."""


def main(arguments: Sequence[str]) -> None:
    """The whole way."""
    asked = _arguments(arguments)
    scene_file = tomllib.loads(asked.scene.read_text(encoding="utf-8"))
    lines = _lines(scene_file["lines"], asked.scene.parent, asked.recordings)
    _install(asked)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.context.scene.render.fps = scene_file["frame_rate_hz"]
    cast = {name: _enter(name, wanted) for name, wanted in scene_file["characters"].items()}
    prop = build_stage(scene_file["prop"]["name"], scene_file["prop"]["place"])
    cameras = {name: add_camera(name, **wanted) for name, wanted in scene_file["cameras"].items()}
    rows = []
    for line in lines:
        rows.append(_perform(line, cast, prop, cameras[line["camera"]]))
        bpy.context.scene.frame_current = _end_frame() + round(scene_file["pause_s"] * scene_file["frame_rate_hz"])
    asked.output.parent.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(asked.output.with_suffix(".blend")))
    render_sheet(rows, asked.output, samples=asked.samples, width=asked.width)
    print(f"{asked.output}: {sum(map(len, rows))} moments of {len(lines)} lines, frames 1 to {_end_frame()}")


def _arguments(arguments: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("recordings", nargs="*", type=Path, help="instead of the scene's own, in order")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "out" / "previs.png")
    parser.add_argument("--scene", type=Path, default=HERE / "scene.toml")
    parser.add_argument("--service", help="URL of a service; else --command performs")
    parser.add_argument("--command", default=str(ROOT / ".venv" / "bin" / "understudy"))
    parser.add_argument("--samples", type=int, default=16, help="of Cycles, for each pixel")
    parser.add_argument("--width", type=int, default=480, help="of each picture, pixels")
    return parser.parse_args(arguments)


def _lines(lines: Sequence[Mapping[str, Any]], folder: Path, recordings: Sequence[Path]) -> list[dict[str, Any]]:
    """The lines with the files of their recordings."""
    own = [folder / line["audio"] for line in lines]
    files = [*recordings, *own[len(recordings) :]]
    return [{**line, "audio": file.resolve()} for line, file in zip(lines, files, strict=True)]


def _install(asked: argparse.Namespace) -> None:
    """The extension of this checkout, and who performs."""
    archive = build(ROOT / "dist")
    bpy.ops.extensions.package_install_files(
        filepath=str(archive), repo="user_default", enable_on_install=True, overwrite=True
    )
    preferences = bpy.context.preferences.addons[ADDON].preferences
    preferences.performer = "SERVICE" if asked.service else "LOCAL"
    if asked.service:
        preferences.url = asked.service
    else:
        preferences.command = asked.command


def _enter(name: str, wanted: Mapping[str, Any]) -> Any:
    """A character in its place, in its colour."""
    bpy.ops.understudy.add_mannequin(character=wanted["character"])
    armature = bpy.context.object
    armature.name, armature.location = name, wanted["place"]
    armature.rotation_mode = "XYZ"
    armature.rotation_euler = (0.0, 0.0, radians(wanted["turn"]))
    for mesh in (each for each in armature.children_recursive if each.type == "MESH"):
        for slot in (each for each in mesh.material_slots if each.material.name.startswith("jumper")):
            slot.material = slot.material.copy()
            slot.material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*wanted["colour"], 1)
    bpy.context.view_layer.update()
    return armature


def _perform(line: Mapping[str, Any], cast: Mapping[str, Any], prop: Any, camera: Any) -> list[Panel]:
    """Speaker and listener perform, the camera is cut to; the moments that are to be seen."""
    scene = bpy.context.scene
    settings, first = scene.understudy, scene.frame_current
    settings.source, settings.audio, settings.text = "FILE", str(line["audio"]), line["text"]
    settings.performer, settings.listener = cast[line["speaker"]], cast[line["listener"]]
    settings.agitation, settings.tail_s = line.get("agitation", "HEARD"), 0.8
    if prop.name not in {each.thing.name for each in settings.targets}:
        settings.targets.add().thing = prop
    bpy.ops.understudy.perform()
    cut = scene.timeline_markers.new(f"{line['speaker']}: {line['text']}"[:63], frame=first)
    cut.camera = camera
    return [Panel(frame, camera, caption) for frame, caption in _moments(line, first)]


def _moments(line: Mapping[str, Any], first: int) -> list[tuple[int, str]]:
    """The frames in which most is seen of a line: gestures first, then the head, then the face, then the trunk."""
    speaker = bpy.data.objects[line["speaker"]]
    keys = (each.data.shape_keys for each in speaker.children_recursive if each.type == "MESH")
    owners = [each for each in (speaker, *keys) if each and each.animation_data]
    strips = [strip for owner in owners for track in owner.animation_data.nla_tracks for strip in track.strips]
    shown: list[tuple[str, int, str]] = []
    for strip in (each for each in strips if each.frame_start >= first and LAYER in each.action):
        kinds = [each["kind"] for each in json.loads(strip.action[BEHAVIORS])]
        marks = zip(kinds, strip.action.pose_markers, strict=True)
        shown += [(kind, round(strip.frame_start + mark.frame), mark.name) for kind, mark in marks]
    found: dict[int, str] = {}
    for kind in ("gesture", "head", "face", "posture"):
        for _kind, frame, name in (each for each in shown if each[0] == kind):
            if len(found) < COLUMNS and all(abs(frame - other) >= APART_FRAMES for other in found):
                found[frame] = f"{line['speaker']}: {name}"
    return sorted(found.items())


def _end_frame() -> int:
    """The frame in which the last recording ends."""
    return max(round(strip.frame_final_end) for strip in bpy.context.scene.sequence_editor.strips_all)


if __name__ == "__main__":
    main(sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:])
