"""A scene as the tracks of a timeline: its sounds, and the behaviours of each armature by their kinds."""

from collections import defaultdict
from math import ceil, floor
from pathlib import Path
from typing import Any

import bpy

from ..schedule.otio import TimelineClip, TimelineTrack
from .behavior_strips import BehaviorStrip, strips_of
from .sounds import strips_of_scene

_KINDS = ("gesture", "posture", "head", "gaze", "face", "eyes")


def tracks_of(scene: Any) -> list[TimelineTrack]:
    """Sounds by their channels, then each armature's behaviours."""
    found = _sounds(scene)
    for armature in (each for each in scene.objects if each.type == "ARMATURE"):
        clips = defaultdict(list)
        for record in armature.understudy.performances:
            for strip in strips_of(armature, record.name):
                if not strip.muted:
                    clips[strip.behavior.kind].append(_clip(strip, record.name))
        found += [
            TimelineTrack(f"{armature.name} {kind}", "Video", tuple(clips[kind])) for kind in _KINDS if clips[kind]
        ]
    return found


def _sounds(scene: Any) -> list[TimelineTrack]:
    channels = defaultdict(list)
    for strip in strips_of_scene(scene):
        if strip.type != "SOUND":
            continue
        path = Path(bpy.path.abspath(strip.sound.filepath))
        about = {name: strip[name] for name in ("text", "character") if strip.get(name)}
        start, end = round(strip.frame_final_start), round(strip.frame_final_end)
        offset = round(strip.frame_offset_start)
        channels[strip.channel].append(TimelineClip(strip.name, start, end, path.as_uri(), offset, about))
    return [TimelineTrack(f"sound {channel}", "Audio", tuple(channels[channel])) for channel in sorted(channels)]


def _clip(strip: BehaviorStrip, performance: str) -> TimelineClip:
    behavior, laid = strip.behavior, strip.strip
    about = {
        "performance": performance,
        "id": behavior.id,
        "lexeme": behavior.lexeme,
        "words": behavior.words,
        "function": behavior.function,
        "rule": behavior.rule,
    }
    start = floor(laid.frame_start)
    markers = tuple((marker.name, start + marker.frame) for marker in laid.action.pose_markers)
    metadata = {name: value for name, value in about.items() if value}
    return TimelineClip(behavior.label, start, ceil(laid.frame_end), about=metadata, markers=markers)
