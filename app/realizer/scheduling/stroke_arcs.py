"""Bends the strokes of gestures that are asked to be curved (NGS §3.1, §3.4: the trajectory of a phrase).

The arm turns about its shoulder while the stroke lasts, so that the wrist goes beside the straight line, farthest in
the middle of the stroke, and is where it was at both ends: a stroke's times and places stay. What is bent already is
bent more; what is straight goes up and outwards, as a hand is lifted over the straight way. A gesture whose definition
has a curved track (`offset_tracks`) is bent by that alone.

Conventions: metres in the world; times are the plan's.
"""

from collections.abc import Iterator

import numpy as np

from ...model import FloatArray, Hand
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton, forward
from ..geometry.rotations import cross, dot, from_rotation_vector, inverse, length, multiply, rotate
from ..gestures.gesture import TrackForm
from ..gestures.gesture_plan import ArmGesture, GesturePlan

ARC = 0.2
"""How much further the middle of a curved stroke is beside the line, as a share of its length. The paper tells only
straight from curved; of a half circle it would be .5."""

_MOST_DEG = 25.0
_SHORTEST_M = 0.03
"""Strokes of wrist and fingers have no way of the hand's that could be bent."""

_PREFERRED: FloatArray = np.array([0.025, 0.05, 0.015])
"""Outwards, up and ahead, seen from the arm's own side, as shares of the stroke's length: where arcs of strokes go that
are bent less than this."""


def bend_strokes(skeleton: Skeleton, body: BodyMotion, plan: GesturePlan) -> None:
    """Turn the upper arms of gestures with curved strokes, in place."""
    for arm in _bent(plan):
        markers, joint = arm.markers, skeleton.index[arm.side + "UpperArm"]
        stroke_s = markers.stroke_end - markers.stroke_start
        share = np.clip((body.times_s - markers.stroke_start) / stroke_s, 0.0, 1.0)
        turn = np.sin(np.pi * share)[:, None] ** 2 * _turn(skeleton, body, arm)
        body.rotations[:, joint] = multiply(body.rotations[:, joint], from_rotation_vector(turn))


def _bent(plan: GesturePlan) -> Iterator[ArmGesture]:
    """The gestures of arms whose strokes are asked to be curved, and are not already."""
    for arm in plan.gestures:
        has_arc = any(track.form is TrackForm.CURVED for track in arm.placed.clip.tracks)
        if arm.placed.request.curved and not has_arc:
            yield arm


def _turn(skeleton: Skeleton, body: BodyMotion, arm: ArmGesture) -> FloatArray:
    """The rotation vector (3,) of the upper arm in the middle of the stroke, in its own space; zero where there is no
    way to bend."""
    markers = arm.markers
    frames = np.searchsorted(
        body.times_s, [markers.stroke_start, (markers.stroke_start + markers.stroke_end) / 2, markers.stroke_end]
    ).clip(max=len(body.times_s) - 1)
    at_m, turned = forward(skeleton, body.rotations[frames], body.hips_m[frames])
    shoulder, wrist = (skeleton.index[arm.side + name] for name in ("UpperArm", "Hand"))
    way_m, reach_m = at_m[2, wrist] - at_m[0, wrist], at_m[1, wrist] - at_m[1, shoulder]
    length_m = float(length(way_m)[0])
    if length_m < _SHORTEST_M:
        return np.zeros(3)
    angle_rad = min(ARC * length_m / float(length(reach_m)[0]), np.radians(_MOST_DEG))
    preferred_m = length_m * _PREFERRED * [1.0 if arm.side is Hand.LEFT else -1.0, 1.0, 1.0]
    bend_m = at_m[1, wrist] - (at_m[0, wrist] + at_m[2, wrist]) / 2
    about = cross(_of_length_1(reach_m), _beside(way_m, reach_m, bend_m + preferred_m))
    return np.asarray(angle_rad * rotate(inverse(turned[1, shoulder]), about))


def _beside(way_m: FloatArray, reach_m: FloatArray, preferred: FloatArray) -> FloatArray:
    """The direction (3,) across both stroke and arm in which the arc goes; where the stroke is along the arm, that
    across the arm which is nearest to the preferred one."""
    arm = _of_length_1(reach_m)
    across = cross(_of_length_1(way_m), arm)
    across = across * (1.0 if float(dot(across, preferred)[0]) >= 0 else -1.0)
    free = _of_length_1(preferred - dot(preferred, arm) * arm)
    return _of_length_1(across + (1 - length(across)) * free)


def _of_length_1(vector: FloatArray) -> FloatArray:
    return np.asarray(vector / np.maximum(length(vector), 1e-9))
