"""The mannequin's body below the head: capsules of jumper, trousers, shoes and hands.

Conventions: positions are given as a joint and an offset in metres in the T-pose, for the left side; the right side is
the mirror image. Clothes and skin are meshed separately, so that their borders are clean and bare hands stand out from
the body.

Clothes have folds: shallow waves where cloth bunches, at elbows, waist and knees, mostly in the shading, for the
average body; the left's are mirrored to the right. A fold displaces the surface by a millimetre or two and tilts its
normals as a deeper one would, since the mesh is too coarse for its shape.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum, auto
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ...model.figure import Legwear, Sex
from ..body.skeleton import FINGERS, Offset, Skeleton
from .carrying import t_pose_m
from .surface import SkinnedCapsule, Surface

HERE: Offset = (0.0, 0.0, 0.0)


class Use(Enum):
    """The role of a bone: a long surface over several joints is drawn as one bone and skinned to others, because
    overlapping drawn bones would bulge."""

    DRAWN_AND_CARRIES = auto()
    DRAWN = auto()
    CARRIES = auto()


@dataclass(frozen=True, slots=True)
class Bone:
    """A capsule from a point at `joint` to a point at `towards`, skinned to `joint`."""

    joint: str
    towards: str
    start_radius_m: float
    end_radius_m: float
    start_m: Offset = HERE
    end_m: Offset = HERE
    stretch: Offset = (1.0, 1.0, 1.0)
    use: Use = Use.DRAWN_AND_CARRIES


@dataclass(frozen=True, slots=True)
class Garment:
    """A surface of one material: `middle` bones occur once, `left` bones are mirrored. What `hangs` moves with the hips
    above and with both shins below."""

    material: str
    blend_m: float
    grid_m: float
    middle: tuple[Bone, ...] = ()
    left: tuple[Bone, ...] = ()
    hangs: bool = False


JUMPER = Garment(
    "jumper",
    blend_m=0.012,
    grid_m=0.016,
    middle=(
        Bone("hips", "spine", 0.105, 0.088, (0, -0.03, 0.0), (0, 0.070, 0.004), (1.42, 0.9, 1.03), Use.DRAWN),
        Bone("spine", "upperChest", 0.088, 0.106, (0, 0.080, 0.004), (0, 0.0, 0.012), (1.46, 0.9, 1.06), Use.DRAWN),
        Bone("hips", "spine", 0.106, 0.100, (0, -0.01, 0.004), (0, 0.02, 0.006), (1.42, 0.75, 0.98), Use.CARRIES),
        Bone("spine", "chest", 0.098, 0.100, (0, 0.02, 0.006), HERE, (1.34, 1.0, 1.0), Use.CARRIES),
        Bone("chest", "upperChest", 0.102, 0.106, (0, 0.02, 0.004), (0, 0.0, 0.012), (1.50, 1.0, 1.02), Use.CARRIES),
        Bone("upperChest", "neck", 0.102, 0.055, (0, 0.015, 0.008), (0, 0.004, -0.001), (1.42, 1.0, 1.0)),
    ),
    left=(
        Bone("leftShoulder", "leftUpperArm", 0.046, 0.042, (0.02, -0.036, -0.01), (-0.014, -0.023, 0), (1, 1, 1.2)),
        Bone(
            "leftShoulder", "leftUpperArm", 0.046, 0.033, (0.0, 0.014, -0.020), (-0.035, -0.016, -0.004), use=Use.DRAWN
        ),
        Bone("leftUpperArm", "leftLowerArm", 0.047, 0.037, (0.030, -0.008, 0.0)),
        Bone("leftLowerArm", "leftHand", 0.038, 0.034, HERE, (-0.03, 0, 0)),
    ),
)

TROUSERS = Garment(
    "legwear",
    blend_m=0.012,
    grid_m=0.018,
    middle=(Bone("hips", "hips", 0.098, 0.098, (0, 0.005, 0.0), (0, -0.06, -0.008), (1.42, 0.8, 1.02)),),
    left=(
        Bone("leftUpperLeg", "leftLowerLeg", 0.080, 0.049, (-0.006, -0.065, -0.004), (0, 0, 0.0)),
        Bone("leftLowerLeg", "leftFoot", 0.049, 0.046, (0, 0, 0), (0, 0.03, 0.004)),
    ),
)

SKIRT = Garment(
    "legwear",
    blend_m=0.012,
    grid_m=0.018,
    middle=(
        Bone("hips", "hips", 0.100, 0.106, (0, 0.00, 0.0), (0, -0.12, -0.004), (1.42, 0.8, 1.02), Use.DRAWN),
        Bone("hips", "hips", 0.098, 0.178, (0, -0.06, 0.0), (0, -0.80, -0.010), (1.34, 0.15, 1.0), Use.DRAWN),
    ),
    hangs=True,
)

STOCKINGS = Garment(
    "skin",
    blend_m=0.012,
    grid_m=0.014,
    left=(Bone("leftLowerLeg", "leftFoot", 0.045, 0.036, (0, -0.22, -0.016), (0, 0.02, 0.004)),),
)

SHOES = Garment(
    "shoes",
    blend_m=0.008,
    grid_m=0.012,
    left=(
        Bone("leftFoot", "leftFoot", 0.040, 0.040, (0, 0.02, 0.0), (0, -0.035, -0.018)),
        Bone("leftFoot", "leftToes", 0.038, 0.032, (0, -0.04, 0.02), (0.004, 0.014, 0), (1.1, 0.95, 1)),
        Bone("leftToes", "leftToes", 0.034, 0.026, (0.004, 0.008, 0.0), (0.004, 0.004, 0.05), (1.25, 0.85, 1)),
    ),
)


def _finger_bones() -> tuple[Bone, ...]:
    """Three capsules per finger; the last ends a finger's breadth beyond its joint."""
    radii = {"Thumb": 0.0119, "Index": 0.0097, "Middle": 0.0100, "Ring": 0.0095, "Little": 0.0085}
    tips: dict[str, Offset] = {
        "Thumb": (0.024, -0.002, 0.013),
        "Index": (0.025, -0.001, 0.0),
        "Middle": (0.028, -0.001, 0.0),
        "Ring": (0.025, -0.001, 0.0),
        "Little": (0.021, -0.001, 0.0),
    }
    bones = []
    for finger in FINGERS:
        names = ("Metacarpal", "Proximal", "Distal") if finger == "Thumb" else ("Proximal", "Intermediate", "Distal")
        joints = [f"left{finger}{name}" for name in names]
        radius = radii[finger]
        bones += [
            Bone(joints[0], joints[1], radius * (1.25 if finger == "Thumb" else 1.08), radius),
            Bone(joints[1], joints[2], radius, 0.93 * radius),
            Bone(joints[2], joints[2], 0.93 * radius, 0.80 * radius, HERE, tips[finger]),
        ]
    return tuple(bones)


HANDS = Garment(
    "skin",
    blend_m=0.0030,
    grid_m=0.0055,
    left=(
        Bone("leftLowerArm", "leftHand", 0.026, 0.026, (0.21, 0, 0), (-0.005, 0, 0), (1, 0.82, 1.05)),
        Bone("leftHand", "leftHand", 0.0258, 0.0235, HERE, (0.03, -0.001, 0.0), (1, 0.72, 1.15)),
        Bone("leftHand", "leftIndexProximal", 0.0193, 0.0145, (0.02, 0, 0.012), (-0.006, -0.001, -0.002), (1, 0.85, 1)),
        Bone("leftHand", "leftMiddleProximal", 0.0193, 0.0145, (0.02, 0, 0.004), (-0.006, -0.002, 0), (1, 0.85, 1)),
        Bone("leftHand", "leftRingProximal", 0.0193, 0.0140, (0.02, 0, -0.006), (-0.006, -0.001, 0), (1, 0.85, 1)),
        Bone("leftHand", "leftLittleProximal", 0.0183, 0.0129, (0.02, 0, -0.014), (-0.004, 0.001, 0), (1, 0.9, 1)),
        Bone("leftHand", "leftThumbMetacarpal", 0.0150, 0.0160, (0.015, -0.004, 0.014), (0.012, -0.002, 0.006)),
        *_finger_bones(),
    ),
)

NECK = Garment(
    "skin",
    blend_m=0.008,
    grid_m=0.012,
    middle=(
        Bone("neck", "head", 0.054, 0.050, (0, -0.07, 0.002), (0, -0.02, 0.0)),
        Bone("head", "head", 0.050, 0.048, (0, -0.02, 0.0), (0, 0.04, 0.004)),
    ),
)

_BUST = (Bone("upperChest", "upperChest", 0.052, 0.050, (0.052, -0.030, 0.068), (0.062, -0.036, 0.068)),)


def garments_of(sex: Sex, legwear: Legwear) -> tuple[Garment, ...]:
    """What is worn over what, and the skin that is seen."""
    jumper = replace(JUMPER, left=(*JUMPER.left, *_BUST)) if sex is Sex.FEMALE else JUMPER
    below = (SKIRT, STOCKINGS) if legwear is Legwear.SKIRT else (TROUSERS,)
    return jumper, *below, SHOES, HANDS, NECK


def drawn_capsules(garment: Garment, skeleton: Skeleton) -> tuple[SkinnedCapsule, ...]:
    """The capsules that form the garment's surface on this skeleton: middle, left, right."""
    return _capsules(garment, skeleton, besides=Use.CARRIES)


def skinning_capsules(garment: Garment, skeleton: Skeleton) -> tuple[SkinnedCapsule, ...]:
    """The capsules whose joints the garment's surface is skinned to."""
    return _capsules(garment, skeleton, besides=Use.DRAWN)


def _capsules(garment: Garment, skeleton: Skeleton, *, besides: Use) -> tuple[SkinnedCapsule, ...]:
    places_m = t_pose_m(skeleton)
    middle = [_capsule(bone, skeleton, places_m) for bone in garment.middle if bone.use is not besides]
    left = [_capsule(bone, skeleton, places_m) for bone in garment.left if bone.use is not besides]
    return (*middle, *left, *(_mirrored(capsule) for capsule in left))


def _capsule(bone: Bone, skeleton: Skeleton, places_m: FloatArray) -> SkinnedCapsule:
    start = places_m[skeleton.index[bone.joint]] + np.array(bone.start_m)
    end = places_m[skeleton.index[bone.towards]] + np.array(bone.end_m)
    return SkinnedCapsule(
        bone.joint, _triple(start), _triple(end), bone.start_radius_m, bone.end_radius_m, bone.stretch
    )


def _mirrored(capsule: SkinnedCapsule) -> SkinnedCapsule:
    return SkinnedCapsule(
        capsule.joint.replace("left", "right"),
        (-capsule.start_m[0], *capsule.start_m[1:]),
        (-capsule.end_m[0], *capsule.end_m[1:]),
        capsule.start_radius_m,
        capsule.end_radius_m,
        capsule.stretch,
    )


def _triple(place: FloatArray) -> tuple[float, float, float]:
    return float(place[0]), float(place[1]), float(place[2])


DEPTH_M = 0.0016
TILT = 2.3
"""How many times deeper folds look than they are."""
_STEP_M = 1e-3


@dataclass(frozen=True, slots=True)
class Folds:
    """Waves around a point at `offset_m` from a joint, fading over `reach_m`; `waves` are cycles per metre along x, y
    and z."""

    joint: str
    offset_m: tuple[float, float, float]
    reach_m: tuple[float, float, float]
    waves: tuple[float, float, float]
    depth: float = 1.0


FOLDS: Mapping[str, tuple[Folds, ...]] = MappingProxyType(
    {
        "jumper": (
            Folds("leftLowerArm", (-0.01, 0.0, 0.02), (0.055, 0.06, 0.05), (26.0, 9.0, -8.0)),
            Folds("leftHand", (-0.075, 0.0, 0.0), (0.035, 0.06, 0.06), (30.0, 0.0, 7.0), 0.7),
            Folds("leftUpperArm", (-0.02, -0.075, 0.03), (0.05, 0.055, 0.06), (14.0, 15.0, 0.0)),
            Folds("spine", (0.10, 0.0, 0.06), (0.09, 0.07, 0.12), (-5.0, 21.0, 0.0)),
            Folds("spine", (0.03, 0.09, 0.09), (0.07, 0.06, 0.09), (7.0, 15.0, 0.0), 0.6),
            Folds("upperChest", (0.09, -0.02, 0.08), (0.06, 0.08, 0.06), (13.0, -9.0, 0.0), 0.5),
        ),
        "legwear": (
            Folds("leftUpperLeg", (-0.02, -0.07, 0.06), (0.07, 0.06, 0.08), (11.0, 17.0, 0.0)),
            Folds("leftLowerLeg", (0.0, 0.01, 0.0), (0.07, 0.06, 0.07), (7.0, 24.0, 0.0)),
            Folds("leftFoot", (0.0, 0.09, 0.0), (0.06, 0.05, 0.07), (5.0, 27.0, 0.0)),
        ),
    }
)


def folded(surface: Surface, material: str, skeleton: Skeleton) -> Surface:
    """The surface with the folds of its material, if that has any."""
    folds = FOLDS.get(material)
    if not folds:
        return surface
    at_m = surface.positions_m
    heights = _heights(folds, at_m, skeleton)
    steps = _STEP_M * np.eye(3)
    slope = np.stack([_heights(folds, at_m + step, skeleton) - heights for step in steps], axis=-1) / _STEP_M
    slope -= np.sum(slope * surface.normals, axis=1, keepdims=True) * surface.normals
    normals = surface.normals - TILT * slope
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return replace(surface, positions_m=at_m + heights[:, None] * surface.normals, normals=normals)


def _heights(folds: tuple[Folds, ...], at_m: FloatArray, skeleton: Skeleton) -> FloatArray:
    """How far the folds stand out (V,)."""
    places_m, mirrored_m = t_pose_m(skeleton), at_m * [1.0, 1.0, 1.0]
    mirrored_m[:, 0] = np.abs(mirrored_m[:, 0])
    heights = np.zeros(len(at_m))
    for each in folds:
        way = mirrored_m - places_m[skeleton.index[each.joint]] - np.array(each.offset_m)
        fading = np.exp(-0.5 * np.sum((way / np.array(each.reach_m)) ** 2, axis=1))
        heights += each.depth * DEPTH_M * fading * np.sin(2 * np.pi * (way @ np.array(each.waves)))
    return heights
