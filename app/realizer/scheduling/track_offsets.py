"""Adds the offset tracks of a plan's gestures to the motion (NGS §3.4): body rotation, curved strokes, progressives.

A track's rotation is applied in the joint's own space after what the key poses make of it, times the gesture's size.
Tracks of several gestures that meet are summed. Joints of the trunk turn as for the side of the leading arm, once for
both arms; what goes beyond a joint's limits is brought back by the last pass.
"""

from collections.abc import Iterator

import numpy as np

from ...model import FloatArray, Hand
from ..body.limits import MIRROR
from ..body.skeleton import Skeleton
from ..geometry.easing import minimum_jerk, plateau
from ..geometry.rotations import from_rotation_vector, multiply
from ..gestures.clips import LEADING
from ..gestures.gesture import Clip, Markers, OffsetTrack, TrackForm
from ..gestures.gesture_plan import GesturePlan, arms_of
from ..gestures.offset_tracks import TRUNK

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
    share = np.clip((times_s - markers.stroke_start) / (markers.stroke_end - markers.stroke_start), 0.0, 1.0)
    match track.form:
        case TrackForm.HELD:
            begins_s = min(markers.start, markers.stroke_end - _SHORTEST_S)
            ends_s = max(markers.end, markers.relax + _SHORTEST_S)
            return plateau(times_s, begins_s, markers.stroke_end, markers.relax, ends_s)
        case TrackForm.CURVED:
            return np.asarray(np.sin(np.pi * share) ** 2)
    ramp = minimum_jerk(np.clip(share / _RAMP, 0.0, 1.0)) * minimum_jerk(np.clip((1 - share) / _RAMP, 0.0, 1.0))
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
