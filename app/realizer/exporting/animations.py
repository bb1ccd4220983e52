"""Turns a motion's tracks into glTF animations: baked, or as sparse keys that an animator can edit.

Baked, there is one animation with a key in every frame. Sparse, body, head and face are animations of their own, with
only the keys that `keyframes` needs to stay within its tolerances; the `extras` of each have markers, one for each
behaviour that it shows, with its BML id, its sync points and the reasons for it.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType

import numpy as np

from ...model import Behavior, Channel, FloatArray
from ..body.motion import Motion
from ..geometry.rotations import with_continuous_signs
from .events import events_json
from .gltf import Accessors, Json, Tracks
from .keyframes import PLACE_M, ROTATION_DEG, WEIGHT, rotation_keys, value_keys


class Layer(StrEnum):
    """What an animation of sparse keys moves."""

    BODY = "body"
    HEAD = "head"
    FACE = "face"


OF_HEAD = frozenset({"neck", "head", "leftEye", "rightEye"})
"""The joints of the layer `HEAD`; all others are the body's."""

CHANNELS: Mapping[Channel, Layer] = MappingProxyType(
    {
        Channel.GESTURE: Layer.BODY,
        Channel.POSTURE: Layer.BODY,
        Channel.HEAD: Layer.HEAD,
        Channel.GAZE: Layer.HEAD,
        Channel.EYES: Layer.FACE,
        Channel.FACE: Layer.FACE,
    }
)
"""The layer that shows the behaviours of a channel."""


@dataclass(frozen=True, slots=True, eq=False)
class NodeTrack:
    """The values (T, …) of a node's rotation, translation or weights."""

    node: int
    path: str
    values: FloatArray
    layer: Layer


def joint_track(node: int, joint: str, rotations: FloatArray) -> NodeTrack:
    """The track of a joint's rotations (T, 4)."""
    layer = Layer.HEAD if joint in OF_HEAD else Layer.BODY
    return NodeTrack(node, "rotation", with_continuous_signs(rotations), layer)


def animations(
    tracks: Iterable[NodeTrack], motion: Motion, accessors: Accessors, behaviors: Sequence[Behavior] | None
) -> list[Json]:
    """The animations: baked, or sparse if `behaviors`, those of the schedule, are given for the markers."""
    times_s = np.arange(len(motion.body.times_s)) / motion.frame_rate_hz
    if behaviors is None:
        baked = Tracks(accessors, times_s)
        for track in tracks:
            baked.add(track.node, track.path, track.values)
        return [{"name": "performance", **baked.tree(), "extras": events_json(motion)}]
    layers = {layer: Tracks(accessors, times_s) for layer in Layer}
    for track in tracks:
        layers[track.layer].add(track.node, track.path, track.values, keys=_keys(track))
    return [
        {"name": layer, **found.tree(), "extras": _extras(motion, layer, behaviors)} for layer, found in layers.items()
    ]


def _keys(track: NodeTrack) -> Sequence[int]:
    match track.path:
        case "rotation":
            kept = rotation_keys(track.values, np.radians(ROTATION_DEG))
        case "translation":
            kept = value_keys(track.values, PLACE_M)
        case _:
            kept = value_keys(track.values, WEIGHT)
    return [int(frame) for frame in kept]


def _extras(motion: Motion, layer: Layer, behaviors: Iterable[Behavior]) -> dict[str, Json]:
    start_s = float(motion.body.times_s[0])
    shown = (each for each in behaviors if each.id in motion.realized and CHANNELS[each.kind] is layer)
    return {
        "frame_rate_hz": motion.frame_rate_hz,
        "audio_offset_s": round(start_s - motion.lead_in_s, 6),
        "tolerances": {"rotation_deg": ROTATION_DEG, "translation_m": PLACE_M, "weight": WEIGHT},
        "markers": [marker(motion, each, start_s) for each in shown],
    }


def marker(motion: Motion, behavior: Behavior, start_s: float) -> Json:
    """A behaviour as played: when, what for, and what was decided about it."""
    points = {name: round(time_s - start_s, 6) for name, time_s in motion.realized[behavior.id].in_order()}
    return {
        "id": behavior.id,
        "kind": behavior.kind,
        "lexeme": behavior.lexeme,
        "words": [behavior.first, behavior.last],
        "rule": behavior.rule,
        "function": behavior.function,
        "points_s": points,
        "decisions": [
            {"action": each.action, "reason": each.reason} for each in motion.decisions if each.behavior == behavior.id
        ],
    }
