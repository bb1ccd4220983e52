"""A skeleton as a mechanical system for MuJoCo: its parts by their masses, a servo in each joint, soles on a floor.

Conventions: the world is the skeleton's (metres, Y up), quaternions in MuJoCo are w x y z. Every joint that carries
mass is a ball, except the knees, which are hinges about x as in `torso.balance`; the hips are free. A servo is a spring
whose rest is the pose asked for, and a damper: the antagonistic pair of NGS §3.4, whose two springs make one whose
equilibrium moves. It is described by the natural frequency and damping ratio that it has with everything beyond the
joint held still; those of the legs by what they carry.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import pi
from types import MappingProxyType
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element, SubElement, tostring

import numpy as np

from ...model import FloatArray
from ..body.masses import BodyMass, parts_of
from ..body.skeleton import Skeleton

if TYPE_CHECKING:
    import mujoco


STEP_S = 1 / 480
"""The time step of the simulation, a whole fraction of a frame at 30 and at 60 frames a second."""

FEET = ("leftFoot", "rightFoot")
GRAVITY_M_S2 = 9.81

_FRICTION = "1 0.005 0.0001"
"""The friction of rubber soles when they slide; for turning and rolling, MuJoCo's defaults."""


@dataclass(frozen=True, slots=True)
class Servo:
    """The natural frequency (Hz) and the damping ratio of a joint's servo; 1 is critically damped."""

    frequency_hz: float
    damping: float


_TRUNK, _NECK = Servo(2.0, 0.8), Servo(4.0, 0.8)

SERVOS: Mapping[str, Servo] = MappingProxyType(
    {
        "spine": _TRUNK,
        "chest": _TRUNK,
        "upperChest": _TRUNK,
        "neck": _NECK,
        "head": _NECK,
        "Shoulder": Servo(3.0, 0.8),
        "UpperArm": Servo(4.0, 0.6),
        "LowerArm": Servo(4.0, 0.5),
        "Hand": Servo(4.0, 0.4),
    }
)
"""The servo of each joint, for arms without the side; an arm is loosest at the wrist."""

LEGS: Mapping[str, float] = MappingProxyType({"UpperLeg": 2.0, "LowerLeg": 2.0, "Foot": 0.8})
"""The stiffness of both legs' joints together, as a share of that at which a standing body would just not topple: its
weight times the height of its hips."""

_LEG_DAMPING_S = 0.06
"""The damping of a leg's joint as a share of its stiffness, seconds."""


@dataclass(frozen=True, slots=True, eq=False)
class PhysicalBody:
    """A compiled model, and for each of `joints` (names, the hips first) its row in the skeleton and its first place in
    MuJoCo's positions and velocities. A model is of one simulation: its servos' poses are in it."""

    model: "mujoco.MjModel"
    joints: tuple[str, ...]
    rows: list[int]
    positions: list[int]
    velocities: list[int]

    @property
    def weight_n(self) -> float:
        return float(self.model.body_subtreemass[0]) * GRAVITY_M_S2


def physical_body(skeleton: Skeleton) -> PhysicalBody:
    """The body of this skeleton, compiled anew."""
    import mujoco  # an extra, which most do without

    model = mujoco.MjModel.from_xml_string(_description(skeleton))
    joints = tuple(part.joint for part in parts_of(skeleton))
    numbers = [model.joint(name).id for name in joints]
    places = (model.jnt_qposadr[numbers].tolist(), model.jnt_dofadr[numbers].tolist())
    return PhysicalBody(model, joints, skeleton.chain(*joints), *places)


def is_hinge(joint: str) -> bool:
    """Whether a joint turns about its x axis only."""
    return joint.endswith("LowerLeg")


@lru_cache(maxsize=64)
def _description(skeleton: Skeleton) -> str:
    """The model in MJCF, MuJoCo's own format."""
    root = Element("mujoco")
    gravity = _text(0.0, -GRAVITY_M_S2, 0.0)
    option = SubElement(root, "option", timestep=_text(STEP_S), integrator="implicitfast", gravity=gravity)
    SubElement(option, "flag", autoreset="disable")
    world = SubElement(root, "worldbody")
    SubElement(world, "geom", type="plane", size="5 5 1", zaxis="0 1 0", friction=_FRICTION)
    elements: dict[str, Element] = {}
    for part in parts_of(skeleton):
        joint = skeleton.index[part.joint]
        parent = skeleton.parents[joint]
        above = world if parent < 0 else elements[skeleton.names[parent]]
        elements[part.joint] = _add_body(above, skeleton, part)
    return tostring(root, encoding="unicode")


def _add_body(above: Element, skeleton: Skeleton, part: BodyMass) -> Element:
    offset_m = skeleton.offsets_m[skeleton.index[part.joint]]
    body = SubElement(above, "body", name=part.joint, pos=_text(*offset_m))
    if part.joint == "hips":
        SubElement(body, "freejoint", name=part.joint)
    else:
        stiffness, damping = servo_of(skeleton, part.joint)
        kind = {"type": "hinge", "axis": "1 0 0"} if is_hinge(part.joint) else {"type": "ball"}
        held = {"name": part.joint, "stiffness": _text(stiffness), "damping": _text(damping)}
        SubElement(body, "joint", {**kind, **held})
    place, inertia = _text(*part.centre_m), _text(*part.inertia_kg_m2)
    SubElement(body, "inertial", pos=place, mass=_text(part.mass_kg), diaginertia=inertia)
    if part.joint.endswith("Foot"):
        _add_sole(body, skeleton)
    return body


def _add_sole(foot: Element, skeleton: Skeleton) -> None:
    """A box under the foot: from heel to toe and as wide as a shoe, its underside on the floor."""
    scale = skeleton.proportions.scale
    half_m = (0.045 * scale, 0.01, 0.13 * scale)
    place = (0.0, -0.08 * scale + half_m[1], 0.07 * scale)
    size = _text(*half_m)
    SubElement(foot, "geom", type="box", size=size, pos=_text(*place), friction=_FRICTION, mass="0")


def servo_of(skeleton: Skeleton, joint: str) -> tuple[float, float]:
    """Stiffness (N m/rad) and damping (N m s/rad) of a joint's servo."""
    part = joint.removeprefix("left").removeprefix("right")
    if part in LEGS:
        weight_n = GRAVITY_M_S2 * sum(each.mass_kg for each in parts_of(skeleton))
        stiffness = LEGS[part] / 2 * weight_n * float(skeleton.offsets_m[0, 1])
        return stiffness, _LEG_DAMPING_S * stiffness
    servo, inertia = SERVOS[part], inertia_beyond_kg_m2(skeleton, joint)
    speed = 2 * pi * servo.frequency_hz
    return inertia * speed**2, 2 * servo.damping * inertia * speed


def _text(*numbers: float) -> str:
    return " ".join(f"{number:.9g}" for number in np.array(numbers).tolist())


@lru_cache(maxsize=1024)
def inertia_beyond_kg_m2(skeleton: Skeleton, joint: str) -> float:
    """The inertia about a joint of everything that it carries, in the T-pose: about an axis across the way to
    each part."""
    places_m = _places_m(skeleton)
    about_m = places_m[skeleton.index[joint]]
    found = 0.0
    for part in parts_of(skeleton):
        at = skeleton.index[part.joint]
        if _carries(skeleton, skeleton.index[joint], at):
            away_m = places_m[at] + np.array(part.centre_m) - about_m
            found += float(np.mean(part.inertia_kg_m2)) + part.mass_kg * float(away_m @ away_m)
    return found


@lru_cache(maxsize=64)
def _places_m(skeleton: Skeleton) -> list[FloatArray]:
    places_m: list[FloatArray] = []
    for parent, offset_m in zip(skeleton.parents, skeleton.offsets_m, strict=True):
        places_m.append(offset_m + (places_m[parent] if parent >= 0 else 0.0))
    return places_m


def _carries(skeleton: Skeleton, joint: int, other: int) -> bool:
    while other > joint:
        other = skeleton.parents[other]
    return other == joint
