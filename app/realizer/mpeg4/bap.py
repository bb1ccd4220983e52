"""Exports the body as MPEG-4 body animation parameters, in units of 10⁻⁵ rad (Gesture Engine §4).

Conventions, except for `BapVersion.GRETA`: angles are from the pose with the arms down (`layout.py`). Flexion and tilt
are about X, abduction and roll about Z, torsion and twisting about Y, with the signs of `sign_of`, which are those of
Visage's decoder (`BAPRotationAxis`, docs/references.md): the standard's table names planes and no signs. Fingers are
flexed about Z, towards the palm; Visage has them about X. MPEG-4 leaves the order of angles to the decoder: here a
joint turns about its first axis, then about the second as it then lies, twisting last. Root translations are
millimetres from where the hips are in the T-pose.

A collar bone has no third angle: it turns about Y, then is raised about Z, as ours are (`collarbone_for`), and what
little smoothing leaves about X goes to the upper arm, so that the arm is where ours is. The outer two joints of a thumb
bend about the one hinge that ours have.

`BapVersion.GRETA` is for Greta's player, whose skeleton has signs and an order of its own (`JointType`, `Quaternion`
and `Base_greta_fingers_bis.bvh` in github.com/isir/greta).

Every parameter is the angle about its axis, never against it, so that elbows bend by negative angles and knees by
positive ones; a joint turns by Rz·Ry·Rx. An elbow and a knee have no third angle and cannot twist after they have bent:
the twist of a forearm turns the hand, that of a lower leg the foot. An ankle is followed by the subtalar joint. A
collar bone has no angle about X, which the upper arm has instead. The outer joints of thumbs bend about X.
"""

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

import numpy as np
from scipy.spatial.transform import Rotation

from ...model import FloatArray
from ...model.formats import BapVersion
from ..body.motion import Motion
from ..body.skeleton import Skeleton
from .layout import (
    BAPS,
    FINGER_BENDS,
    FINGER_HINGE,
    FINGERS,
    SIDES,
    THUMB_BENDS,
    TRUNK,
    Parameters,
    angle_about,
    arms_down,
    euler_rad,
    parameter_file,
    thumb_hinge,
)

UNIT_RAD = 1e-5
MILLIMETRES = 1000.0

LIMBS: Mapping[str, tuple[str, tuple[str, ...]]] = MappingProxyType(
    {
        "UpperArm": ("XZY", ("shoulder_flexion", "shoulder_abduct", "shoulder_twisting")),
        "LowerArm": ("XZY", ("elbow_flexion", "", "elbow_twisting")),
        "Hand": ("XZY", ("wrist_pivot", "wrist_flexion", "wrist_twisting")),
        "UpperLeg": ("XZY", ("hip_flexion", "hip_abduct", "hip_twisting")),
        "LowerLeg": ("XZY", ("knee_flexion", "", "knee_twisting")),
        "Foot": ("XZY", ("ankle_flexion", "subtalar_flexion", "ankle_twisting")),
        "Toes": ("XZY", ("metatarsal_flexion", "", "")),
        "ThumbMetacarpal": ("XZY", ("thumb1_flexion", "thumb1_pivot", "thumb1_twisting")),
    }
)
"""The order of axes and the parameters of each joint of a limb; an empty name is an angle that the joint has not."""

_NEGATIVE = ("flexion", "tilt", "twisting")


def to_bap(motion: Motion, skeleton: Skeleton, version: BapVersion = BapVersion.MPEG4) -> bytes:
    """The file; every parameter of a joint that we have is set in every frame."""
    rotated_by = greta_angles_rad if version is BapVersion.GRETA else _angles_rad
    angles = dict(rotated_by(motion, skeleton))
    moved_mm = (motion.body.hips_m - skeleton.offsets_m[0]) * MILLIMETRES
    ways = dict(zip(("lateral", "vertical", "frontal"), moved_mm.T, strict=True))
    columns = {
        **{name: np.unwrap(angle) / UNIT_RAD for name, angle in angles.items()},
        **{f"HumanoidRoot_tr_{way}": moved for way, moved in ways.items()},
    }
    values = np.rint(np.stack(list(columns.values()), axis=1)).astype(np.int64)
    return parameter_file(version, ".bap", motion.frame_rate_hz, BAPS, Parameters(tuple(columns), values))


def sign_of(parameter: str) -> float:
    """Whether a parameter's angle is about its axis or against it. Forward and inward bends are positive."""
    if parameter.startswith("HumanoidRoot"):
        return 1.0
    part = parameter.split("_", maxsplit=1)[1] if parameter[1] == "_" else parameter
    if part in {"wrist_pivot", "subtalar_flexion"}:
        return -1.0 if part == "wrist_pivot" else 1.0
    if part.startswith(tuple(FINGERS.values())) and part.endswith("flexion"):
        return -1.0 if parameter.startswith("l") else 1.0
    return -1.0 if part.endswith(_NEGATIVE) else 1.0


def _angles_rad(motion: Motion, skeleton: Skeleton) -> Iterator[tuple[str, FloatArray]]:
    """The angles (T,) of all parameters of rotation."""
    local = {name: Rotation.from_quat(motion.body.rotations[:, place]) for name, place in skeleton.index.items()}
    root = ("HumanoidRoot_rt_body_tilt", "HumanoidRoot_rt_body_roll", "HumanoidRoot_rt_body_turn")
    yield from _signed(root, euler_rad(local["hips"], "XZY"))
    for joint, bone in TRUNK.items():
        yield from _signed((f"{bone}_tilt", f"{bone}_roll", f"{bone}_torsion"), euler_rad(local[joint], "XZY"))
    for short, side in SIDES:
        yield from _of_side(local, short, side)


def _of_side(local: Mapping[str, Rotation], short: str, side: str) -> Iterator[tuple[str, FloatArray]]:
    hang = arms_down(side)
    turned, lifted, rolled = euler_rad(local[f"{side}Shoulder"], "YZX").T
    collar = (f"{short}_sternoclavicular_rotate", f"{short}_sternoclavicular_abduct")
    yield from _signed(collar, np.stack([turned, lifted], axis=1))
    for part, (order, names) in LIMBS.items():
        found = local[side + part]
        if part == "UpperArm":
            found = Rotation.from_euler("x", rolled[:, None]) * found * hang.inv()
        elif part in {"LowerArm", "Hand", "ThumbMetacarpal"}:
            found = hang * found * hang.inv()
        yield from _signed([f"{short}_{name}" if name else "" for name in names], euler_rad(found, order))
    for ours, finger in FINGERS.items():
        root = hang * local[f"{side}{ours}Proximal"] * hang.inv()
        turns = [f"{short}_{finger}1_{turn}" for turn in ("flexion", "pivot", "twisting")]
        yield from _signed(turns, euler_rad(root, "ZXY"))
        for part, name in FINGER_BENDS:
            bend = f"{short}_{finger}{name}"
            yield bend, sign_of(bend) * angle_about(local[f"{side}{ours}{part}"], FINGER_HINGE)
    for part, name in THUMB_BENDS:
        yield f"{short}_{name}", angle_about(local[f"{side}Thumb{part}"], thumb_hinge(side))


def _signed(names: Sequence[str], angles: FloatArray) -> Iterator[tuple[str, FloatArray]]:
    for name, angle in zip(names, angles.T, strict=True):
        if name:
            yield name, sign_of(name) * angle


_ABOUT_X: FloatArray = np.array([1.0, 0.0, 0.0])

Angles = Iterator[tuple[str, FloatArray]]
"""Parameters and their angles (T,) in radians."""


def greta_angles_rad(motion: Motion, skeleton: Skeleton) -> Angles:
    """The angles of all parameters of rotation."""
    local = {name: Rotation.from_quat(motion.body.rotations[:, place]) for name, place in skeleton.index.items()}
    yield from _turned("HumanoidRoot_rt_body", ("tilt", "turn", "roll"), local["hips"])
    for joint, bone in TRUNK.items():
        yield from _turned(bone, ("tilt", "torsion", "roll"), local[joint])
    for short, side in SIDES:
        yield from _arm(local, short, side)
        yield from _fingers(local, short, side)
        yield from _leg(local, short, side)


def _turned(bone: str, names: Sequence[str], rotations: Rotation) -> Angles:
    """The angles about X, Y and Z, by Rz·Ry·Rx."""
    angles = euler_rad(rotations, "ZYX")[:, ::-1]
    for name, angle in zip(names, angles.T, strict=True):
        yield f"{bone}_{name}", angle


def _arm(local: Mapping[str, Rotation], short: str, side: str) -> Angles:
    hang = arms_down(side)
    raised, turned, rolled = euler_rad(local[f"{side}Shoulder"], "ZYX").T
    yield f"{short}_sternoclavicular_abduct", raised
    yield f"{short}_sternoclavicular_rotate", turned
    upper = Rotation.from_euler("x", rolled[:, None]) * local[f"{side}UpperArm"] * hang.inv()
    yield from _turned(f"{short}_shoulder", ("flexion", "twisting", "abduct"), upper)
    bend, twist = _bent(hang * local[f"{side}LowerArm"] * hang.inv())
    yield from _hinged(f"{short}_elbow", bend)
    hand = twist * hang * local[f"{side}Hand"] * hang.inv()
    yield from _turned(f"{short}_wrist", ("pivot", "twisting", "flexion"), hand)


def _fingers(local: Mapping[str, Rotation], short: str, side: str) -> Angles:
    hang = arms_down(side)
    for ours, finger in FINGERS.items():
        root = hang * local[f"{side}{ours}Proximal"] * hang.inv()
        yield from _turned(f"{short}_{finger}1", ("pivot", "twisting", "flexion"), root)
        for part, name in FINGER_BENDS:
            yield f"{short}_{finger}{name}", angle_about(local[f"{side}{ours}{part}"], FINGER_HINGE)
    thumb = hang * local[f"{side}ThumbMetacarpal"] * hang.inv()
    yield from _turned(f"{short}_thumb1", ("flexion", "pivot", "twisting"), thumb)
    for part, name in THUMB_BENDS:
        yield f"{short}_{name}", angle_about(local[f"{side}Thumb{part}"], thumb_hinge(side))


def _leg(local: Mapping[str, Rotation], short: str, side: str) -> Angles:
    yield from _turned(f"{short}_hip", ("flexion", "twisting", "abduct"), local[f"{side}UpperLeg"])
    bend, twist = _bent(local[f"{side}LowerLeg"])
    yield from _hinged(f"{short}_knee", bend)
    turned, raised, tilted = euler_rad(twist * local[f"{side}Foot"], "YXZ").T
    yield f"{short}_ankle_flexion", raised
    yield f"{short}_ankle_twisting", turned
    yield f"{short}_subtalar_flexion", tilted
    yield f"{short}_metatarsal_flexion", angle_about(local[f"{side}Toes"], _ABOUT_X)


def _bent(rotations: Rotation) -> tuple[FloatArray, Rotation]:
    """The bend (T,) of an elbow or a knee about X, and what is left of its turn, for the joint that follows."""
    bend = euler_rad(rotations, "XZY")[:, 0]
    return bend, Rotation.from_euler("x", -bend[:, None]) * rotations


def _hinged(bone: str, bend: FloatArray) -> Angles:
    yield f"{bone}_flexion", bend
    yield f"{bone}_twisting", np.zeros(len(bend))
