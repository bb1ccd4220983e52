"""Reads a body back from MPEG-4 body animation parameters: the inverse of `bap.py`, of either version.

Of others' files every vertebra counts: those below the tenth thoracic one turn our spine, those up to the seventh the
chest, the other thoracic ones the upper chest, the cervical ones the neck. What our body has no joint for is not read.
"""

from collections.abc import Iterator, Mapping
from functools import reduce

import numpy as np
from scipy.spatial.transform import Rotation

from ...model import FloatArray
from ...model.formats import BapVersion
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.rotations import with_continuous_signs
from .bap import LIMBS, MILLIMETRES, UNIT_RAD, sign_of
from .layout import (
    FINGER_BENDS,
    FINGER_HINGE,
    FINGERS,
    SIDES,
    THUMB_BENDS,
    ReadParameters,
    arms_down,
    thumb_hinge,
)

VERTEBRAE: Mapping[str, tuple[str, ...]] = {
    "spine": ("sacroiliac", *(f"vl{number}" for number in range(5, 0, -1)), "vt12", "vt11"),
    "chest": ("vt10", "vt9", "vt8", "vt7"),
    "upperChest": tuple(f"vt{number}" for number in range(6, 0, -1)),
    "neck": tuple(f"vc{number}" for number in range(7, 0, -1)),
    "head": ("skullbase",),
}
"""The vertebrae that turn each joint of our trunk, from below."""


class _Angles:
    """The angles of a file in radians, about their axes, by the name of the parameter; 0 where it is not set."""

    def __init__(self, file: ReadParameters) -> None:
        self._file = file
        self._is_signed = file.version != BapVersion.GRETA

    def of(self, name: str) -> FloatArray:
        is_thumbs = name[2:] in dict(THUMB_BENDS).values()  # written about their own hinge, towards the palm
        sign = sign_of(name) if self._is_signed and name and not is_thumbs else 1.0
        return self._file.numbers.get(name, np.zeros(self._file.frames)) * UNIT_RAD * sign

    def turned(self, order: str, *names: str) -> Rotation:
        """The turns about these axes, each as those before leave it."""
        return Rotation.from_euler(order, np.stack([self.of(name) for name in names], axis=1))

    def about(self, axis: FloatArray, name: str) -> Rotation:
        return Rotation.from_rotvec(self.of(name)[:, None] * (axis / np.linalg.norm(axis)))


def from_bap(file: ReadParameters, skeleton: Skeleton) -> BodyMotion:
    """The motion of our joints, eyes ahead."""
    angles = _Angles(file)
    read = _greta if file.version == BapVersion.GRETA else _mpeg4
    found = dict(read(angles))
    rotations = np.zeros((file.frames, len(skeleton.names), 4))
    rotations[:, :, 3] = 1.0
    for joint, turn in found.items():
        rotations[:, skeleton.index[joint]] = turn.as_quat()
    ways = [
        file.numbers.get(f"HumanoidRoot_tr_{way}", np.zeros(file.frames)) for way in ("lateral", "vertical", "frontal")
    ]
    hips_m = skeleton.offsets_m[0] + np.stack(ways, axis=1) / MILLIMETRES
    times_s = np.arange(file.frames) / file.rate_hz
    return BodyMotion(times_s, with_continuous_signs(rotations), hips_m)


Turns = Iterator[tuple[str, Rotation]]
"""Our joints and their turns (T,) from the T-pose."""


def _mpeg4(angles: _Angles) -> Turns:
    root = "HumanoidRoot_rt_body"
    yield "hips", angles.turned("XZY", f"{root}_tilt", f"{root}_roll", f"{root}_turn")
    for joint, bones in VERTEBRAE.items():
        turns = (angles.turned("XZY", f"{bone}_tilt", f"{bone}_roll", f"{bone}_torsion") for bone in bones)
        yield joint, reduce(Rotation.__mul__, turns)
    for short, side in SIDES:
        hang = arms_down(side)
        collar = f"{short}_sternoclavicular"
        yield f"{side}Shoulder", angles.turned("YZ", f"{collar}_rotate", f"{collar}_abduct")
        for part, (order, names) in LIMBS.items():
            turn = angles.turned(order, *(f"{short}_{name}" if name else "" for name in names))
            yield side + part, _from_hanging(part, turn, hang)
        for ours, finger in FINGERS.items():
            parameters = (f"{short}_{finger}1_{turn}" for turn in ("flexion", "pivot", "twisting"))
            yield f"{side}{ours}Proximal", hang.inv() * angles.turned("ZXY", *parameters) * hang
        yield from _bends(angles, short, side)


def _from_hanging(part: str, turn: Rotation, hang: Rotation) -> Rotation:
    """A turn from the pose with the arms down, as one from the T-pose."""
    if part == "UpperArm":
        return turn * hang
    return hang.inv() * turn * hang if part in {"LowerArm", "Hand", "ThumbMetacarpal"} else turn


def _bends(angles: _Angles, short: str, side: str) -> Turns:
    """The outer joints of fingers and thumb."""
    for ours, finger in FINGERS.items():
        for part, name in FINGER_BENDS:
            yield f"{side}{ours}{part}", angles.about(FINGER_HINGE, f"{short}_{finger}{name}")
    for part, name in THUMB_BENDS:
        bend = angles.about(thumb_hinge(side), f"{short}_{name}")
        yield f"{side}Thumb{part}", bend


def _greta(angles: _Angles) -> Turns:
    yield "hips", _about_all(angles, "HumanoidRoot_rt_body", "roll", "turn", "tilt")
    for joint, bones in VERTEBRAE.items():
        yield joint, reduce(Rotation.__mul__, (_about_all(angles, bone, "roll", "torsion", "tilt") for bone in bones))
    for short, side in SIDES:
        hang = arms_down(side)
        collar = f"{short}_sternoclavicular"
        yield f"{side}Shoulder", angles.turned("ZY", f"{collar}_abduct", f"{collar}_rotate")
        yield f"{side}UpperArm", _about_all(angles, f"{short}_shoulder", "abduct", "twisting", "flexion") * hang
        yield (
            f"{side}LowerArm",
            hang.inv() * angles.turned("XY", f"{short}_elbow_flexion", f"{short}_elbow_twisting") * hang,
        )
        yield f"{side}Hand", hang.inv() * _about_all(angles, f"{short}_wrist", "flexion", "twisting", "pivot") * hang
        for ours, finger in FINGERS.items():
            root = _about_all(angles, f"{short}_{finger}1", "flexion", "twisting", "pivot")
            yield f"{side}{ours}Proximal", hang.inv() * root * hang
        thumb = _about_all(angles, f"{short}_thumb1", "twisting", "pivot", "flexion")
        yield f"{side}ThumbMetacarpal", hang.inv() * thumb * hang
        yield from _bends(angles, short, side)
        yield f"{side}UpperLeg", _about_all(angles, f"{short}_hip", "abduct", "twisting", "flexion")
        yield f"{side}LowerLeg", angles.turned("XY", f"{short}_knee_flexion", f"{short}_knee_twisting")
        ankle = (f"{short}_ankle_twisting", f"{short}_ankle_flexion", f"{short}_subtalar_flexion")
        yield f"{side}Foot", angles.turned("YXZ", *ankle)
        yield f"{side}Toes", angles.turned("X", f"{short}_metatarsal_flexion")


def _about_all(angles: _Angles, bone: str, *about_z_y_x: str) -> Rotation:
    return angles.turned("ZYX", *(f"{bone}_{name}" for name in about_z_y_x))
