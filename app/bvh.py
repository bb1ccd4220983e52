"""Reads Biovision BVH text: a skeleton and its motion.

Conventions: a joint's rotation is the product of its rotation channels in their order, about axes that are fixed in its
parent's frame when all rotations are zero; offsets are in the file's own unit. End sites have no channels and are left
out.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from .errors import InputError
from .model import FloatArray

MOST_FRAMES = 200_000


@dataclass(slots=True)
class BvhJoint:
    """A joint: its `parent`'s place among the joints (-1 for the root), its `offset` from it (3,), and its channels,
    the first of which is column `first` of the motion."""

    name: str
    offset: FloatArray
    parent: int
    channels: list[str] = field(default_factory=list)
    first: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Bvh:
    """The joints, parents before their children; `values` (T, channels) as they stand in the file, `frame_s` seconds
    apart."""

    joints: tuple[BvhJoint, ...]
    values: FloatArray
    frame_s: float

    def rotations(self, place: int) -> FloatArray:
        """The local rotation matrices (T, 3, 3) of the joint at this place."""
        joint = self.joints[place]
        matrices = np.broadcast_to(np.eye(3), (len(self.values), 3, 3))
        for number, channel in enumerate(joint.channels):
            if channel.endswith("rotation"):
                angles = np.radians(self.values[:, joint.first + number])
                matrices = matrices @ _about("XYZ".index(channel[0]), angles)
        return matrices


def read_bvh(content: bytes, name: str) -> Bvh:
    """The skeleton and the motion of a file called `name`. Raises InputError `bvh_wrong`."""
    try:
        head, _, motion = content.decode("utf-8", "replace").partition("MOTION")
        joints = tuple(_joints(head.split()))
        frame_s, values = _frames(motion, sum(len(joint.channels) for joint in joints))
    except (ValueError, IndexError) as error:
        raise InputError("bvh_wrong", f"{name}: not a BVH that can be read: {error}") from None
    if not np.isfinite(values).all():
        raise InputError("bvh_wrong", f"{name}: a value of its motion is not a finite number")
    return Bvh(joints, values, frame_s)


def _joints(words: Sequence[str]) -> Iterator[BvhJoint]:
    """The joints in order, without end sites."""
    if "HIERARCHY" not in words[:1]:
        raise ValueError("it does not begin with HIERARCHY")
    stack: list[int] = []
    number, first, place, made = -1, 0, 1, None
    while place < len(words):
        word = words[place]
        if word in ("ROOT", "JOINT"):
            number += 1
            made = BvhJoint(words[place + 1], np.zeros(3), stack[-1] if stack else -1)
            place += 1
        elif word == "End":
            made = None
            place += 1
        elif word == "{":
            stack.append(number if made is not None else -2)
        elif word == "}":
            stack.pop()
        elif word == "OFFSET":
            if made is not None:
                made.offset = np.array([float(each) for each in words[place + 1 : place + 4]])
            place += 3
        elif word == "CHANNELS":
            made = _with_channels(made, words[place + 1 :], first)
            first += len(made.channels)
            place += len(made.channels) + 1
            yield made
        place += 1


def _with_channels(joint: BvhJoint | None, words: Sequence[str], first: int) -> BvhJoint:
    if joint is None:
        raise ValueError("an end site has channels")
    joint.channels, joint.first = list(words[1 : 1 + int(words[0])]), first
    return joint


def _frames(motion: str, channels: int) -> tuple[float, FloatArray]:
    found = re.search(r"Frames:\s*(\d+)\s*Frame Time:\s*([\d.eE+-]+)", motion)
    if found is None:
        raise ValueError("MOTION has no lines 'Frames: NUMBER' and 'Frame Time: SECONDS'")
    number, frame_s = int(found[1]), float(found[2])
    if not 0 < number <= MOST_FRAMES or frame_s <= 0:
        raise ValueError(f"{number} frames of {frame_s:g} s")
    values = np.array(motion[found.end() :].split(), float)
    if len(values) < number * channels:
        raise ValueError(f"{number} frames of {channels} values are announced; there are {len(values)} values")
    return frame_s, values[: number * channels].reshape(number, channels)


def _about(axis: int, angles: FloatArray) -> FloatArray:
    one, other = (axis + 1) % 3, (axis + 2) % 3
    matrices = np.zeros((len(angles), 3, 3))
    matrices[:, axis, axis] = 1
    matrices[:, one, one] = matrices[:, other, other] = np.cos(angles)
    matrices[:, one, other], matrices[:, other, one] = -np.sin(angles), np.sin(angles)
    return matrices
