"""Positions of joints in each of our motion files, as other programs read them.

    python -m benchmarks.realizer.exporting.joints --node-modules FOLDER

A recorded line's motion (the bundled example) is written as BVH, GLB, clip JSON, USD in its three forms, and FBX where
there is Blender (UNDERSTUDY_BLENDER), and read by three.js (GLB, BVH, FBX), by Pixar's USD and, for the clip, by
SciPy's rotations. Every joint is compared with our own forward kinematics in every seventh frame. For FBX, pyufbx says
units, axes and range; for USD, all of its validators are asked. FOLDER is where `npm install three gltf-validator` put
its packages.
"""

import argparse
import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Usd, UsdSkel, UsdValidation
from scipy.spatial.transform import Rotation

from tests.support.motion.mpeg4_reading import Body, read_parameters, world
from understudy.errors import ServiceError
from understudy.model import FloatArray, Line
from understudy.model.formats import AudioFile, FileOptions, MotionFormat
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import PreparedSchedule, RealizedSchedule, Realizer, realize_prepared, write_motion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.settings import Settings, read_settings

EXAMPLE = Path(__file__).resolve().parents[3] / "examples" / "example.flac"
RATE_HZ = 60
STEP = 7
"""As in formats.mjs: positions are compared in every seventh frame."""
SCENES = (MotionFormat.USDA, MotionFormat.USDC, MotionFormat.USDZ)
BY_THREE = (MotionFormat.GLB, MotionFormat.BVH, MotionFormat.FBX)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--node-modules", type=Path, help="where three and gltf-validator are")
    modules = parser.parse_args().node_modules
    with Understudy.load(Settings()) as understudy, tempfile.TemporaryDirectory() as folder:
        line = Line(EXAMPLE.read_bytes(), EXAMPLE.with_suffix(".txt").read_text(encoding="utf-8"))
        schedule = PreparedSchedule.of(perform(understudy, line, Options()))
        realized = realize_prepared(understudy.realizer, schedule, frame_rate_hz=RATE_HZ)
        shutil.copy(EXAMPLE, folder)
        files = dict(_written(realized, understudy.realizer, Path(folder)))
        skeleton = understudy.realizer.performer(realized.schedule.character).skeleton
        body = realized.motion.body
        ours, _turns = forward(skeleton, body.rotations[::STEP], body.hips_m[::STEP])
        names = understudy.realizer.rig("mixamo").names
        for name, found in _joints(files, skeleton, names, modules):
            frames = min(len(found), len(ours))
            apart_mm = 1000 * np.linalg.norm(found[:frames] - ours[:frames], axis=-1).max()
            print(f"{name:6} {apart_mm:.4f} mm apart in {frames} of {len(ours)} frames of {found.shape[1]} joints")
        _decode(realized, files, skeleton)
        _validate(files)
        _tell_fbx(files)


def _written(realized: RealizedSchedule, realizer: Realizer, folder: Path) -> Iterator[tuple[MotionFormat, Path]]:
    audio = AudioFile(EXAMPLE.name, EXAMPLE.read_bytes())
    options = FileOptions(root_at_origin=True, audio=audio, blender=read_settings().blender)
    for form in (*SCENES, *BY_THREE, MotionFormat.JSON, MotionFormat.BAP):
        path = folder / f"motion{form}"
        try:
            path.write_bytes(write_motion(realized, realizer, form, options=options))
        except ServiceError as error:
            print(f"{form}: {error}")
        else:
            yield form, path


def _joints(
    files: Mapping[MotionFormat, Path], skeleton: Skeleton, names: Mapping[str, str], modules: Path | None
) -> Iterator[tuple[str, FloatArray]]:
    """Positions (T, J, 3), metres, as read from each file."""
    for form in SCENES:
        yield form, _of_usd(files[form])
    yield MotionFormat.JSON, _of_clip(json.loads(files[MotionFormat.JSON].read_bytes()))
    if modules is None:
        print("three.js left out: needs --node-modules")
        return
    asked = [str(files[form]) for form in BY_THREE if form in files]
    script = Path(__file__).with_name("formats.mjs")
    command = ["node", str(script), str(modules.resolve()), str(RATE_HZ), *asked]
    said = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    for form, told in said.items():
        rig, unit_m = (names, 0.01) if form == MotionFormat.BVH else ({name: name for name in skeleton.names}, 1.0)
        yield form, unit_m * np.stack([np.array(told["joints"][rig[name]]) for name in skeleton.names], axis=1)


def _of_usd(path: Path) -> FloatArray:
    stage = Usd.Stage.Open(str(path))
    cache = UsdSkel.Cache()
    cache.Populate(UsdSkel.Root(stage.GetDefaultPrim()), Usd.PrimDefaultPredicate)
    query = cache.GetSkelQuery(UsdSkel.Skeleton(stage.GetDefaultPrim().GetChild("Skeleton")))
    frames = range(0, int(stage.GetEndTimeCode()) + 1, STEP)
    places = [[list(one.ExtractTranslation()) for one in query.ComputeJointSkelTransforms(k)] for k in frames]
    return np.array(places)


def _of_clip(clip: Mapping[str, Any]) -> FloatArray:
    """By SciPy's rotations, not by our kinematics."""
    joints = clip["skeleton"]["joints"]
    places: dict[str, FloatArray] = {}
    turns: dict[str, Rotation] = {}
    for joint in joints:
        name, parent = joint["name"], joint["parent"]
        local = Rotation.from_quat(np.array(clip["bones"][name])[::STEP])
        if parent is None:
            places[name], turns[name] = np.array(clip["hips_m"])[::STEP], local
        else:
            places[name] = places[parent] + turns[parent].apply(np.array(joint["offset_m"]))
            turns[name] = turns[parent] * local
    return np.stack([places[joint["name"]] for joint in joints], axis=1)


def _decode(realized: RealizedSchedule, files: Mapping[MotionFormat, Path], skeleton: Skeleton) -> None:
    """What a reader of body parameters makes of the joints, all frames: how far they are turned from ours."""
    joints = Body(read_parameters(files[MotionFormat.BAP].read_bytes())).joints()
    turns = {name: Rotation.from_quat(realized.motion.body.rotations[:, k]) for name, k in skeleton.index.items()}
    pairs = zip(*(world(each, skeleton.names, skeleton.parents) for each in (turns, joints)), strict=True)
    worst = {
        name: float((Rotation.from_matrix(mine) * Rotation.from_matrix(read).inv()).magnitude().max())
        for name, (mine, read) in zip(skeleton.names, pairs, strict=True)
        if not name.endswith("Eye")
    }
    collars = max(worst.pop(f"{side}Shoulder") for side in ("left", "right"))
    print(f".bap: joints in the world at most {max(worst.values()):.5f} rad from ours, collar bones {collars:.4f} rad")


def _validate(files: Mapping[MotionFormat, Path]) -> None:
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    for form in SCENES:
        found = UsdValidation.ValidationContext(validators).Validate(Usd.Stage.Open(str(files[form])))
        print(f"{form}: {len(found)} errors of {len(validators)} validators, {os.path.getsize(files[form])} bytes")


def _tell_fbx(files: Mapping[MotionFormat, Path]) -> None:
    if MotionFormat.FBX not in files or find_spec("ufbx") is None:
        return
    import ufbx

    scene = ufbx.load_file(str(files[MotionFormat.FBX]))
    (stack,) = scene.anim_stacks
    told = scene.settings
    print(f".fbx: {told.unit_meters} m a unit, {told.axes}, {told.frames_per_second} frames a second")
    print(f".fbx: from {stack.time_begin:.4f} to {stack.time_end:.4f} s, {len(scene.bones)} bones")


if __name__ == "__main__":
    main()
