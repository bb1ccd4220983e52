"""Time to import a line into Blender once the service has responded, and the distance of its joints from ours.

    .venv/bin/understudy serve &
    .venv-bpy/bin/python -m benchmarks.plugins.blender_line [--service URL] [--runs 5]

The bundled line (7.2 s, 60 frames a second) is performed and realized; then reading the answer, retargeting it, and
laying actions, markers, strips and sound is timed, by the clock and as processor time. Joints are compared with the
clip's own forward kinematics in every tenth frame.
"""

import argparse
import importlib
import json
import os
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any

import requests

ROOT = Path(__file__).parents[2]
AUDIO = ROOT / "examples" / "example.flac"
WORDS = (ROOT / "examples" / "example.txt").read_text(encoding="utf-8").strip()
os.environ["BLENDER_USER_RESOURCES"] = tempfile.mkdtemp(prefix="understudy-blender-")


def main() -> None:
    """Prints the times and the largest distance."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--service", default="http://127.0.0.1:8000")
    parser.add_argument("--runs", type=int, default=5)
    asked = parser.parse_args()
    performed, clip = _answers(asked.service)
    bpy = _installed(asked.service)
    armature = bpy.context.object
    clock_s, processor_s = zip(*(_laid(armature, performed, clip, run) for run in range(asked.runs)), strict=True)
    print(f"Blender {bpy.app.version_string}, {len(clip) / 1e6:.1f} MB of motion, {asked.runs} runs")
    print(f"into Blender   {statistics.median(clock_s):.2f} s by the clock, {max(clock_s):.2f} at most")
    print(f"               {statistics.median(processor_s):.2f} s of processor time")
    print(f"joints         {_furthest_m(bpy, armature, clip) * 1000:.3f} mm from the realizer's at most")


def _answers(service: str) -> tuple[dict[str, Any], bytes]:
    """The performance, and its motion."""
    form: dict[str, Any] = {"audio": (AUDIO.name, AUDIO.read_bytes()), "text": (None, WORDS)}
    headers = {"Accept": "application/json"}
    performed = requests.post(f"{service}/perform", files=form, headers=headers, timeout=300).json()
    form = {"bml": ("line.bml", performed["bml"].encode()), "audio": form["audio"], "options": (None, '{"fps": 60}')}
    return performed, requests.post(f"{service}/realize", files=form, headers=headers, timeout=300).content


def _installed(service: str) -> Any:
    """Blender with the extension and the mannequin."""
    import bpy

    from plugins.build_blender import build

    archive = build(Path(tempfile.mkdtemp()))
    bpy.ops.extensions.package_install_files(
        filepath=str(archive), repo="user_default", enable_on_install=True, overwrite=True
    )
    bpy.context.preferences.addons["bl_ext.user_default.understudy"].preferences.url = service
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.context.scene.render.fps = 60
    bpy.ops.understudy.add_mannequin()
    return bpy


def _laid(armature: Any, performed: dict[str, Any], clip: bytes, run: int) -> tuple[float, float]:
    """Clock and processor time of bringing the answers in, seconds."""
    addon = "bl_ext.user_default.understudy"
    behaviors, lines, clips, performances, sounds = (
        importlib.import_module(f"{addon}.{name}")
        for name in ("schedule.behaviors", "performing.lines", "motion.clip", "scene.performances", "scene.sounds")
    )
    import bpy

    begun_s, used_s = time.perf_counter(), time.process_time()
    bml, trace = performed["bml"].encode(), json.loads(json.dumps(performed["performance"]))
    read = clips.read_clip(clip)
    played = lines.PlayedLine(bml, read, behaviors.behaviors_of(bml, read, trace), trace)
    order = performances.Order(f"run {run}", 1.0 + 1000 * run, AUDIO, WORDS, {}, {})
    performances.lay_performance(armature, played, order, 60.0)
    sounds.place_sound(bpy.context.scene, AUDIO, 1 + 1000 * run, order.name)
    bpy.context.view_layer.update()
    return time.perf_counter() - begun_s, time.process_time() - used_s


def _furthest_m(bpy: Any, armature: Any, content: bytes) -> float:
    """The largest distance of a joint, over every tenth frame of the first run."""
    from plugins.blender.motion.clip import read_clip
    from tests.plugins.blender.in_blender.tracks import heads, joints_m

    clip = read_clip(content)
    found = 0.0
    for frame in range(0, clip.frames, 10):
        places = heads(bpy, armature, 1 + frame)
        found = max(
            found, *(float(((places[name] - at) ** 2).sum()) ** 0.5 for name, at in joints_m(clip, frame).items())
        )
    return found


if __name__ == "__main__":
    main()
