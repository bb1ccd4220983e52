"""Whether any avatar, however broken, is either refused with a typed error or animated with finite motion.

    python -m benchmarks.realizer.exporting.avatar_mutants [AVATAR …] [--count N] [--seed N]

Each mutant is the avatar's file with one to three changes: in its JSON a value at a random place is replaced by one of
`VALUES`, deleted, doubled, or replaced by a copy of another; or bytes of the file are changed, or it is cut short. Half
of the places are among the parts that are read. A small avatar of ours is mutated, and those named (default: those of
../shared). Told are how many were refused by which code, how many worn, and every untyped error (bar: none).
"""

import argparse
import json
import random
import struct
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from pathlib import Path
from typing import Any

import numpy as np

from understudy.errors import UnderstudyError
from understudy.files import resource_folder
from understudy.realizer.avatars.avatar import to_avatar_glb
from understudy.realizer.body.motion import SHAPES, BodyMotion, Motion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.exporting.gltf import Accessors, joint_nodes, to_glb_bytes
from understudy.realizer.exporting.retargeting import Rig, load_rigs
from understudy.realizer.geometry.rotations import IDENTITY

AVATARS = Path(__file__).resolve().parents[4] / "shared" / "data" / "motion" / "avatar"
READ = ("nodes", "nodes", "nodes", "buffers", "bufferViews", "accessors", "meshes", "extensions", "asset")
VALUES: tuple[Any, ...] = (
    *(None, True, {}, [], "", "x", "\ud800", [[]], {"node": 0}, {"": []}),
    *(0, 1, -1, 2.7, 1e-30, 1e7, 1e38, 1e308, 10**30, -(10**400), float("nan"), float("inf"), 2**31, 2**53),
    *([0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1e-9], [1e6, 1e6, 1e6], [float("nan")] * 4, [0.0] * 16, [1e6] * 16, [0, 1]),
)

Tree = dict[str, Any]


def small_avatar() -> bytes:
    """Our joints, a face, and VRM 1.0's table of bones."""
    skeleton, accessors, corners = Skeleton.standing(), Accessors(), np.eye(3)
    primitive = {
        "attributes": {"POSITION": accessors.floats(corners, bounds=True)},
        "targets": [{"POSITION": accessors.displacements(corners)}],
    }
    tree: Tree = {
        "nodes": [*joint_nodes(skeleton), {"name": "Face", "mesh": 0, "matrix": np.eye(4).reshape(-1).tolist()}],
        "meshes": [{"primitives": [primitive], "extras": {"targetNames": ["jawOpen"]}}],
        "extensions": {
            "VRMC_vrm": {"humanoid": {"humanBones": {name: {"node": at} for name, at in skeleton.index.items()}}}
        },
    }
    return to_glb_bytes(tree, accessors)


def mutants(content: bytes, count: int, seed: int) -> Iterator[bytes]:
    """So many mutants of a GLB or VRM file."""
    rng = random.Random(seed)
    size = struct.unpack_from("<I", content, 12)[0]
    text, rest = content[20 : 20 + size], content[20 + size :]
    for _ in range(count):
        if rng.random() < 0.05:
            yield _bytes_changed(content, rng)
            continue
        tree = json.loads(text)
        for _ in range(rng.randint(1, 3)):
            _change(tree, rng)
        changed = json.dumps(tree).encode()
        changed += b" " * (-len(changed) % 4)
        yield (
            struct.pack("<4sIIII", b"glTF", 2, 20 + len(changed) + len(rest), len(changed), 0x4E4F534A) + changed + rest
        )


def _bytes_changed(content: bytes, rng: random.Random) -> bytes:
    if rng.random() < 0.3:
        return content[: rng.randrange(len(content))]
    changed = bytearray(content)
    for _ in range(rng.randint(1, 8)):
        changed[rng.randrange(min(len(changed), 4000))] = rng.randrange(256)
    return bytes(changed)


def _change(tree: Tree, rng: random.Random) -> None:
    """Change one value somewhere in the tree."""
    inside, key = _place(tree, rng)
    action = rng.random()
    if action < 0.7:
        inside[key] = deepcopy(rng.choice(VALUES))
    elif action < 0.8:
        del inside[key]
    elif action < 0.9 and isinstance(inside, list):
        inside.insert(key, deepcopy(inside[key]))
    else:
        other, there = _place(tree, rng)
        inside[key] = deepcopy(other[there])


def _place(tree: Tree, rng: random.Random) -> tuple[Any, Any]:
    """A random place, however deep, as the object or array it is in and its key there."""
    read = [key for key in READ if key in tree]
    inside: Any = tree
    key: Any = rng.choice(read) if read and rng.random() < 0.5 else rng.choice(list(tree) or ["nodes"])
    tree.setdefault("nodes", [])
    while isinstance(inside[key], (dict, list)) and inside[key] and rng.random() < 0.85:
        inside = inside[key]
        key = rng.choice(list(inside)) if isinstance(inside, dict) else rng.randrange(len(inside))
    return inside, key


def outcome(content: bytes, motion: Motion, skeleton: Skeleton, rigs: Mapping[str, Rig]) -> str:
    """The code of the error that refuses the mutant, `worn`, or the untyped error."""
    try:
        finite = all_finite(to_avatar_glb(motion, skeleton, content, rigs))
    except UnderstudyError as error:
        error.message.encode()
        return error.code
    except Exception as error:  # noqa: BLE001  any error is what is looked for
        return f"untyped {type(error).__name__}: {error}"[:160]
    return "worn" if finite else "untyped: not finite"


def all_finite(worn: bytes) -> bool:
    """Whether the file's JSON is valid and every track of its animation finite."""
    size = struct.unpack_from("<I", worn, 12)[0]
    tree = json.loads(worn[20 : 20 + size], parse_constant=_refused)
    buffer = worn[28 + size :]
    for sampler in tree["animations"][0]["samplers"]:
        view = tree["bufferViews"][tree["accessors"][sampler["output"]]["bufferView"]]
        values = np.frombuffer(buffer, "<f4", view["byteLength"] // 4, view["byteOffset"])
        if not np.isfinite(values).all():
            return False
    return True


def _refused(constant: str) -> float:
    raise ValueError(f"{constant} is not JSON")


def short_motion(skeleton: Skeleton) -> Motion:
    """Two frames."""
    rotations = np.tile(IDENTITY, (2, len(skeleton.names), 1))
    rotations[1, skeleton.index["head"]] = (0.1, 0.0, 0.0, 0.995)
    body = BodyMotion(np.arange(2) / 30, rotations, np.tile(skeleton.offsets_m[0], (2, 1)))
    return Motion(30, body, np.full((2, len(SHAPES)), 0.1), {})


def report(name: str, content: bytes, count: int, seed: int) -> int:
    """Prints the outcomes of the mutants of one file; how many were untyped."""
    skeleton = Skeleton.standing()
    motion, rigs = short_motion(skeleton), load_rigs(resource_folder("lexicon") / "retarget", skeleton)
    found = Counter(outcome(mutant, motion, skeleton, rigs) for mutant in mutants(content, count, seed))
    untyped = sum(number for told, number in found.items() if told.startswith("untyped"))
    told = ", ".join(f"{each} {number}" for each, number in found.most_common())
    print(f"{name}: {count} mutants, {untyped} untyped errors: {told}")
    return untyped


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("avatars", metavar="AVATAR", nargs="*", type=Path)
    arguments.add_argument("--count", type=int, default=2000)
    arguments.add_argument("--seed", type=int, default=0)
    options = arguments.parse_args()
    paths: Sequence[Path] = options.avatars or sorted(AVATARS.glob("cc0_avatar.*"))
    np.seterr(all="raise", under="ignore")
    untyped = report("small", small_avatar(), options.count, options.seed)
    untyped += sum(report(path.name, path.read_bytes(), options.count, options.seed) for path in paths)
    sys.exit(1 if untyped else 0)


if __name__ == "__main__":
    main()
