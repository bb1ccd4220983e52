"""Turns a motion's tracks into glTF animations: baked, or as sparse keys that an animator can edit.

Baked, there is one animation with a key in every frame. Sparse, body, head and face are animations of their own, with
only the keys that are needed to stay within a tolerance; the `extras` of each have markers, one for each behaviour that
it shows, with its BML id, its sync points and the reasons for it.

Reduces the frames of a track to the few keys that an animator edits, within a stated error.

Ramer, Douglas and Peucker's method over time: a stretch between two keys is split at the frame that is furthest from
what players interpolate there, until none is further than the tolerance. Rotations are interpolated along the shorter
arc (slerp) and their distance is an angle; everything else is interpolated linearly, its distance the largest of its
components'. All stretches are measured together, so that ten minutes take seconds.

A motion's sync points and decisions are written as JSON, for programs that play it.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...model import Behavior, Channel, FloatArray
from ..body.motion import Motion
from ..geometry.rotations import dot, normalized, with_continuous_signs
from .gltf import Accessors, Json, Tracks


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


ROTATION_DEG, PLACE_M, WEIGHT = 0.25, 0.001, 0.02
"""The tolerances: of each joint's rotation, of the hips' position and of the face's weights."""

Distance = Callable[[FloatArray, FloatArray, FloatArray, FloatArray], FloatArray]
"""From the values of frames, those of the keys before and after, and the share of the way, to the frames' errors."""


def rotation_keys(rotations: FloatArray, tolerance_rad: float) -> NDArray[np.intp]:
    """The frames that are kept of the rotations (T, 4), with continuous signs."""
    return _kept(rotations, tolerance_rad, _angles)


def value_keys(values: FloatArray, tolerance: float) -> NDArray[np.intp]:
    """The frames that are kept of the values (T, N)."""
    return _kept(values, tolerance, _differences)


def _kept(values: FloatArray, tolerance: float, distance: Distance) -> NDArray[np.intp]:
    """The kept frames in order: the first, the last and those between that are needed."""
    keys = np.unique([0, len(values) - 1])
    open_ends = keys[1:]
    while len(open_ends):
        starts = keys[np.searchsorted(keys, open_ends) - 1]
        frames, stretch = _inside(starts, open_ends)
        if not len(frames):
            break
        share = (frames - starts[stretch]) / (open_ends - starts)[stretch]
        apart = distance(values[frames], values[starts[stretch]], values[open_ends[stretch]], share)
        worst = _furthest(apart, stretch, len(starts))
        split = worst[apart[worst] > tolerance]
        new = frames[split]
        open_ends = np.sort(np.concatenate([new, open_ends[stretch[split]]]))
        keys = np.sort(np.concatenate([keys, new]))
    return keys


def _inside(starts: NDArray[np.intp], ends: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The frames strictly inside each stretch, and the stretch of each."""
    counts = ends - starts - 1
    stretch = np.repeat(np.arange(len(starts)), counts)
    firsts = np.cumsum(counts) - counts
    return starts[stretch] + 1 + np.arange(len(stretch)) - firsts[stretch], stretch


def _furthest(apart: FloatArray, stretch: NDArray[np.intp], count: int) -> NDArray[np.intp]:
    """The index into `apart` of the largest error of each stretch that has any frame."""
    order = np.lexsort((apart, stretch))
    last = np.searchsorted(stretch[order], np.arange(count), side="right") - 1
    has_frames = np.bincount(stretch, minlength=count) > 0
    return order[last[has_frames]]


def _angles(values: FloatArray, before: FloatArray, after: FloatArray, share: FloatArray) -> FloatArray:
    cosine = dot(before, after)
    after, cosine = np.where(cosine < 0, -after, after), np.minimum(np.abs(cosine), 1.0)
    angle, share = np.arccos(cosine), share[:, None]
    small = angle < 1e-6
    sine = np.where(small, 1.0, np.sin(angle))
    first = np.where(small, 1 - share, np.sin((1 - share) * angle) / sine)
    second = np.where(small, share, np.sin(share * angle) / sine)
    between = normalized(first * before + second * after)
    chord = np.minimum(np.linalg.norm(values - between, axis=-1), np.linalg.norm(values + between, axis=-1))
    return np.asarray(4 * np.arcsin(np.minimum(chord / 2, 1.0)))


def _differences(values: FloatArray, before: FloatArray, after: FloatArray, share: FloatArray) -> FloatArray:
    between = before + share[:, None] * (after - before)
    return np.asarray(np.abs(values - between).max(axis=-1))


def events_json(motion: Motion) -> dict[str, Json]:
    """The sync points by BML id, in seconds from the first frame, which is at `audio_offset_s` of the audio (negative
    with a lead-in), and the decisions."""
    start_s = float(motion.body.times_s[0])
    return {
        "frame_rate_hz": motion.frame_rate_hz,
        "audio_offset_s": round(start_s - motion.lead_in_s, 6),
        "events": [
            {"behavior": event.behavior, "point": event.point, "time_s": round(event.time_s - start_s, 6)}
            for event in motion.events()
        ],
        "decisions": [
            {"behavior": each.behavior, "action": each.action, "reason": each.reason} for each in motion.decisions
        ],
    }
