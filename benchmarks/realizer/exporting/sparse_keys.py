"""Size of sparse keys, and the deviation of their interpolation from every frame of the motion.

    python -m benchmarks.realizer.exporting.sparse_keys [--lines FOLDER]

The motions are those of recorded lines (default: ../shared/data/speech/lines), 60 frames a second. The GLB with
`--keys sparse` is read back, each track interpolated as players do (slerp; linear), and the joints placed by forward
kinematics. "Bytes" are those of the animation alone, without the mannequin.
"""

import argparse
from pathlib import Path

import numpy as np

from benchmarks.realizer.motion import LINES, of_lines
from tests.support.motion.gltf_reading import Gltf, read
from understudy.files import resource_folder
from understudy.model import FloatArray
from understudy.realization import Realizer, realize, schedule_of
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.geometry.rotations import angle_between, slerp

JOINTS = ("head", "rightHand", "leftHand", "rightIndexDistal", "leftIndexDistal")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--lines", type=Path, default=LINES)
    options = arguments.parse_args()
    realizer = Realizer.load(resource_folder("lexicon"))
    for performance in of_lines(options.lines, "default"):
        schedule = schedule_of(performance)
        motion = realize(realizer, schedule)
        files = [
            read(to_glb(motion, realizer.skeleton, sparse_for=behaviors)) for behaviors in (None, schedule.behaviors)
        ]
        report(motion, realizer.skeleton, *files)


def report(motion: Motion, skeleton: Skeleton, baked: Gltf, sparse: Gltf) -> None:
    """Prints a line for a motion."""
    sizes, counts = zip(*(size_of(each) for each in (baked, sparse)), strict=True)
    played, hips_m = played_by(sparse, motion, skeleton)
    turned = np.degrees(angle_between(played, motion.body.rotations).max())
    places_m = [
        forward(skeleton, rotations, place)[0]
        for rotations, place in ((played, hips_m), (motion.body.rotations, motion.body.hips_m))
    ]
    apart_mm = 1000 * np.linalg.norm(places_m[0] - places_m[1], axis=-1)
    joints = ", ".join(f"{name} {apart_mm[:, skeleton.index[name]].max():.1f}" for name in JOINTS)
    print(
        f"{motion.duration_s:5.1f} s: keys {counts[0]} to {counts[1]} ({counts[0] / counts[1]:.1f} ×), "
        f"bytes {sizes[0]} to {sizes[1]} ({sizes[0] / sizes[1]:.1f} ×); at most {turned:.2f}°, mm: {joints}"
    )


def size_of(file: Gltf) -> tuple[int, int]:
    """The bytes of the animations' arrays, and the number of their keys."""
    samplers = [sampler for animation in file.tree["animations"] for sampler in animation["samplers"]]
    arrays = {sampler[end] for sampler in samplers for end in ("input", "output")}
    views = {file.tree["accessors"][number]["bufferView"] for number in arrays}
    size = sum(file.tree["bufferViews"][view]["byteLength"] for view in views)
    return size, sum(file.tree["accessors"][sampler["input"]]["count"] for sampler in samplers)


def played_by(file: Gltf, motion: Motion, skeleton: Skeleton) -> tuple[FloatArray, FloatArray]:
    """The joints' rotations (T, J, 4) and the hips' places (T, 3) in every frame."""
    times_s = motion.body.times_s - motion.body.times_s[0]
    rotations, hips_m = np.empty_like(motion.body.rotations), np.empty_like(motion.body.hips_m)
    for animation in file.tree["animations"]:
        alone = Gltf(file.tree | {"animations": [animation]}, file.buffer)
        for channel in animation["channels"]:
            name, path = file.tree["nodes"][channel["target"]["node"]]["name"], channel["target"]["path"]
            if path == "weights":
                continue
            at_s, keys = alone.track(name, path)
            if path == "translation":
                hips_m[:] = np.stack([np.interp(times_s, at_s, keys[:, axis]) for axis in range(3)], axis=1)
            else:
                rotations[:, skeleton.index[name]] = interpolated(times_s, at_s, keys.astype(np.float64))
    return rotations, hips_m


def interpolated(times_s: FloatArray, at_s: FloatArray, keys: FloatArray) -> FloatArray:
    """The rotations (T, 4) along the shorter arc between the keys (K, 4)."""
    if len(keys) == 1:
        return np.tile(keys, (len(times_s), 1))
    before = np.clip(np.searchsorted(at_s, times_s, side="right") - 1, 0, len(keys) - 2)
    share = np.clip((times_s - at_s[before]) / np.diff(at_s)[before], 0.0, 1.0)
    return slerp(keys[before], keys[before + 1], share)


if __name__ == "__main__":
    main()
