"""Bodies to try physics on: one that stands still, one whose forearm moves and stops."""

from dataclasses import replace

import numpy as np

from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.curves import minimum_jerk
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle, multiply
from understudy.realizer.torso.balance import hips_height_m, set_legs

RATE_HZ = 60


def still_body(skeleton: Skeleton, *, seconds: float = 1.0, leaning_m: float = 0.0) -> BodyMotion:
    """Stands, arms hanging, with the hips so far to the left of the middle."""
    times_s = np.arange(round(seconds * RATE_HZ)) / RATE_HZ
    rotations = np.tile(IDENTITY, (len(times_s), len(skeleton.names), 1))
    for side, sign in (("left", -1), ("right", 1)):
        rotations[:, skeleton.index[side + "UpperArm"]] = from_axis_angle((0.0, 0.0, 1.0), np.array(sign * 1.4))
    hips_m = np.zeros((len(times_s), 3))
    hips_m[:, 0] = leaning_m
    hips_m[:, 1] = hips_height_m(skeleton, hips_m, rotations[:, 0])
    set_legs(skeleton, rotations, hips_m)
    return BodyMotion(times_s, rotations, hips_m)


def striking_body(skeleton: Skeleton) -> BodyMotion:
    """Bends the left elbow by 80° within .25 s, from .5 s on, and keeps it so for 1.5 s."""
    body = still_body(skeleton, seconds=2.25)
    bend = np.radians(-80) * minimum_jerk(np.clip((body.times_s - 0.5) / 0.25, 0, 1))
    rotations = body.rotations.copy()
    joint = skeleton.index["leftLowerArm"]
    rotations[:, joint] = multiply(rotations[:, joint], from_axis_angle((0.0, 1.0, 0.0), bend))
    return replace(body, rotations=rotations)
