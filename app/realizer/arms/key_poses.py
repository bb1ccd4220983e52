"""A clip's key poses on a standing body, for contact sheets and checks; undefined parts are interpolated."""

from dataclasses import dataclass

import numpy as np

from ...model import FloatArray, Hand
from ..body.skeleton import Skeleton
from ..geometry.rotations import IDENTITY
from ..gestures.arm_joints import arm_joints
from ..gestures.gesture import ArmKey, Clip, ClipKey
from .arms import ArmTrack, TimedPose, arm_motion
from .posing import PartialPose, pose_arm
from .rest_poses import rest_pose

REST = "at_side"
PREPARATION_S = 0.5
"""How long before the clip the hands are at rest."""


@dataclass(frozen=True, slots=True, eq=False)
class KeyPose:
    """A key that defines some part of an arm, and the local rotations (J, 4) of the whole body at its time."""

    key: ClipKey
    rotations: FloatArray


def key_poses(skeleton: Skeleton, clip: Clip) -> tuple[KeyPose, ...]:
    """The poses of the keys that define some part of an arm; keys without content, as at a gesture's end, are left out.
    An arm that takes no part hangs at the side."""
    keys = [key for key in clip.keys if {key.left, key.right} - {None, ArmKey()}]
    rotations = np.tile(IDENTITY, (len(keys), len(skeleton.names), 1))
    for side in (Hand.LEFT, Hand.RIGHT):
        rotations[:, skeleton.chain(*arm_joints(side))] = _arm(skeleton, clip, keys, side)
    return tuple(KeyPose(key, pose) for key, pose in zip(keys, rotations, strict=True))


def _arm(skeleton: Skeleton, clip: Clip, keys: list[ClipKey], side: Hand) -> FloatArray:
    """The arm's rotations (K, 19, 4) at the keys."""
    rest = rest_pose(skeleton, side, REST).as_partial()
    track = [TimedPose(keys[0].time_s - PREPARATION_S, rest)]
    for key in keys:
        said = key.left if side is Hand.LEFT else key.right
        pose = rest if said is None else _posed(skeleton, side, said, clip)
        track.append(TimedPose(key.time_s, pose, follow_through=False))
    return arm_motion(ArmTrack(side, tuple(track)), np.array([key.time_s for key in keys]), seed=0)


def _posed(skeleton: Skeleton, side: Hand, said: ArmKey, clip: Clip) -> PartialPose:
    return pose_arm(skeleton, side, said, amplitude=clip.expressivity.amplitude, manner=clip.manner)
