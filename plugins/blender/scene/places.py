"""Where things are as the performer sees them: Understudy's metres, the character at the origin facing +Z."""

import re
from collections.abc import Mapping
from typing import Any

import numpy as np
from mathutils import Vector

from ..retargeting.armature import character_axes, metre
from ..retargeting.matching import BoneMap
from .armatures import NoHumanoidError, bones_of, rest_of

_NOT_IN_NAMES = re.compile(r"[^A-Za-z0-9_]+")


def target_name(name: str) -> str:
    """An object's name as a target can be called: letters, digits and _, a letter first."""
    plain = _NOT_IN_NAMES.sub("_", re.sub(r"\.\d{3}$", "", name)).strip("_")[:64]
    return plain if plain[:1].isalpha() else f"thing_{plain}"[:64]


def place_m(armature: Any, found: BoneMap, thing: Any) -> tuple[float, float, float]:
    """Where an object is for the character on an armature: of another character its eyes, else its origin.

    Lengths are divided by the character's size, so that a giant sees a door as low as it is to it.
    """
    rest = rest_of(armature, found)
    axes, size = character_axes(rest), metre(rest)
    inside = np.array(armature.matrix_world.inverted() @ _seen_at(thing))
    x, y, z = (axes.T @ inside) / size
    return round(float(x), 4), round(float(y), 4), round(float(z), 4)


def places_m(armature: Any, found: BoneMap, things: Mapping[str, Any]) -> dict[str, tuple[float, float, float]]:
    """The places of several things by their names as targets."""
    return {name: place_m(armature, found, thing) for name, thing in things.items()}


def _seen_at(thing: Any) -> Vector:
    """The point of an object that is looked at, in the world."""
    if thing.type == "ARMATURE":
        try:
            head = thing.pose.bones[bones_of(thing).bones["head"]]
        except NoHumanoidError:
            return thing.matrix_world.translation
        return thing.matrix_world @ (head.head * 0.3 + head.tail * 0.7)
    if thing.type == "MESH":
        corners = [thing.matrix_world @ Vector(corner) for corner in thing.bound_box]
        return sum(corners, Vector()) / len(corners)
    return thing.matrix_world.translation
