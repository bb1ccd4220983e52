"""Body parameters for Greta's player, whose skeleton has signs and an order of its own (`JointType`, `Quaternion` and
`Base_greta_fingers_bis.bvh` in github.com/isir/greta).

Every parameter is the angle about its axis, never against it, so that elbows bend by negative angles and knees by
positive ones; a joint turns by Rz·Ry·Rx. An elbow and a knee have no third angle and cannot twist after they have
bent: the twist of a forearm turns the hand, that of a lower leg the foot. An ankle is followed by the subtalar joint. A
collar bone has no angle about X, which the upper arm has instead. The outer joints of thumbs bend about X.
"""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from ....model import FloatArray
from ...body.motion import Motion
from ...body.skeleton import Skeleton
from .angles import (
    FINGER_BENDS,
    FINGER_HINGE,
    FINGERS,
    THUMB_BENDS,
    TRUNK,
    angle_about,
    arms_down,
    euler_rad,
    thumb_hinge,
)
from .layout import SIDES

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
