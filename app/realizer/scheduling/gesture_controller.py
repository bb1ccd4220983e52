"""The gesture controller (paper §3.8, the second): overrides arms and hands with a plan's gestures; the trunk follows.

Only the breathing of the collarbones is kept from the idle arms.

Offset tracks are added to the motion (NGS §3.4): body rotation, curved strokes, progressives. A track's rotation is
applied in the joint's own space after what the key poses make of it, times the gesture's size. Tracks of several
gestures that meet are summed. Joints of the trunk turn as for the side of the leading arm, once for both arms; what
goes beyond a joint's limits is brought back by the last pass.

Strokes of gestures that are asked to be curved are bent (NGS §3.1, §3.4: the trajectory of a phrase). The arm turns
about its shoulder while the stroke lasts, so that the wrist goes beside the straight line, farthest in the middle of
the stroke, and is where it was at both ends: a stroke's times and places stay. What is bent already is bent more; what
is straight goes up and outwards, as a hand is lifted over the straight way. A gesture whose definition has a curved
track is bent by that alone.

Conventions: metres in the world; times are the plan's.
"""

from collections.abc import Iterator

import numpy as np

from ...model import FloatArray, Hand
from ..arms.arm_keys import arm_track
from ..arms.interpolation import set_arms
from ..body.limits import MIRROR
from ..body.motion import BodyMotion
from ..body.movement_style import StrokeLife
from ..body.skeleton import Skeleton, as_far_as_hands, forward
from ..dynamics.calming import calm
from ..dynamics.dragging import drag
from ..dynamics.take_ends import eased_at_the_ends
from ..geometry.curves import clipped, minimum_jerk, plateau
from ..geometry.rotations import (
    cross,
    dot,
    from_rotation_vector,
    inverse,
    length,
    multiply,
    normalized,
    rotate,
)
from ..gestures.gesture import Clip, Markers, OffsetTrack, TrackForm
from ..gestures.gesture_plan import ArmGesture, GesturePlan, arms_of
from ..gestures.library import LEADING
from ..gestures.specifiers import TRUNK
from ..torso.trunk import Accent, AccentCourse, accent_course, follow_with_trunk
from .transitions import stroke_speed_m_s

_SHORTEST_S = 0.4
"""In which an offset comes or goes, also where a gesture blends into the next without a way to rest."""

_RAMP = 0.2
"""The share of a stroke in which circles grow, and in which they end."""


def add_offset_tracks(skeleton: Skeleton, rotations: FloatArray, times_s: FloatArray, plan: GesturePlan) -> None:
    """Add the tracks to local rotations (T, J, 4), in place. Without tracks nothing is done."""
    for arm in plan.gestures:
        clip = arm.placed.clip
        size = min(1.0, clip.expressivity.amplitude * arm.placed.size)
        for track in _tracks_of(clip, arm.side):
            _add(skeleton, rotations, track, arm.side, size * track_course(track, arm.markers, times_s))


def with_tracks(skeleton: Skeleton, rotations: FloatArray, clip: Clip, time_s: float) -> FloatArray:
    """The key pose (J, 4) of a clip at that time of it, with what its tracks add."""
    found = rotations[None].copy()
    for side in arms_of(clip.hand):
        for track in _tracks_of(clip, side):
            _add(skeleton, found, track, side, track_course(track, clip.markers, np.array([time_s])))
    return np.asarray(found[0])


def track_course(track: OffsetTrack, markers: Markers, times_s: FloatArray) -> FloatArray:
    """How much of its angles a track adds at each time (T,), from -1 to 1."""
    share = clipped((times_s - markers.stroke_start) / (markers.stroke_end - markers.stroke_start), 0.0, 1.0)
    match track.form:
        case TrackForm.HELD:
            begins_s = min(markers.start, markers.stroke_end - _SHORTEST_S)
            ends_s = max(markers.end, markers.relax + _SHORTEST_S)
            return plateau(times_s, begins_s, markers.stroke_end, markers.relax, ends_s)
        case TrackForm.CURVED:
            return np.asarray(np.sin(np.pi * share) ** 2)
    ramp = minimum_jerk(clipped(share / _RAMP, 0.0, 1.0)) * minimum_jerk(clipped((1 - share) / _RAMP, 0.0, 1.0))
    return np.asarray(ramp * np.sin(2 * np.pi * track.turns * share + np.radians(track.phase_deg)))


def _tracks_of(clip: Clip, side: Hand) -> Iterator[OffsetTrack]:
    """The tracks that an arm's part of a gesture has: of two arms, the leading one turns the trunk."""
    turns_trunk = len(arms_of(clip.hand)) == 1 or side is LEADING
    return (track for track in clip.tracks if turns_trunk or track.joint not in TRUNK)


def _add(skeleton: Skeleton, rotations: FloatArray, track: OffsetTrack, side: Hand, course: FloatArray) -> None:
    """Turn the track's joint by its angles times the course (T,), on the right side by their mirror image."""
    turned = from_rotation_vector(course[:, None] * np.radians(track.degrees))
    joint = skeleton.index[track.joint if track.joint in TRUNK else side + track.joint]
    rotations[:, joint] = multiply(rotations[:, joint], turned if side is Hand.LEFT else turned * MIRROR)


SIDES = (Hand.LEFT, Hand.RIGHT)
_MUSCLE_S = 0.03

LEAST_ACCENT, FULL_ACCENT_M_S = 0.35, 0.8
"""The trunk's part in the slowest strokes, and the mean speed of a stroke in which it takes its full part."""


def apply_gestures(
    skeleton: Skeleton,
    body: BodyMotion,
    plan: GesturePlan,
    *,
    seed: int,
    noise_scale: float = 1.0,
    accents: AccentCourse | None = None,
    eased_s: FloatArray | None = None,
) -> BodyMotion:
    """The body, changed in place, with the plan's arm motion, and the trunk following it and its `accents`.
    Deterministic for a seed. `noise_scale` (0 to 1) scales the arms' noise. `eased_s` (T,), the times of the plan's
    poses for the body's frames, need not be given."""
    arms, collarbones = skeleton.arms(body.rotations), skeleton.chain("leftShoulder", "rightShoulder")
    breath = _breath(body.rotations.take(collarbones, axis=1))
    tracks = [arm_track(skeleton, side, plan) for side in SIDES]
    eased_s = eased_at_the_ends(body.times_s, plan.style.ends.eased_s) if eased_s is None else eased_s
    width = _MUSCLE_S / float(body.times_s[1] - body.times_s[0]) if len(body.times_s) > 1 else 0.0
    set_arms(arms, tracks, eased_s, seed=seed, noise_scale=noise_scale, width=width)
    wrists_m = calm(skeleton, arms, body.times_s)
    drag(arms, wrists_m, body.times_s, plan.style.dragging, seed=seed, life=noise_scale)
    follow_with_trunk(skeleton, body, wrists_m, accents)
    body.rotations[:, collarbones] = multiply(body.rotations.take(collarbones, axis=1), breath)
    bend_strokes(skeleton, body, plan)
    add_offset_tracks(skeleton, body.rotations, body.times_s, plan)
    return body


def accents_of(plan: GesturePlan, eased_s: FloatArray, life: StrokeLife, *, scale: float) -> AccentCourse:
    """What the plan's strokes do to the trunk by a clock that is eased at the ends (T,); `scale` (0 to 1) is 1 -
    stillness."""
    return accent_course(eased_s, list(_accents(plan)), life, scale=scale)


def _accents(plan: GesturePlan) -> Iterator[Accent]:
    """The strokes of the plan and their repetitions, each of either hand; the two of a gesture of both are half as
    strong."""
    for arm in plan.gestures:
        markers, placed = arm.markers, arm.placed
        strength = min(1.0, max(LEAST_ACCENT, stroke_speed_m_s(placed) / FULL_ACCENT_M_S)) / len(placed.arms)
        yield Accent(markers.stroke_start, markers.stroke, strength, arm.side)
        for repeat in placed.repeats:
            yield Accent(repeat.start_s, repeat.end_s, strength * repeat.amplitude, arm.side)


def _breath(collarbones: FloatArray) -> FloatArray:
    """The deviation of idle collarbones (T, 2, 4) from their mean."""
    mean = normalized(np.sum(collarbones * np.sign(collarbones[..., 3:]), axis=0))
    return multiply(inverse(mean), collarbones)


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
        share = clipped((body.times_s - markers.stroke_start) / stroke_s, 0.0, 1.0)
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
    at_m, turned = forward(skeleton, body.rotations[frames], body.hips_m[frames], as_far_as_hands(skeleton))
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
