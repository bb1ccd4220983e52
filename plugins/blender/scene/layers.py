"""A clip on an armature: actions for body, head, gaze and face, each on an NLA track of its own, with a marker for
each behaviour that it shows.

A track takes one line after the other; a line that overlaps another goes onto a further track.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

import bpy

from ..motion.clip import Clip
from ..retargeting.face_weights import face_weights
from ..retargeting.matching import BoneMap
from ..retargeting.retargeting import BonePoses, retarget
from ..retargeting.skeleton import EYES, HEAD
from ..schedule.behaviors import LAYERS, Behavior
from .actions import Curve, assign_slot, mark, new_action
from .armatures import rest_of
from .rotation_modes import rotation_curves

PREFIX = "Understudy"
LAYER = "understudy_layer"
"""The custom property of an action that names its layer; behaviours' actions have none."""
OWNER = "understudy_performance"
"""The custom property of an action that names the performance it belongs to."""


@dataclass(frozen=True, slots=True)
class Span:
    """The performance that an action belongs to, the scene's frame of its first, and how many frames later it ends."""

    performance: str
    start_frame: int
    frames: int


def lay_clip(armature: Any, found: BoneMap, clip: Clip, performance: str, start_frame: int) -> list[Any]:
    """The clip's actions on their tracks; `clip` is at the scene's rate and `start_frame` is the scene's frame of the
    clip's first. Each action names its performance."""
    span = Span(performance, start_frame, max(clip.frames - 1, 1))
    poses = retarget(clip, rest_of(armature, found), found.table)
    made = []
    for layer, bones in _bones_by_layer(found, poses).items():
        curves = (curve for bone in bones for curve in _bone_curves(armature, bone, poses))
        made.append(_laid(armature, layer, curves, span))
    for mesh in face_meshes(armature):
        keys = mesh.data.shape_keys
        weights = face_weights((key.name for key in keys.key_blocks), clip)
        if weights:
            curves = (Curve(f'key_blocks["{bpy.utils.escape_identifier(n)}"].value', 0, w) for n, w in weights.items())
            made.append(_laid(keys, "face", curves, span))
    return made


def mark_behaviors(actions: Sequence[Any], behaviors: Sequence[Behavior], rate_hz: float, start_s: float) -> None:
    """Marks in each layer's actions when its behaviours are fully seen, by name, function and rule; the custom
    property `understudy_behaviors` of an action has all that is known of them, as JSON."""
    for action in actions:
        shown = [each for each in behaviors if LAYERS[each.kind] == action[LAYER]]
        for each in shown:
            mark(action, f"{each.lexeme} · {each.why}", (each.stroke_s - start_s) * rate_hz)
        action["understudy_behaviors"] = json.dumps([json.loads(each.to_json()) for each in shown])


def take_away(armature: Any, performance: str) -> None:
    """Removes a performance's strips with their actions, and tracks of ours that are left empty."""
    for _mesh, owner in owners(armature):
        for track in our_tracks(owner):
            for strip in [each for each in track.strips if belongs_to(each, performance)]:
                action = strip.action
                track.strips.remove(strip)
                bpy.data.actions.remove(action)
            if not track.strips:
                owner.animation_data.nla_tracks.remove(track)


def put_aside(armature: Any, performance: str, entries: Any) -> None:
    """Takes a performance's strips from their tracks into `entries`, a collection that keeps their actions."""
    entries.clear()
    for mesh, owner in owners(armature):
        for track in our_tracks(owner):
            for strip in [each for each in track.strips if belongs_to(each, performance)]:
                _entered(entries.add(), strip, mesh, strip.mute or track.mute)
                track.strips.remove(strip)
            if not track.strips:
                owner.animation_data.nla_tracks.remove(track)


def lay_again(armature: Any, entries: Any) -> None:
    """Restores the stored strips at their places, and empties the collection."""
    for entry in entries:
        if entry.action is None:
            continue
        owner = entry.mesh.data.shape_keys if entry.mesh else armature
        strip = lay_strip(owner, entry.track, entry.action, round(entry.start_frame), entry.name)
        strip.frame_start_ui, strip.frame_end_ui = entry.start_frame, entry.end_frame
        strip.mute = entry.mute
        if LAYER in entry.action:
            _cross_fade(owner.animation_data.nla_tracks, strip, entry.track)
        else:
            strip.extrapolation = "NOTHING"
    entries.clear()


def owners(armature: Any) -> list[tuple[Any, Any]]:
    """The owners of the strips: the armature (with None), and the shape keys of its meshes (with the mesh)."""
    return [(None, armature), *((mesh, mesh.data.shape_keys) for mesh in face_meshes(armature))]


def our_tracks(owner: Any) -> list[Any]:
    """The NLA tracks that Understudy made."""
    tracks = list(owner.animation_data.nla_tracks) if owner.animation_data else []
    return [track for track in tracks if track.name.startswith(PREFIX)]


def belongs_to(strip: Any, performance: str) -> bool:
    """Whether an NLA strip shows a part of the performance."""
    return strip.action is not None and strip.action.get(OWNER) == performance


def face_meshes(armature: Any) -> list[Any]:
    """Meshes with shape keys that the armature carries or moves."""
    meshes = (each for each in bpy.data.objects if each.type == "MESH" and each.data.shape_keys)
    return [mesh for mesh in meshes if mesh.parent is armature or _moved_by(mesh, armature)]


def lay_strip(owner: Any, track_name: str, action: Any, start_frame: int, name: str) -> Any:
    """A strip for an action on the first of the tracks of this name (`name`, `name 2`, …) that has room for it."""
    data = owner.animation_data or owner.animation_data_create()
    track = _track_with_room(data, track_name, start_frame, start_frame + action.frame_end)
    strip = track.strips.new(name, start_frame, action)
    strip.name = name  # Blender 4 calls it as its action
    action["understudy_track"] = track_name
    assign_slot(strip, action)
    strip.select = False
    if track.name != track_name:
        strip.extrapolation = "NOTHING"
    return strip


def _entered(entry: Any, strip: Any, mesh: Any, mute: bool) -> None:
    """A strip's entry. Its track is named without its number, because a track with room is chosen when the strip is
    restored."""
    entry.name, entry.action, entry.mesh, entry.mute = strip.name, strip.action, mesh, mute
    entry.start_frame, entry.end_frame = strip.frame_start, strip.frame_end
    entry.track = strip.action["understudy_track"]


def _laid(owner: Any, layer: str, curves: Iterator[Curve], span: Span) -> Any:
    action = new_action(f"{span.performance} {layer}", owner, curves, span.frames)
    action[OWNER], action[LAYER] = span.performance, layer
    strip = lay_strip(owner, f"{PREFIX} {layer}", action, span.start_frame, action.name)
    _cross_fade(owner.animation_data.nla_tracks, strip, f"{PREFIX} {layer}")
    return action


def _bones_by_layer(found: BoneMap, poses: BonePoses) -> Mapping[str, list[str]]:
    layers: dict[str, list[str]] = {"body": [], "head": [], "gaze": []}
    joints = {bone: joint for joint, bone in found.bones.items()}
    for bone in poses.rotations:
        joint = joints.get(bone)
        layers["head" if joint in HEAD else "gaze" if joint in EYES else "body"].append(bone)
    return {layer: bones for layer, bones in layers.items() if bones}


def _bone_curves(armature: Any, bone: str, poses: BonePoses) -> Iterator[Curve]:
    path = f'pose.bones["{bpy.utils.escape_identifier(bone)}"].'
    pose = armature.pose.bones[bone]
    kind, values = rotation_curves(poses.rotations[bone], pose.rotation_mode)
    yield from (Curve(path + kind, index, values[:, index], bone) for index in range(values.shape[1]))
    if bone == poses.root:
        yield from (Curve(path + "location", axis, poses.locations[:, axis], bone) for axis in range(3))


def _moved_by(mesh: Any, armature: Any) -> bool:
    if any(each.type == "ARMATURE" and each.object is armature for each in mesh.modifiers):
        return True
    return mesh.parent is not None and mesh.parent.parent is armature


def _track_with_room(data: Any, name: str, start_frame: float, end_frame: float) -> Any:
    for number in count(1):
        numbered = name if number == 1 else f"{name} {number}"
        track = next((each for each in data.nla_tracks if each.name == numbered), None)
        if track is None:
            track = data.nla_tracks.new()
            track.name = numbered
        if not any(_overlap(strip, start_frame, end_frame) for strip in track.strips):
            return track
    raise AssertionError


def _cross_fade(tracks: Any, new: Any, name: str) -> None:
    """Where the strip overlaps others of its layer, the upper one is faded in over the one that ends, or out over the
    one that begins."""
    strips = [strip for track in tracks if _is_layer(track, name) for strip in track.strips]
    above = False
    for strip in strips:
        if strip == new:
            above = True
        elif _overlap(strip, new.frame_start, new.frame_end):
            _fade(strip, new) if above else _fade(new, strip)


def _fade(upper: Any, lower: Any) -> None:
    if lower.frame_start < upper.frame_start:
        upper.blend_in = max(upper.blend_in, min(lower.frame_end, upper.frame_end) - upper.frame_start)
    if upper.frame_end < lower.frame_end:
        upper.blend_out = max(upper.blend_out, upper.frame_end - max(lower.frame_start, upper.frame_start))


def _is_layer(track: Any, name: str) -> bool:
    return bool(track.name == name or track.name.startswith(f"{name} "))


def _overlap(strip: Any, start_frame: float, end_frame: float) -> bool:
    """Strips that only touch do not overlap."""
    return bool(strip.frame_start < end_frame and start_frame < strip.frame_end)
