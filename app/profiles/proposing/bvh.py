"""Where the wrists are in a BVH file, beside the hips: what phases are found by.

Conventions: metres, Y up; positions are in the frame of the root, so that walking and turning move nobody's hands. A
file in centimetres is known by the length of its skeleton. Joints are known by their names, whatever the rig.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ...model import FloatArray
from ..annotation.mistakes import AnnotationError, AnnotationMistake

WRISTS = {
    "left": re.compile(r"(l|left)[_.]?(wrist|hand)|(wrist|hand)[_.]?(l|left)"),
    "right": re.compile(r"(r|right)[_.]?(wrist|hand)|(wrist|hand)[_.]?(r|right)"),
}
"""The names of the wrists without what stands before a colon, in small letters."""

TALLEST_M = 4.0
"""A skeleton whose bones are longer together is in centimetres."""
CENTIMETRE_M = 0.01
MOST_FRAMES = 200_000


@dataclass(frozen=True, slots=True)
class WristPaths:
    """The wrists' positions (T, 3) from the root, and the frames a second."""

    frame_rate_hz: float
    left_m: FloatArray
    right_m: FloatArray


@dataclass(slots=True)
class _Joint:
    name: str
    offset: FloatArray
    parent: int
    channels: list[str] = field(default_factory=list)
    first: int = 0


def read_wrists(content: bytes, path: Path) -> WristPaths:
    """The wrists of a file; raises AnnotationError for what is no BVH, or has no wrists that we know."""
    try:
        head, _, motion = content.decode("utf-8", "replace").partition("MOTION")
        joints = list(_joints(head.split()))
        rate_hz, frames = _frames(motion, sum(len(joint.channels) for joint in joints))
    except (ValueError, IndexError) as error:
        raise AnnotationError([AnnotationMistake(path, f"not a BVH that can be read: {error}")]) from None
    places = [_place(joints, side, path) for side in ("left", "right")]
    scale = CENTIMETRE_M if sum(float(np.abs(joint.offset).max()) for joint in joints[1:]) > TALLEST_M else 1.0
    left, right = (scale * _path(joints, place, frames) for place in places)
    return WristPaths(rate_hz, left, right)


def _joints(words: Sequence[str]) -> Iterator[_Joint]:
    """The joints in order, end sites left out."""
    if "HIERARCHY" not in words[:1]:
        raise ValueError("it does not begin with HIERARCHY")
    stack: list[int] = []
    number, first, place, made = -1, 0, 1, None
    while place < len(words):
        word = words[place]
        if word in ("ROOT", "JOINT"):
            number += 1
            made = _Joint(words[place + 1], np.zeros(3), stack[-1] if stack else -1)
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
            count = int(words[place + 1])
            assert made is not None, "end sites have no channels"
            made.channels, made.first = list(words[place + 2 : place + 2 + count]), first
            first += count
            place += count + 1
            yield made
        place += 1


def _frames(motion: str, channels: int) -> tuple[float, FloatArray]:
    found = re.search(r"Frames:\s*(\d+)\s*Frame Time:\s*([\d.eE+-]+)", motion)
    if found is None:
        raise ValueError("MOTION says no frames")
    number, frame_s = int(found[1]), float(found[2])
    if not 0 < number <= MOST_FRAMES or frame_s <= 0:
        raise ValueError(f"{number} frames of {frame_s:g} s")
    values = np.array(motion[found.end() :].split(), float)
    return 1 / frame_s, values[: number * channels].reshape(number, channels)


def _place(joints: Sequence[_Joint], side: str, path: Path) -> int:
    for place, joint in enumerate(joints):
        if WRISTS[side].fullmatch(joint.name.rpartition(":")[2].lower().removeprefix("b_")):
            return place
    names = ", ".join(joint.name for joint in joints[:60])
    raise AnnotationError([AnnotationMistake(path, f"no joint is called {side} hand or wrist; there are {names}")])


def _path(joints: Sequence[_Joint], place: int, frames: FloatArray) -> FloatArray:
    """The positions (T, 3) of a joint in the frame of the root."""
    position = np.zeros((len(frames), 3))
    while joints[place].parent >= 0:
        joint = joints[place]
        position = position + joint.offset
        place = joint.parent
        if joints[place].parent >= 0:
            position = np.einsum("tij,tj->ti", _rotations(joints[place], frames), position)
    return position


def _rotations(joint: _Joint, frames: FloatArray) -> FloatArray:
    """The rotation matrices (T, 3, 3) of a joint, its channels in their order."""
    matrices = np.broadcast_to(np.eye(3), (len(frames), 3, 3))
    for number, channel in enumerate(joint.channels):
        if channel.endswith("rotation"):
            angles = np.radians(frames[:, joint.first + number])
            matrices = matrices @ _about("XYZ".index(channel[0]), angles)
    return matrices


def _about(axis: int, angles: FloatArray) -> FloatArray:
    one, other = (axis + 1) % 3, (axis + 2) % 3
    matrices = np.zeros((len(angles), 3, 3))
    matrices[:, axis, axis] = 1
    matrices[:, one, one] = matrices[:, other, other] = np.cos(angles)
    matrices[:, one, other], matrices[:, other, one] = -np.sin(angles), np.sin(angles)
    return matrices
