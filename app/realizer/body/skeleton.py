"""The skeleton, with VRM 1.0 humanoid joint names in VRM's T-pose, its forward kinematics, and the joints of an arm
with the independently moving parts that a gesture can define.

Conventions (docs/references.md): metres, Y up, the character faces +Z, its left is +X, feet at Y = 0. In the T-pose the
axes of all joints are parallel to the world's, so the identity rotation is the T-pose, with palms down and thumbs
forward. Parents come before their children.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import copysign
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray, Hand
from ..geometry.rotations import multiply, rotate
from .proportions import AVERAGE, Proportions

Offset = tuple[float, float, float]
Joints = NDArray[np.int64]

HIPS_HEIGHT_M = 0.95

_TRUNK: dict[str, tuple[str, Offset]] = {
    "spine": ("hips", (0.0, 0.08, 0.0)),
    "chest": ("spine", (0.0, 0.12, 0.0)),
    "upperChest": ("chest", (0.0, 0.13, -0.01)),
    "neck": ("upperChest", (0.0, 0.15, -0.01)),
    "head": ("neck", (0.0, 0.10, 0.01)),
}
_LEFT: dict[str, tuple[str, Offset]] = {
    "Eye": ("head", (0.032, 0.075, 0.085)),
    "Shoulder": ("upperChest", (0.025, 0.10, 0.01)),
    "UpperArm": ("Shoulder", (0.145, -0.01, -0.015)),
    "LowerArm": ("UpperArm", (0.28, 0.0, 0.0)),
    "Hand": ("LowerArm", (0.25, 0.0, 0.0)),
    "ThumbMetacarpal": ("Hand", (0.02, -0.012, 0.028)),
    "ThumbProximal": ("ThumbMetacarpal", (0.034, -0.006, 0.024)),
    "ThumbDistal": ("ThumbProximal", (0.028, -0.003, 0.014)),
    "IndexProximal": ("Hand", (0.088, 0.0, 0.026)),
    "IndexIntermediate": ("IndexProximal", (0.040, 0.0, 0.0)),
    "IndexDistal": ("IndexIntermediate", (0.024, 0.0, 0.0)),
    "MiddleProximal": ("Hand", (0.090, 0.002, 0.004)),
    "MiddleIntermediate": ("MiddleProximal", (0.044, 0.0, 0.0)),
    "MiddleDistal": ("MiddleIntermediate", (0.027, 0.0, 0.0)),
    "RingProximal": ("Hand", (0.085, 0.0, -0.017)),
    "RingIntermediate": ("RingProximal", (0.040, 0.0, 0.0)),
    "RingDistal": ("RingIntermediate", (0.025, 0.0, 0.0)),
    "LittleProximal": ("Hand", (0.078, -0.004, -0.036)),
    "LittleIntermediate": ("LittleProximal", (0.032, 0.0, 0.0)),
    "LittleDistal": ("LittleIntermediate", (0.019, 0.0, 0.0)),
    "UpperLeg": ("hips", (0.09, -0.04, 0.0)),
    "LowerLeg": ("UpperLeg", (0.0, -0.42, 0.01)),
    "Foot": ("LowerLeg", (0.0, -0.41, -0.03)),
    "Toes": ("Foot", (0.0, -0.06, 0.14)),
}

FINGERS = ("Thumb", "Index", "Middle", "Ring", "Little")
SIDES = ("left", "right")
HANDS = ("leftHand", "rightHand")


def _joints() -> dict[str, tuple[str | None, Offset]]:
    found: dict[str, tuple[str | None, Offset]] = {"hips": (None, (0.0, HIPS_HEIGHT_M, 0.0)), **_TRUNK}
    for side, sign in (("left", 1.0), ("right", -1.0)):
        for name, (parent, (x, y, z)) in _LEFT.items():
            found[side + name] = (side + parent if parent in _LEFT else parent, (sign * x, y, z))
    return found


def _proportioned(joint: str, offset_m: Offset, to: Proportions) -> Offset:
    """The offset of a joint in a body: shoulders and hips are as far apart as its widths say."""
    x, y, z = (to.scale * part for part in offset_m)
    match joint.removeprefix("left").removeprefix("right"):
        case "neck":
            return x, y, z + to.stoop_m
        case "Eye":
            return to.head * offset_m[0], to.head * offset_m[1], to.head * offset_m[2]
        case "UpperLeg":
            return to.hips * offset_m[0], y, z
        case "UpperArm":
            root_m = copysign(_LEFT["Shoulder"][1][0], x)
            return to.shoulders * (offset_m[0] + root_m) - to.scale * root_m, y, z
    return x, y, z


@dataclass(frozen=True, slots=True, eq=False)
class Skeleton:
    """Joint names, the index of each joint's parent (-1 for the hips), and each joint's offset from its parent (J, 3);
    for the hips, their position in the world. `proportions` are those of the flesh around it as well."""

    names: tuple[str, ...]
    parents: tuple[int, ...]
    offsets_m: FloatArray
    index: Mapping[str, int]
    proportions: Proportions = AVERAGE

    @classmethod
    def standing(cls, proportions: Proportions = AVERAGE) -> "Skeleton":
        """A body of these proportions; the average is an adult of 1.73 m."""
        joints = _joints()
        index = {name: number for number, name in enumerate(joints)}
        parents = tuple(-1 if parent is None else index[parent] for parent, _offset in joints.values())
        offsets = np.array([_proportioned(name, offset, proportions) for name, (_parent, offset) in joints.items()])
        offsets.setflags(write=False)
        return cls(tuple(joints), parents, offsets, MappingProxyType(index), proportions)

    def chain(self, *names: str) -> list[int]:
        """The indices of the joints with these names."""
        return [self.index[name] for name in names]

    def arms(self, rotations: FloatArray) -> FloatArray:
        """The rotations (T, 2, 19, 4) of the joints of the left and of the right arm among those of a body (T, J, 4),
        which they are a view of: what is done to both arms at once takes half as many calls. Raises ValueError for
        rotations that do not lie together in memory."""
        if not rotations.flags.c_contiguous:
            raise ValueError("the arms of rotations that do not lie together would be a copy")
        middle = len(self.names) - len(SIDES) * len(_LEFT)
        sides = rotations[:, middle:].reshape(len(rotations), len(SIDES), len(_LEFT), 4)
        return sides[:, :, _FIRST_OF_ARM : _FIRST_OF_ARM + len(PARTS) - 1]

    def rows(self, *names: str) -> slice:
        """The same of joints that follow each other, which NumPy reaches much faster. Raises ValueError for others."""
        first, *later = self.chain(*names)
        if later != list(range(first + 1, first + 1 + len(later))):
            raise ValueError(f"the joints {', '.join(names)} do not follow each other")
        return slice(first, first + len(names))


def forward(
    skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray, only: frozenset[int] | None = None
) -> tuple[FloatArray, FloatArray]:
    """Forward kinematics: world positions (…, J, 3) and orientations (…, J, 4) for local rotations (…, J, 4) and hips
    (…, 3).

    With `only`, a set of joints that contains the parents of its members, all others are left undefined.
    """
    by_joint = rotations.swapaxes(0, -2).shape[:-1]
    positions, orientations = (np.empty((*by_joint, size)).swapaxes(0, -2) for size in (3, 4))
    positions[..., 0, :], orientations[..., 0, :] = hips_m, rotations[..., 0, :]
    _place(skeleton, rotations, positions, orientations, only)
    return positions, orientations


def _place(
    skeleton: Skeleton,
    rotations: FloatArray,
    positions: FloatArray,
    orientations: FloatArray,
    only: frozenset[int] | None,
) -> None:
    """Fill in the positions and orientations of the joints; their parents' must be known. With the joints' axis first,
    which is how they lie in memory, several are reached many times faster."""
    at_m, turned, local = (each.swapaxes(0, -2) for each in (positions, orientations, rotations))
    generations = _generations(skeleton, only)
    for joints, parents in generations.each:
        turned[joints] = multiply(turned.take(parents, axis=0), local[joints])
    offsets_m = generations.offsets_m.reshape(-1, *(1,) * (turned.ndim - 2), 3)
    ways_m, begun = rotate(turned.take(generations.parents, axis=0), offsets_m), 0
    for joints, parents in generations.each:
        at_m[joints] = at_m.take(parents, axis=0) + ways_m[begun : begun + len(joints)]
        begun += len(joints)


@dataclass(frozen=True, slots=True, eq=False)
class _Generations:
    """Joints and their parents, grouped by depth in the hierarchy: each group can be computed at once; the parents of
    all, and the offsets (n, 3) from them, in the same order."""

    each: tuple[tuple[Joints, Joints], ...]
    parents: Joints
    offsets_m: FloatArray


@lru_cache(maxsize=64)
def _generations(skeleton: Skeleton, only: frozenset[int] | None) -> _Generations:
    """Those of these joints. Never mutated."""
    depth = [0] * len(skeleton.parents)
    found: list[tuple[list[int], list[int]]] = []
    for joint, parent in enumerate(skeleton.parents):
        if parent >= 0:
            depth[joint] = depth[parent] + 1
            if only is None or joint in only:
                found += [([], []) for _ in range(depth[joint] - len(found))]
                joints, parents = found[depth[joint] - 1]
                joints.append(joint)
                parents.append(parent)
    each = tuple((np.array(joints), np.array(parents)) for joints, parents in found if joints)
    every, parents_of_all = (np.concatenate(those) for those in zip(*each, strict=True))
    return _Generations(each, parents_of_all, skeleton.offsets_m[every])


@lru_cache(maxsize=64)
def as_far_as_hands(skeleton: Skeleton) -> frozenset[int]:
    """The joints that move the hands, and these: with no others, `forward` is much faster."""
    arms = (side + joint for side in SIDES for joint in ("Shoulder", "UpperArm", "LowerArm", "Hand"))
    return frozenset(skeleton.chain("hips", "spine", "chest", "upperChest", *arms))


_PHALANGES = ("Proximal", "Intermediate", "Distal")
FINGER_JOINTS: tuple[str, ...] = tuple(
    finger + phalanx
    for finger in FINGERS
    for phalanx in (("Metacarpal", "Proximal", "Distal") if finger == "Thumb" else _PHALANGES)
)
PARTS: tuple[str, ...] = ("Shoulder", "UpperArm", "Elbow", "LowerArm", "Hand", *FINGER_JOINTS)
"""The rows of a `PartialPose`: the joints of an arm, with the lower arm split into the elbow's hinge and the twist."""


_FIRST_OF_ARM = list(_LEFT).index("Shoulder")


def arm_joints(side: Hand) -> tuple[str, ...]:
    """The nineteen joints of an arm in the skeleton's order, from the collarbone to the little finger's tip."""
    return tuple(side.value + name for name in PARTS if name != "Elbow")
