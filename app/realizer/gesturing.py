"""Lays a plan's gestures over the body (paper §3.8, the second controller): arms, hands and the trunk's part.

The arms take the place of those that hung idly; only the breath stays in the collarbones. The trunk's part is added:
it turns towards where the hands are and leans after them when they reach out (towards-natural §3.4 has offset tracks
for that), a few degrees, slowly, and a little before them, as the larger masses move first.

Conventions: radians, metres; wrists in the hips' space of the upright body (x to the own side, y up, z away).
"""

from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter1d

from app.model import FloatArray, Hand
from app.realizer.arm_keys import arm_track
from app.realizer.arms import arm_motion
from app.realizer.gesture_plan import GesturePlan
from app.realizer.motion import BodyMotion
from app.realizer.posing import arm_joints, wrist_of
from app.realizer.rotations import from_rotation_vector, inverse, multiply, normalized
from app.realizer.skeleton import Skeleton

SIDES = (Hand.LEFT, Hand.RIGHT)

_TRUNK = {"spine": 0.4, "chest": 0.35, "upperChest": 0.25}
"""Each joint's share of what the trunk does."""

_TURN_RAD_M = 0.25
_LEAN_RAD_M = 0.22
_RAISE_RAD_M = -0.10
_SIDEWAYS_RAD_M = 0.08
"""How far the trunk turns, leans forward, straightens and leans aside for each metre that the hands are off rest."""

_MUSCLE_S = 0.03
_SMOOTHING_S = 0.22
_AHEAD_S = 0.08


def gesture(skeleton: Skeleton, body: BodyMotion, plan: GesturePlan, *, seed: int) -> BodyMotion:
    """The body with the arms of the plan, and the trunk with them. The same seed gives the same motion."""
    rotations = body.rotations.copy()
    wrists = []
    for side in SIDES:
        joints = skeleton.chain(*arm_joints(side))
        arm = _smooth(arm_motion(arm_track(skeleton, side, plan), body.times_s, seed=seed), body.times_s)
        wrists.append(wrist_of(skeleton, side, arm))
        arm[:, 0] = multiply(arm[:, 0], _breath(body.rotations[:, joints[0]]))
        rotations[:, joints] = arm
    for joint, turn in _trunk(body.times_s, *wrists).items():
        index = skeleton.index[joint]
        rotations[:, index] = multiply(rotations[:, index], turn)
    return replace(body, rotations=rotations)


def _smooth(rotations: FloatArray, times_s: FloatArray) -> FloatArray:
    """Rotations (T, J, 4) without the corners of acceleration that splines have at their keys: muscles have none."""
    if len(times_s) < 2:
        return rotations
    width = _MUSCLE_S / float(times_s[1] - times_s[0])
    return normalized(gaussian_filter1d(rotations, width, axis=0, mode="nearest"))


def _breath(collarbone: FloatArray) -> FloatArray:
    """What an idle collarbone (T, 4) does about its own mean."""
    mean = normalized(np.sum(collarbone * np.sign(collarbone[:, 3:]), axis=0))
    return multiply(inverse(mean), collarbone)


def _trunk(times_s: FloatArray, left_m: FloatArray, right_m: FloatArray) -> dict[str, FloatArray]:
    """The trunk's joints' turns (T, 4), from where the wrists (T, 3) are, one and the other."""
    left, right = (_followed(times_s, wrist_m - _REST_M) for wrist_m in (left_m, right_m))
    out, up, away = (np.stack([left[:, axis], right[:, axis]]) for axis in range(3))
    turn = np.stack(
        [
            _LEAN_RAD_M * np.maximum(away, 0.0).max(axis=0) + _RAISE_RAD_M * np.maximum(up - 0.4, 0.0).max(axis=0),
            _TURN_RAD_M * (out[0] - out[1]) + 0.1 * (away[1] - away[0]),
            _SIDEWAYS_RAD_M * (up[0] - up[1]),
        ],
        axis=-1,
    )
    return {joint: from_rotation_vector(share * turn) for joint, share in _TRUNK.items()}


_REST_M: FloatArray = np.array([0.15, 0.05, 0.20])
_REST_M.setflags(write=False)


def _followed(times_s: FloatArray, offset_m: FloatArray) -> FloatArray:
    """The offsets (T, 3), smoothed and a little ahead."""
    if len(times_s) < 2:
        return offset_m
    frame_s = float(times_s[1] - times_s[0])
    smooth = gaussian_filter1d(offset_m, _SMOOTHING_S / frame_s, axis=0, mode="nearest")
    ahead = [np.interp(times_s + _AHEAD_S, times_s, smooth[:, axis]) for axis in range(3)]
    return np.stack(ahead, axis=-1)
