"""Behaviours as NLA strips of the armature: moved, made longer, muted or deleted, they say how the BML is to change.

Each strip plays an action of its own on a custom property of the armature, which goes from 0 up to 1 while the
behaviour is fully seen and back: it moves no bone, shows the phases in the graph editor, and has markers at the sync
points. Strips of a kind lie on one track, or on several where they overlap.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, floor
from typing import Any

import numpy as np

from ..schedule.behaviors import Behavior
from ..schedule.bml_document import StripChange
from .actions import Curve, curves_of, mark, new_action
from .layers import OWNER, PREFIX, belongs_to, lay_strip, our_tracks

_BEHAVIOR = "understudy_behavior"
_START, _LENGTH = "understudy_start", "understudy_length"
"""Where the strip was laid and how long it was, in frames."""
_SMALLEST_CHANGE_S = 0.002
"""Less than this is what rounding loses, not what somebody moved."""


@dataclass(frozen=True, slots=True)
class BehaviorStrip:
    """A strip and its behaviour."""

    behavior: Behavior
    strip: Any
    muted: bool


def lay_behaviors(
    armature: Any, behaviors: Sequence[Behavior], performance: str, zero_frame: float, rate_hz: float
) -> None:
    """A strip for each behaviour; `zero_frame` is where second 0 of the recording is."""
    for behavior in behaviors:
        kind = behavior.kind
        armature[property_name(kind)] = 0.0
        start_frame = floor(zero_frame + behavior.start_s * rate_hz)
        action = _action(armature, behavior, performance, _Clock(zero_frame - start_frame, rate_hz))
        action[_START], action[_LENGTH] = start_frame, action.frame_end
        _lay(armature, behavior, action)


def strips_of(armature: Any, performance: str) -> list[BehaviorStrip]:
    """The performance's strips that are there, in order of time."""
    found = []
    for track in armature.animation_data.nla_tracks if armature.animation_data else ():
        for strip in track.strips:
            if belongs_to(strip, performance) and _BEHAVIOR in strip.action:
                behavior = Behavior.from_json(strip.action[_BEHAVIOR])
                found.append(BehaviorStrip(behavior, strip, strip.mute or track.mute))
    return sorted(found, key=lambda each: float(each.strip.frame_start))


def changes_of(
    armature: Any, performance: str, behaviors: Sequence[Behavior], rate_hz: float
) -> dict[str, StripChange]:
    """The changes to the strips since they were added; a behaviour without a strip was deleted."""
    there = {each.behavior.id: each for each in strips_of(armature, performance)}
    found = (
        _change(there[each.id], rate_hz) if each.id in there else StripChange(each.id, removed=True)
        for each in behaviors
    )
    return {change.behavior: change for change in found if change is not None}


def put_back(armature: Any, strip: BehaviorStrip) -> None:
    """Puts a strip back at its first place and unmutes it, on a track with room there: a neighbour on its own track
    would push it away."""
    action = strip.strip.action
    (track,) = [each for each in our_tracks(armature) if any(other == strip.strip for other in each.strips)]
    track.strips.remove(strip.strip)
    if not track.strips:
        armature.animation_data.nla_tracks.remove(track)
    _lay(armature, strip.behavior, action)


def _lay(armature: Any, behavior: Behavior, action: Any) -> None:
    strip = lay_strip(armature, f"{PREFIX} BML {behavior.kind}", action, int(action[_START]), behavior.label)
    strip.extrapolation = "NOTHING"


def property_name(kind: str) -> str:
    """The custom property of the armature that strips of a kind play on."""
    return f"understudy_{kind}"


def _change(strip: BehaviorStrip, rate_hz: float) -> StripChange | None:
    behavior = strip.behavior
    if strip.muted:
        return StripChange(behavior.id, removed=True)
    laid, action = strip.strip, strip.strip.action
    shift_s = (laid.frame_start - action[_START]) / rate_hz
    longer_s = (laid.frame_end - laid.frame_start - action[_LENGTH]) / rate_hz
    shift_s, longer_s = (part if abs(part) >= _SMALLEST_CHANGE_S else 0.0 for part in (shift_s, longer_s))
    return StripChange(behavior.id, shift_s, longer_s) if shift_s or longer_s else None


@dataclass(frozen=True, slots=True)
class _Clock:
    """Frames of a strip's action: second 0 of the recording is at `zero_frame`."""

    zero_frame: float
    rate_hz: float

    def frame(self, time_s: float) -> float:
        return self.zero_frame + time_s * self.rate_hz


def _action(armature: Any, behavior: Behavior, performance: str, clock: _Clock) -> Any:
    frames = max(ceil(clock.frame(behavior.end_s)), 1)
    curve = Curve(f'["{property_name(behavior.kind)}"]', 0, np.zeros(1))
    action = new_action(f"{performance} {behavior.id}", armature, [curve], frames)
    action[OWNER], action[_BEHAVIOR] = performance, behavior.to_json()
    keys = curves_of(action)[0].keyframe_points
    for time_s, value in _phases(behavior):
        keys.insert(clock.frame(time_s), value).interpolation = "LINEAR"
    for point, time_s in behavior.points_s.items():
        mark(action, point, clock.frame(time_s))
    return action


def _phases(behavior: Behavior) -> tuple[tuple[float, float], ...]:
    """When how much of a behaviour is seen: nothing at its ends, all from where it is reached until it relaxes. One
    that begins reached, or ends without a way back, has no phase there."""
    reached_s = behavior.points_s.get("stroke_start", behavior.points_s.get("ready", behavior.start_s))
    left_s = max(behavior.points_s.get("relax", behavior.end_s), reached_s)
    before = ((behavior.start_s, 0.0),) if behavior.start_s < reached_s else ()
    after = ((behavior.end_s, 0.0),) if behavior.end_s > left_s else ()
    return *before, (reached_s, 1.0), (left_s, 1.0), *after
