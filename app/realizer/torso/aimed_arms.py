"""Arms that point stay on the line from shoulder to target, however the trunk stands and leans.

Poses are made for an upright body (`understudy.realizer.arms.posing`), and a stance of some degrees to the side would
point past its target by as much. The upper arm is turned back as the hand gets there, and let go with the gesture.

Conventions: seconds; rotations as in `understudy.realizer.geometry.rotations`.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...model import FloatArray
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.rotations import IDENTITY, inverse, multiply, slerp
from ..gestures.gesture_plan import ArmGesture

_TRUNK = ("hips", "spine", "chest", "upperChest")
_LEFT_S = 0.4
"""After the gesture's relax an arm that goes elsewhere has given up its aim."""


def with_aimed_arms(skeleton: Skeleton, body: BodyMotion, arms: Sequence[ArmGesture]) -> BodyMotion:
    """The body whose pointing arms are on their lines."""
    aimed = [arm for arm in arms if arm.placed.aim_m is not None and not arm.placed.follows]
    if not aimed:
        return body
    rotations = body.rotations.copy()
    for arm in aimed:
        share = _share(arm, body.times_s)
        frames = np.flatnonzero(share > 0)
        rotations[frames] = _turned(skeleton, rotations[frames], arm, share[frames])
    return replace(body, rotations=rotations)


def _share(arm: ArmGesture, times_s: FloatArray) -> FloatArray:
    """How much the arm is on its line (T,): from the start of the gesture more and more, wholly from the stroke's."""
    markers = arm.markers
    left_s = max(markers.end, markers.relax + _LEFT_S)
    points_s = np.maximum.accumulate([markers.start, markers.stroke_start, markers.relax, left_s])
    share = np.interp(times_s, points_s, [0.0, 1.0, 1.0, 0.0])
    return np.asarray(share * share * (3 - 2 * share))


def _turned(skeleton: Skeleton, rotations: FloatArray, arm: ArmGesture, share: FloatArray) -> FloatArray:
    """Local rotations with the upper arm turned back, by its share, by what the trunk is turned from upright."""
    chest = rotations[:, 0]
    for joint in skeleton.chain(*_TRUNK[1:]):
        chest = multiply(chest, rotations[:, joint])
    collarbone, upper = skeleton.chain(f"{arm.side.value}Shoulder", f"{arm.side.value}UpperArm")
    carrying = multiply(chest, rotations[:, collarbone])
    upright = slerp(np.broadcast_to(IDENTITY, chest.shape), inverse(chest), share)
    turned = multiply(upright, multiply(carrying, rotations[:, upper]))
    result = rotations.copy()
    result[:, upper] = multiply(inverse(carrying), turned)
    return result
