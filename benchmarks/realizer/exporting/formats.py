"""Reading of our motion files by other programs, and time and size of files with ten minutes of motion.

    python -m benchmarks.realizer.exporting.formats --node-modules FOLDER

FOLDER is where `npm install gltf-validator three` put its packages; without it, or without node, the first part is left
out. The motion is made by hand (`tests/support/motion/hand_made_motion.py`) with every joint and shape shaken a little,
so that every track has all its keys. "Apart" is the greatest distance between where three.js's readers of GLB and BVH
put a joint, and where our own forward kinematics does; three.js needs BVH with its root at the origin. Times are
processor time on one core, "memory" is what the export adds to the process at its peak, the file itself included; files
are those of 10 minutes at 60 frames a second.
"""

import argparse
import json
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping
from multiprocessing import get_context
from pathlib import Path
from resource import RUSAGE_SELF, getrusage

import numpy as np

from tests.support.motion.hand_made_motion import BODY, waving
from understudy.model import FloatArray
from understudy.model.figure import PLAIN, Looks
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.exporting.bvh import to_bvh
from understudy.realizer.exporting.clip_json import to_clip_json
from understudy.realizer.exporting.face_lists import to_arkit_csv
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.exporting.retargeting import Rig, load_rigs
from understudy.realizer.exporting.vrma import to_vrma
from understudy.realizer.geometry.rotations import normalized

RETARGET = Path(__file__).parents[3] / "lexicon" / "retarget"
SHORT_S, LONG_S = 4.0, 600.0
RATE_HZ = 60
STEP = 7
"""As in formats.mjs: positions are compared in every seventh frame."""

Export = Callable[[Motion, Skeleton, Mapping[str, Rig]], bytes]
EXPORTS: Mapping[str, Export] = {
    ".bvh": lambda motion, skeleton, rigs: to_bvh(motion, skeleton, rigs["mixamo"], root_at_origin=True),
    ".glb": lambda motion, skeleton, _rigs: to_glb(motion, skeleton),
    ".vrma": lambda motion, skeleton, _rigs: to_vrma(motion, skeleton),
    ".json": lambda motion, skeleton, rigs: to_clip_json(motion, skeleton, rigs["vrm"]),
    ".csv": lambda motion, skeleton, _rigs: to_arkit_csv(motion, skeleton),
}


def main() -> None:
    parser = argparse.ArgumentParser(description="What other programs make of our motion files.")
    parser.add_argument("--node-modules", type=Path, help="where gltf-validator and three are")
    given = parser.parse_args()
    rigs = load_rigs(RETARGET, BODY)
    if given.node_modules is None or shutil.which("node") is None:
        print("validator and three.js left out: needs node and --node-modules (npm install gltf-validator three)")
    else:
        judge(given.node_modules.resolve(), rigs, BODY)
    weigh()


def judge(modules: Path, rigs: Mapping[str, Rig], skeleton: Skeleton, looks: Looks = PLAIN.looks) -> None:
    """Prints what the validator and three.js say of a short motion of a body."""
    motion = shaken(SHORT_S)
    ours, _turns = forward(skeleton, motion.body.rotations[::STEP], motion.body.hips_m[::STEP])
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(folder) / f"motion{ending}" for ending in (".glb", ".vrma", ".bvh")]
        for file in files:
            glb = file.suffix == ".glb"
            file.write_bytes(to_glb(motion, skeleton, looks) if glb else EXPORTS[file.suffix](motion, skeleton, rigs))
        script = Path(__file__).with_suffix(".mjs")
        command = ["node", str(script), str(modules), str(RATE_HZ), *map(str, files)]
        found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    for ending in (".glb", ".vrma"):
        said = found[ending]
        print(f"{ending}  errors {said['errors']}  warnings {said['warnings']}  {' '.join(said['codes'])}")
    of_glb = _positions(found[".glb"]["joints"], rigs["vrm"])
    of_bvh = _positions(found[".bvh"]["joints"], rigs["mixamo"]) / 100
    frames = min(len(of_glb), len(of_bvh), len(ours))
    pairs = (("GLB and ours", of_glb, ours), ("BVH and ours", of_bvh, ours), ("GLB and BVH", of_glb, of_bvh))
    for name, first, second in pairs:
        apart_mm = 1000 * np.linalg.norm(first[:frames] - second[:frames], axis=-1).max()
        print(f"{name}: {apart_mm:.4f} mm apart in {frames} frames of {of_glb.shape[1]} joints")


def weigh() -> None:
    """Prints time, memory and size of each format, each in a process of its own."""
    print(f"{LONG_S:.0f} s at {RATE_HZ} frames a second")
    for ending in EXPORTS:
        with get_context("spawn").Pool(1) as pool:
            seconds, memory_mb, size_mb = pool.apply(weighed, (ending,))
        print(f"{ending:6} {seconds:5.1f} s  {memory_mb:5.0f} MB memory  {size_mb:5.1f} MB")


def weighed(ending: str) -> tuple[float, float, float]:
    """Seconds, megabytes of memory added, megabytes of file."""
    motion, rigs = shaken(LONG_S), load_rigs(RETARGET, BODY)
    before = getrusage(RUSAGE_SELF).ru_maxrss
    start_s = time.process_time()
    content = EXPORTS[ending](motion, BODY, rigs)
    seconds = time.process_time() - start_s
    return seconds, (getrusage(RUSAGE_SELF).ru_maxrss - before) / 1024, len(content) / 1e6


def shaken(duration_s: float) -> Motion:
    """The motion made by hand, with noise on every joint and shape."""
    motion = waving(duration_s, RATE_HZ)
    noise = np.random.default_rng(0)
    for joint in range(motion.body.rotations.shape[1]):
        turns = motion.body.rotations[:, joint]
        turns[:] = normalized(turns + noise.normal(0, 0.002, turns.shape))
    motion.shapes[:] = np.clip(motion.shapes + noise.uniform(0, 0.01, motion.shapes.shape), 0, 1)
    return motion


def _positions(joints: Mapping[str, list[list[float]]], rig: Rig) -> FloatArray:
    """(frames, J, 3), in the skeleton's order."""
    return np.stack([np.array(joints[name]) for name in rig.names.values()], axis=1)


if __name__ == "__main__":
    main()
