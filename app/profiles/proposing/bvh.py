"""Where the wrists are in a BVH file, beside the hips: what phases are found by.

Conventions: metres, Y up; positions are in the frame of the root, so that walking and turning move nobody's hands. A
file in centimetres is known by the length of its skeleton. Joints are known by their names, whatever the rig.
"""

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...bvh import Bvh, read_bvh
from ...errors import InputError
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


@dataclass(frozen=True, slots=True)
class WristPaths:
    """The wrists' positions (T, 3) from the root, and the frames a second."""

    frame_rate_hz: float
    left_m: FloatArray
    right_m: FloatArray


def read_wrists(content: bytes, path: Path) -> WristPaths:
    """The wrists of a file; raises AnnotationError for a file that is not BVH or has no known wrists."""
    try:
        bvh = read_bvh(content, "it")
    except InputError as error:
        raise AnnotationError([AnnotationMistake(path, error.message.removeprefix("it: "))]) from None
    places = [_place(bvh, side, path) for side in ("left", "right")]
    long = sum(float(np.abs(joint.offset).max()) for joint in bvh.joints[1:]) > TALLEST_M
    left, right = ((CENTIMETRE_M if long else 1.0) * _path(bvh, place) for place in places)
    return WristPaths(1 / bvh.frame_s, left, right)


def _place(bvh: Bvh, side: str, path: Path) -> int:
    for place, joint in enumerate(bvh.joints):
        if WRISTS[side].fullmatch(joint.name.rpartition(":")[2].lower().removeprefix("b_")):
            return place
    names = ", ".join(joint.name for joint in bvh.joints[:60])
    raise AnnotationError([AnnotationMistake(path, f"no joint is called {side} hand or wrist; there are {names}")])


def _path(bvh: Bvh, place: int) -> FloatArray:
    """The positions (T, 3) of a joint in the frame of the root."""
    position = np.zeros((len(bvh.values), 3))
    while bvh.joints[place].parent >= 0:
        position = position + bvh.joints[place].offset
        place = bvh.joints[place].parent
        if bvh.joints[place].parent >= 0:
            position = np.einsum("tij,tj->ti", bvh.rotations(place), position)
    return position
