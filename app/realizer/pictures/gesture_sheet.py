"""Draws gestures of the library: their key poses, and how fast the hand goes through them, with the tension, continuity
and bias of the curve at each key.

The speeds are those of the gesture made alone, from rest to rest, as the realizer makes it, without noise. Seconds
count from the start of the clip. Needs matplotlib, the extra `understudy[plot]`; the command line checks for it.

A clip's key poses on a standing body, for contact sheets and checks; undefined parts are interpolated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ...model import Behavior, Channel, FloatArray, Hand, Level, Schedule, SyncPoints
from ..arms.arm_keys import arm_track
from ..arms.interpolation import ArmTrack, TimedPose, arm_motion
from ..arms.posing import PartialPose, pose_arm
from ..arms.rest_poses import rest_pose
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton, arm_joints, forward
from ..geometry.rotations import IDENTITY
from ..gestures.gesture import ArmKey, Clip, ClipKey, KeyCurve
from ..gestures.gesture_plan import ArmGesture, GesturePlan
from ..scheduling.gesture_controller import apply_gestures, with_tracks
from ..scheduling.planning import plan_gestures
from .contact_sheet import Still, draw_stills
from .speed_plot import LINE, PHASES

if TYPE_CHECKING:
    from matplotlib.axes import Axes


BEFORE_S, AFTER_S = 1.5, 2.0
"""How long the hands rest before the clip and have to come back after it."""

RATE_HZ = 120
SAME_TIME_S = 1e-3
LABEL_SIZE = 7.0
COLOURS = {Hand.RIGHT: LINE, Hand.LEFT: "#8e5ea2"}


@dataclass(frozen=True, slots=True)
class _OneClip:
    """A library of one clip."""

    clip: Clip

    def clips(self, category: str, level: Level, hand: Hand) -> tuple[Clip, ...]:
        fits = (category, level, hand) == (self.clip.category, self.clip.level, self.clip.hand)
        return (self.clip,) if fits else ()

    def nearest(self, lexeme: str) -> str | None:
        return lexeme if lexeme == self.clip.category else None


def draw_gestures(skeleton: Skeleton, clips: Sequence[Clip]) -> tuple[bytes, int]:
    """The picture as PNG, and how many key poses it has."""
    stills = [
        Still(
            f"{clip.name}  {pose.key.time_s:.2f} s\n{pose.key.type}{_written(pose.key)}",
            with_tracks(skeleton, pose.rotations, clip, pose.key.time_s),
        )
        for clip in clips
        for pose in key_poses(skeleton, clip)
    ]
    charts: list[Callable[[Axes], None]] = [partial(_draw_clip, skeleton, clip) for clip in clips]
    return draw_stills(stills, skeleton, faces=False, charts=charts), len(stills)


def wrist_speeds_m_s(skeleton: Skeleton, plan: GesturePlan) -> tuple[FloatArray, dict[Hand, FloatArray]]:
    """Times (T,) of a plan, and the speed (T,) of the wrist of each hand that gestures in it."""
    times_s = np.arange(0.0, plan.end_s, 1 / RATE_HZ)
    rest = np.tile(IDENTITY, (len(times_s), len(skeleton.names), 1))
    hips_m = np.tile(skeleton.offsets_m[0], (len(times_s), 1))
    body = apply_gestures(skeleton, BodyMotion(times_s, rest, hips_m), plan, seed=0, noise_scale=0.0)
    places_m, _turns = forward(skeleton, body.rotations, body.hips_m)
    speeds = {}
    for hand in sorted({each.side for each in plan.gestures}, reverse=True):
        velocity = np.gradient(places_m[:, skeleton.index[f"{hand}Hand"]], 1 / RATE_HZ, axis=0)
        speeds[hand] = np.asarray(np.linalg.norm(velocity, axis=-1))
    return times_s, speeds


def alone(clip: Clip) -> GesturePlan:
    """The clip as the only gesture, with its own hold."""
    markers, at_s = clip.markers, BEFORE_S
    sync = SyncPoints(at_s, at_s + markers.end, stroke=at_s + markers.stroke, relax=at_s + markers.relax)
    asked = Behavior("gesture", Channel.GESTURE, clip.category, sync, 0, 0, 1.0, hand=clip.hand)
    schedule = Schedule((asked,), at_s + markers.end + AFTER_S, agitation=clip.level)
    return plan_gestures(_OneClip(clip), schedule, seed=0)


def _draw_clip(skeleton: Skeleton, clip: Clip, axes: Axes) -> None:
    """The speeds of the hands, the phases behind them, and the curve's numbers at each key."""
    plan = alone(clip)
    times_s, speeds = wrist_speeds_m_s(skeleton, plan)
    arm = plan.gestures[0]
    start_s = arm.placed.offset_s
    for start, end, colour in PHASES.values():
        axes.axvspan(getattr(arm.markers, start) - start_s, getattr(arm.markers, end) - start_s, color=colour, lw=0)
    for hand, speed in speeds.items():
        axes.plot(times_s - start_s, speed, color=COLOURS[hand], linewidth=1.2, label=f"{hand} wrist")
    highest = max(float(speed.max()) for speed in speeds.values())
    for timed in _keys_of(skeleton, arm, plan):
        axes.axvline(timed.time_s - start_s, color="#555555", linewidth=0.5, linestyle=":")
        told = f"T {timed.tension:+.2f}\nC {timed.continuity:+.2f}\nB {timed.bias:+.2f}"
        axes.text(timed.time_s - start_s, highest * 1.05, told, fontsize=LABEL_SIZE, ha="center", va="bottom")
    axes.set_xlim(arm.markers.start - start_s - 0.1, arm.markers.end - start_s + 0.2)
    axes.set_ylim(0, highest * 1.4)
    axes.set_ylabel(f"{clip.name}, m/s", fontsize=8)
    axes.set_xlabel("seconds", fontsize=8)
    axes.legend(loc="center right", fontsize=LABEL_SIZE, frameon=False)


def _keys_of(skeleton: Skeleton, arm: ArmGesture, plan: GesturePlan) -> Iterator[TimedPose]:
    """The keys of an arm's track that belong to its gesture."""
    for key in arm_track(skeleton, arm.side, plan).keys:
        if arm.markers.start - SAME_TIME_S <= key.time_s <= arm.markers.end - SAME_TIME_S:
            yield key


def _written(key: ClipKey) -> str:
    """What the frame itself says of the curve."""
    said = ((name, getattr(key.curve, name)) for name in KeyCurve.__slots__)
    return "".join(f"  {name[0].upper()} {value:g}" for name, value in said if value is not None)


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
