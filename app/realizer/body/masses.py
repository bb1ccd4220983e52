"""How a body's mass lies in it: the segments of de Leva (1996), carried by the joints of our skeleton.

The table is P. de Leva, "Adjustments to Zatsiorsky-Seluyanov's segment inertia parameters", Journal of Biomechanics
29(9), table 4: of women and men, a segment's share of the body's mass, how far along it its centre is, and its radii of
gyration as shares of its length, about the axes from back to front (sagittal), from side to side (transverse) and along
it. The neutral body is their mean. Where segments begin and end in our joints' spaces is ours: the middle trunk is
shared by spine and chest, a tenth of the upper trunk moves with the collarbones and a twentieth with the neck.
Conventions: metres in the joint's space, kilograms; a body's mass is that of de Leva's subjects at its height (body
mass index 20.6 and 24.1), times the square of its girth.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ...model.figure import Sex
from ..geometry.rotations import rotate
from .skeleton import SIDES, Skeleton

Point = tuple[float, float, float]

_MASS_INDEX_KG_M2: Mapping[Sex, float] = MappingProxyType({Sex.FEMALE: 20.6, Sex.MALE: 24.1, Sex.NEUTRAL: 22.35})


@dataclass(frozen=True, slots=True)
class _Segment:
    """A row of the table: share of the mass, centre, and radii of gyration (sagittal, transverse, longitudinal), each
    of women and men."""

    mass: tuple[float, float]
    centre: tuple[float, float]
    sagittal: tuple[float, float]
    transverse: tuple[float, float]
    longitudinal: tuple[float, float]


_HEAD = _Segment((0.0668, 0.0694), (0.5894, 0.5976), (0.330, 0.362), (0.359, 0.376), (0.318, 0.312))
_UPPER_TRUNK = _Segment((0.1545, 0.1596), (0.2077, 0.2999), (0.746, 0.716), (0.502, 0.454), (0.718, 0.659))
_MIDDLE_TRUNK = _Segment((0.1465, 0.1633), (0.4512, 0.4502), (0.433, 0.482), (0.354, 0.383), (0.415, 0.468))
_LOWER_TRUNK = _Segment((0.1247, 0.1117), (0.4920, 0.6115), (0.433, 0.615), (0.402, 0.551), (0.444, 0.587))
_UPPER_ARM = _Segment((0.0255, 0.0271), (0.5754, 0.5772), (0.278, 0.285), (0.260, 0.269), (0.148, 0.158))
_FOREARM = _Segment((0.0138, 0.0162), (0.4559, 0.4574), (0.261, 0.276), (0.257, 0.265), (0.094, 0.121))
_HAND = _Segment((0.0056, 0.0061), (0.7474, 0.7900), (0.531, 0.628), (0.454, 0.513), (0.335, 0.401))
_THIGH = _Segment((0.1478, 0.1416), (0.3612, 0.4095), (0.369, 0.329), (0.364, 0.329), (0.162, 0.149))
_SHANK = _Segment((0.0481, 0.0433), (0.4416, 0.4459), (0.271, 0.255), (0.267, 0.249), (0.093, 0.103))
_FOOT = _Segment((0.0129, 0.0137), (0.4014, 0.4415), (0.299, 0.257), (0.279, 0.245), (0.139, 0.124))

_UPPER_TRUNK_M = ((0.0, 0.16, 0.0), (0.0, -0.01, 0.0))


@dataclass(frozen=True, slots=True)
class _Carried:
    """A segment, or a share of it, as a joint carries it: from and to where, in the average body's joint's space, and
    the axis (0 to 2) along it."""

    joint: str
    segment: _Segment
    from_m: Point
    to_m: Point
    axis: int
    share: float = 1.0


_TRUNK: tuple[_Carried, ...] = (
    _Carried("hips", _LOWER_TRUNK, (0.0, 0.106, 0.0), (0.0, -0.04, 0.0), 1),
    _Carried("spine", _MIDDLE_TRUNK, (0.0, 0.133, 0.0), (0.0, 0.026, 0.0), 1, 0.5),
    _Carried("chest", _MIDDLE_TRUNK, (0.0, 0.120, 0.0), (0.0, 0.013, 0.0), 1, 0.5),
    _Carried("upperChest", _UPPER_TRUNK, *_UPPER_TRUNK_M, 1, 0.85),
    _Carried("neck", _UPPER_TRUNK, (0.0, 0.10, 0.0), (0.0, 0.0, 0.0), 1, 0.05),
    _Carried("head", _HEAD, (0.0, 0.20, 0.01), (0.0, 0.0, 0.01), 1),
)
_LEFT: tuple[_Carried, ...] = (
    _Carried("Shoulder", _UPPER_TRUNK, (0.145, 0.0, 0.0), (0.0, 0.0, 0.0), 0, 0.05),
    _Carried("UpperArm", _UPPER_ARM, (0.0, 0.0, 0.0), (0.28, 0.0, 0.0), 0),
    _Carried("LowerArm", _FOREARM, (0.0, 0.0, 0.0), (0.25, 0.0, 0.0), 0),
    _Carried("Hand", _HAND, (0.0, 0.0, 0.0), (0.088, 0.0, 0.0), 0),
    _Carried("UpperLeg", _THIGH, (0.0, 0.0, 0.0), (0.0, -0.42, 0.01), 1),
    _Carried("LowerLeg", _SHANK, (0.0, 0.0, 0.0), (0.0, -0.41, -0.03), 1),
    _Carried("Foot", _FOOT, (0.0, -0.045, -0.06), (0.0, -0.045, 0.20), 2),
)


@dataclass(frozen=True, slots=True)
class BodyMass:
    """What a joint carries: its mass, where the centre of that is, and its moments of inertia about the centre, along
    the joint's axes."""

    joint: str
    mass_kg: float
    centre_m: Point
    inertia_kg_m2: Point


def mass_kg(skeleton: Skeleton) -> float:
    """The mass of the whole body."""
    physique = skeleton.proportions.physique
    return _MASS_INDEX_KG_M2[physique.sex] * physique.height_m**2 * physique.build**2


@lru_cache(maxsize=64)
def parts_of(skeleton: Skeleton) -> tuple[BodyMass, ...]:
    """The parts of a body, parents before children; fingers are the hand's, toes the foot's, eyes the head's."""
    whole_kg = mass_kg(skeleton)
    sided = [(side, each) for side in SIDES for each in _LEFT]
    return tuple(_part(skeleton, whole_kg, side, each) for side, each in [*(("", each) for each in _TRUNK), *sided])


def centre_of_mass_m(skeleton: Skeleton, positions_m: FloatArray, turned: FloatArray) -> FloatArray:
    """The centre of mass (…, 3) of a body whose joints are at these positions (…, J, 3) with these orientations
    (…, J, 4) in the world."""
    parts = parts_of(skeleton)
    joints = skeleton.chain(*(part.joint for part in parts))
    masses_kg = np.array([part.mass_kg for part in parts])
    centres_m = positions_m[..., joints, :] + rotate(
        turned[..., joints, :], np.array([part.centre_m for part in parts])
    )
    return np.asarray(np.tensordot(centres_m, masses_kg / masses_kg.sum(), axes=(-2, 0)))


def _part(skeleton: Skeleton, whole_kg: float, side: str, carried: _Carried) -> BodyMass:
    segment, sex = carried.segment, skeleton.proportions.physique.sex
    scale = skeleton.proportions.head if carried.joint == "head" else skeleton.proportions.scale
    from_m, to_m = scale * np.array(carried.from_m), scale * np.array(carried.to_m)
    own_kg = carried.share * whole_kg * _of_sex(segment.mass, sex)
    centre_m = from_m + _of_sex(segment.centre, sex) * (to_m - from_m)
    if side == "right":
        centre_m[0] = -centre_m[0]
    along, long_m = carried.axis, float(np.linalg.norm(to_m - from_m))
    radii = {along: segment.longitudinal, (2 if along == 1 else 1): segment.sagittal}
    inertia = [own_kg * (long_m * _of_sex(radii.get(axis, segment.transverse), sex)) ** 2 for axis in range(3)]
    x, y, z = centre_m.tolist()
    return BodyMass(side + carried.joint, own_kg, (x, y, z), (inertia[0], inertia[1], inertia[2]))


def _of_sex(pair: tuple[float, float], sex: Sex) -> float:
    female, male = pair
    return {Sex.FEMALE: female, Sex.MALE: male}.get(sex, (female + male) / 2)
