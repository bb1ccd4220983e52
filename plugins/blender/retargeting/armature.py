"""An armature at rest, as retargeting needs it, and where its character's left, up and front are.

Conventions: places and axes are in the armature's own space and unit. A bone's rest rotation has the bone's axes as
columns, as in Blender (`Bone.matrix_local`).
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..motion.rotations import Array

AVERAGE_LEG_M, AVERAGE_HIPS_M = 0.8312, 0.95
"""Of Understudy's average character, from hip to ankle, and from the floor to the hips (docs/motion-formats.md)."""
_NEARLY_RAD = np.radians(20)


@dataclass(frozen=True, slots=True, eq=False)
class RestBone:
    """A bone at rest: its parent's name (empty: none), its head (3), its axes (3, 3), and how it goes by its parent."""

    name: str
    parent: str
    head: Array
    rotation: Array
    inherits_rotation: bool = True
    local_location: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class Armature:
    """Bones by name, parents before their children, and those that are our joints."""

    bones: Mapping[str, RestBone]
    joints: Mapping[str, str]

    def head_of(self, joint: str) -> Array:
        """Where the bone of a joint begins."""
        return self.bones[self.joints[joint]].head

    def has(self, *joints: str) -> bool:
        """Whether all these joints were found."""
        return all(joint in self.joints for joint in joints)


def character_axes(armature: Armature) -> Array:
    """The character's left, up and front as columns (3, 3): our X, Y and Z axes in the armature's space.

    They are read from where arms and head are; where they nearly are axes of the armature, they are these. So it does
    not matter whether an armature has Y or Z up, and which way it faces.
    """
    up = _straight(armature.head_of("head") - armature.head_of("hips"))
    left = _straight(armature.head_of("leftUpperArm") - armature.head_of("rightUpperArm"))
    front = np.cross(left, up)
    front /= np.linalg.norm(front)
    return np.stack([np.cross(up, front), up, front], axis=1)


def _straight(direction: Array) -> Array:
    """The direction (3), or the armature's axis that it nearly is."""
    direction = direction / np.linalg.norm(direction)
    axis = np.zeros(3)
    nearest = np.abs(direction).argmax()
    axis[nearest] = np.sign(direction[nearest])
    return axis if direction @ axis > np.cos(_NEARLY_RAD) else direction


def leg_length(places: Mapping[str, Array]) -> float | None:
    """From hip to ankle, by the knee; None where a joint of the left leg has no place."""
    parts = [places.get(f"left{part}") for part in ("UpperLeg", "LowerLeg", "Foot")]
    hip, knee, ankle = parts
    if hip is None or knee is None or ankle is None:
        return None
    return float(np.linalg.norm(hip - knee) + np.linalg.norm(knee - ankle))


def metre(armature: Armature) -> float:
    """How long a metre of the average character, which is 1.73 m tall, is on this one: by its legs, else by the height
    of its hips above the armature's origin."""
    places = {joint: armature.head_of(joint) for joint in armature.joints}
    own = leg_length(places)
    if own is not None:
        return own / AVERAGE_LEG_M
    return float(places["hips"] @ character_axes(armature)[:, 1]) / AVERAGE_HIPS_M
