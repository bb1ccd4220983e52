"""A performed armature as one action: all that its Understudy tracks play, read frame by frame and keyed.

Baked are the properties that the tracks animate, on the armature and on the shape keys of its meshes; the tracks are
muted and stay, so that baking can be taken back. Constraints go on working. What is read is what is seen: cross-fades,
and strips that were muted or scaled, are in it.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np

from ..motion.rotations import Array, with_continuous_signs
from ..motion.sparse_keys import PLACE, ROTATION_RAD, WEIGHT, rotation_frames, value_frames
from .actions import Curve, assign_action, curves_of, new_action
from .layers import LAYER, our_tracks, owners

_BEFORE = "understudy_before"
"""The custom property of a baked action: the action and the tracks that played before, as JSON."""


class NothingToBakeError(ValueError):
    """An armature on which nothing is performed."""


@dataclass(frozen=True, slots=True)
class Baked:
    """What was baked: its first and last frame, and how many keys a joint or shape has at most."""

    first_frame: int
    last_frame: int
    most_keys: int


@dataclass(frozen=True, slots=True, eq=False)
class _Track:
    """A property of an owner, and its values (T, N), one a frame."""

    path: str
    indices: tuple[int, ...]
    values: Array


def bake(scene: Any, armature: Any, *, sparse: bool) -> Baked:
    """Bakes what is performed on the armature into an action of its own. Raises NothingToBakeError."""
    unbake(armature)
    first, last = frames_of(armature)
    performed = [owner for _mesh, owner in owners(armature) if our_tracks(owner)]
    properties = {owner: _properties(owner) for owner in performed}
    read = _read(scene, properties, range(first, last + 1))
    most = 0
    for owner in performed:
        tracks = [_Track(path, properties[owner][path], values) for path, values in read[owner].items()]
        keyed = [_kept(track, sparse) for track in tracks]
        most = max(most, *map(len, keyed))
        curves = (curve for track, frames in zip(tracks, keyed, strict=True) for curve in _curves(track, frames, first))
        _replace(owner, new_action(f"{armature.name} baked", owner, curves, last, first=first))
    return Baked(first, last, most)


def unbake(armature: Any) -> bool:
    """Takes baking back: the tracks play again; whether anything was baked."""
    found = False
    for _mesh, owner in owners(armature):
        action = owner.animation_data.action if owner.animation_data else None
        if action is None or _BEFORE not in action:
            continue
        before = json.loads(action[_BEFORE])
        for track in our_tracks(owner):
            track.mute = track.name in before["muted"]
        assign_action(owner, bpy.data.actions.get(before["action"]))
        bpy.data.actions.remove(action)
        found = True
    return found


def frames_of(armature: Any) -> tuple[int, int]:
    """The first and last frame in which something is performed. Raises NothingToBakeError."""
    strips = [strip for _mesh, owner in owners(armature) for strip in _layer_strips(owner)]
    if not strips:
        raise NothingToBakeError(f"{armature.name} has no performance yet: perform a line, or import BML")
    return round(min(each.frame_start for each in strips)), round(max(each.frame_end for each in strips))


def _layer_strips(owner: Any) -> list[Any]:
    strips = (strip for track in our_tracks(owner) for strip in track.strips)
    return [strip for strip in strips if strip.action is not None and LAYER in strip.action]


def _properties(owner: Any) -> dict[str, tuple[int, ...]]:
    """The properties that the layers animate, with the places in them that do."""
    found: dict[str, set[int]] = {}
    for strip in _layer_strips(owner):
        for curve in curves_of(strip.action):
            found.setdefault(curve.data_path, set()).add(curve.array_index)
    return {path: tuple(sorted(indices)) for path, indices in found.items()}


def _read(
    scene: Any, properties: Mapping[Any, Mapping[str, Sequence[int]]], frames: Sequence[int]
) -> dict[Any, dict[str, Array]]:
    """The values of all properties in all frames."""
    read: dict[Any, dict[str, list[Array]]] = {
        owner: {path: [] for path in paths} for owner, paths in properties.items()
    }
    there = scene.frame_current
    for frame in frames:
        scene.frame_set(frame)
        for owner, paths in read.items():
            for path, values in paths.items():
                values.append(np.atleast_1d(np.array(owner.path_resolve(path), dtype=float)))
    scene.frame_set(there)
    return {owner: {path: np.array(values) for path, values in paths.items()} for owner, paths in read.items()}


def _kept(track: _Track, sparse: bool) -> list[int]:
    """The frames that get keys, from 0."""
    if np.all(track.values == track.values[0]):
        return [0]
    if not sparse:
        return list(range(len(track.values)))
    if track.path.endswith("rotation_quaternion"):
        return rotation_frames(with_continuous_signs(track.values))
    tolerance = PLACE if track.path.endswith("location") else ROTATION_RAD if "rotation" in track.path else WEIGHT
    return value_frames(track.values, tolerance)


def _curves(track: _Track, kept: Sequence[int], first_frame: int) -> Iterator[Curve]:
    quaternions = track.path.endswith("rotation_quaternion")
    values = with_continuous_signs(track.values) if quaternions else track.values
    group = track.path.split('"')[1] if track.path.startswith("pose.bones") else ""
    for index in track.indices:
        yield Curve(track.path, index, values[list(kept), index], group, np.array(kept) + first_frame)


def _replace(owner: Any, action: Any) -> None:
    """Plays the baked action in the place of the tracks."""
    data = owner.animation_data
    muted = [track.name for track in our_tracks(owner) if track.mute]
    action[_BEFORE] = json.dumps({"action": data.action.name if data.action else "", "muted": muted})
    for track in our_tracks(owner):
        track.mute = True
    assign_action(owner, action)
