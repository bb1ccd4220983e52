"""Ways between the key poses of an arm that keep within the shoulder's limits.

The shortest turn from one pose of the upper arm to another may lead where no shoulder goes: from a hand on the hip, its
elbow out and back, to one over the head it leads behind the body. The limits bring such a frame back to their nearest
end, and the nearest end changes from one frame to the next where the arm has turned over. So a way of this kind goes
halfway between the angles at its ends instead: those are within the limits if both ends are.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import cos, radians

import numpy as np

from ...model import FloatArray, Hand
from ..body.limits import MIRROR, shoulder_deg, shoulder_turned, within_shoulder_limits
from ..geometry.rotations import angle_between, dot, inverse, multiply, nearest_sign, slerp
from .interpolation import TimedPose
from .posing import PartialPose

MOST_BEYOND_DEG = 30.0
"""How far beyond its limits a way may lead: half of what an arm that turns over is brought back by at least; ways that
need no more are never far from 0."""

_SHORTEST_DEG = 120.0
"""Shorter turns of the upper arm are not looked at, for speed: those that lead so far are 165° long at least."""
_LOOKED_AT: FloatArray = np.linspace(0.0, 1.0, 11)[1:-1]
_COLLARBONE, _UPPER_ARM = 0, 1
"""Rows of a pose."""


def within_the_shoulder(side: Hand, keys: Sequence[TimedPose]) -> tuple[TimedPose, ...]:
    """The keys of an arm, at rising times, the first a whole pose, and one more in the middle of each way that would
    lead beyond the shoulder's limits."""
    at = {key.time_s: key for key in keys}
    for time_s, upper_arm in _halfway_there(side, keys):
        parts = np.full_like(keys[0].pose.parts, np.nan)
        parts[_UPPER_ARM] = upper_arm
        pose, other = PartialPose(parts), at.get(time_s)
        at[time_s] = replace(other, pose=pose.over(other.pose)) if other else TimedPose(time_s, pose)
    return tuple(at[time_s] for time_s in sorted(at))


def _halfway_there(side: Hand, keys: Sequence[TimedPose]) -> Iterator[tuple[float, FloatArray]]:
    """The times of the middle of those ways that lead too far, and the upper arm (4,) there."""
    times_s, poses = _placed(keys)
    turned = np.abs(dot(poses[1:, _UPPER_ARM], poses[:-1, _UPPER_ARM])[:, 0])
    far = np.flatnonzero(turned < cos(radians(_SHORTEST_DEG / 2)))
    if not len(far):
        return
    mirror = np.ones(4) if side is Hand.LEFT else MIRROR
    ones, others = poses[far] * mirror, poses[far + 1] * mirror
    for number in np.flatnonzero(_beyond_deg(ones, others) > MOST_BEYOND_DEG).tolist():
        way = far[number]
        yield float(times_s[way] + times_s[way + 1]) / 2, _halfway(ones[number], others[number]) * mirror


def _placed(keys: Sequence[TimedPose]) -> tuple[FloatArray, FloatArray]:
    """The keys that say where the upper arm is: their times (N,), collarbone and upper arm (N, 2, 4)."""
    poses = np.array([key.pose.parts[: _UPPER_ARM + 1] for key in keys])
    said = ~np.isnan(poses[..., 3])
    last_said = np.maximum.accumulate(np.where(said[:, _COLLARBONE], np.arange(len(keys)), 0))
    poses[:, _COLLARBONE] = poses[last_said, _COLLARBONE]
    there = said[:, _UPPER_ARM]
    return np.array([key.time_s for key in keys])[there], poses[there]


def _beyond_deg(ones: FloatArray, others: FloatArray) -> FloatArray:
    """By how many degrees (N,) ways from one pose to another (N, 2, 4) are brought back at most."""
    on_way = slerp(ones[:, None], others[:, None], _LOOKED_AT[:, None])
    orientation = multiply(on_way[:, :, _COLLARBONE], on_way[:, :, _UPPER_ARM])
    return np.asarray(np.degrees(angle_between(orientation, within_shoulder_limits(orientation))).max(axis=1))


def _halfway(one: FloatArray, other: FloatArray) -> FloatArray:
    """The upper arm (4,) between two poses (2, 4) of collarbone and upper arm, with the mean of their angles."""
    angles_deg = shoulder_deg(multiply(*np.stack((one, other), axis=1))).mean(axis=0)
    collarbone = slerp(one[_COLLARBONE], other[_COLLARBONE], np.array(0.5))
    return nearest_sign(multiply(inverse(collarbone), shoulder_turned(angles_deg)), one[_UPPER_ARM])
