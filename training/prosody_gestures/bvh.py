"""Reads joints' rotations from Biovision BVH text."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from understudy.errors import InputError
from understudy.model import FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Rotations:
    """Euler angles in radians (frames × joints × 3, in the order of the file's channels), without jumps of a whole
    turn, and the time between frames."""

    joints: tuple[str, ...]
    angles: FloatArray
    frame_s: float


def read_rotations(path: Path, joints: Sequence[str]) -> Rotations:
    """The rotations of some joints. Raises InputError `bvh_wrong` where the file has not all of them."""
    head, separator, motion = path.read_text(encoding="utf-8", errors="replace").partition("MOTION")
    columns = dict(_rotation_columns(head))
    missing = [joint for joint in joints if len(columns.get(joint, ())) != 3]
    if not separator or missing:
        has = ", ".join(columns) or "no joints"
        raise InputError("bvh_wrong", f"{path}: no rotations of {', '.join(missing) or 'any frame'}; it has {has}")
    lines = motion.split("\n")
    start = next((place for place, line in enumerate(lines) if line.strip().startswith("Frame Time")), None)
    if start is None:
        raise InputError("bvh_wrong", f"{path}: no line 'Frame Time: SECONDS' after MOTION")
    values = np.array("\n".join(lines[start + 1 :]).split(), dtype=np.float64)
    width = sum(int(line.split()[1]) for line in head.split("\n") if line.strip().startswith("CHANNELS"))
    frames = values[: len(values) // width * width].reshape(-1, width)
    chosen = np.stack([frames[:, columns[joint]] for joint in joints], axis=1)
    return Rotations(tuple(joints), np.unwrap(np.radians(chosen), axis=0), float(lines[start].split(":")[1]))


def _rotation_columns(head: str) -> Iterator[tuple[str, list[int]]]:
    """The columns of each joint's three rotations."""
    joint, column = "", 0
    for words in map(str.split, head.split("\n")):
        if words[:1] in (["ROOT"], ["JOINT"]):
            joint = words[-1]
        elif words[:1] == ["CHANNELS"]:
            yield joint, [column + place for place, name in enumerate(words[2:]) if name.endswith("rotation")]
            column += int(words[1])
