"""Clips and armatures made by hand, whose right answers are known without the code under test."""

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from plugins.blender.motion.clip import Clip, read_clip
from plugins.blender.motion.rotations import Array
from plugins.blender.retargeting.armature import Armature, RestBone
from plugins.blender.retargeting.skeleton import JOINTS

X, Y, Z = np.eye(3)


def clip(rotations: Mapping[str, Sequence[Sequence[float]]] | None = None, **changes: Any) -> Clip:  # noqa: ANN401
    """A clip of our skeleton in the T-pose; `rotations` are tracks (x y z w) of some joints, `changes` keys."""
    turned = dict(rotations or {})
    tracks = {joint: list(turned.get(joint, [[0, 0, 0, 1]])) for joint in joint_names()}
    frames = max(len(track) for track in tracks.values())
    written = {
        "format": "understudy-clip",
        "version": 1,
        "skeleton": {"joints": skeleton()},
        "frames": frames,
        "frame_rate_hz": 30,
        "audio_offset_s": 0.0,
        "events": [],
        "decisions": [],
        "notices": [],
        "hips_m": [[0.0, 0.95, 0.0]],
        "bones": tracks,
        "blendshapes": {},
    }
    return read_clip(json.dumps(written | changes).encode())


def joint_names() -> list[str]:
    return [str(joint["name"]) for joint in skeleton()]


def skeleton() -> list[dict[str, Any]]:
    """Our skeleton as clips have it: the joints of Understudy's own, in metres."""
    from understudy.realizer.body.skeleton import Skeleton

    ours = Skeleton.standing()
    parents = [ours.names[parent] if parent >= 0 else None for parent in ours.parents]
    return [
        {"name": name, "parent": parent, "offset_m": offset.tolist()}
        for name, parent, offset in zip(ours.names, parents, ours.offsets_m, strict=True)
    ]


def armature(
    names: Mapping[str, str] | None = None,
    *,
    turn: Array | None = None,
    size: float = 1.0,
    arms_down_rad: float = 0.0,
    axes: Mapping[str, Array] | None = None,
) -> Armature:
    """Our skeleton as an armature: bones called by `names`, the whole turned (3, 3) and sized, the arms lowered to an
    A-pose, and the rest axes of bones as given (else the armature's)."""
    names = names or {joint: joint for joint in JOINTS}
    turn = np.eye(3) if turn is None else turn
    places = posed_places(arms_down_rad)
    bones = {}
    for joint in skeleton():
        name = joint["name"]
        rotation = turn @ (axes or {}).get(name, np.eye(3))
        parent = names[joint["parent"]] if joint["parent"] else ""
        bones[names[name]] = RestBone(names[name], parent, size * turn @ places[name], rotation)
    return Armature(bones, dict(names))


def posed_places(arms_down_rad: float) -> dict[str, Array]:
    """Our joints with both arms lowered from the T-pose about the shoulders."""
    places: dict[str, Array] = {}
    turns: dict[str, Array] = {}
    for joint in skeleton():
        name, parent = joint["name"], joint["parent"]
        turns[name] = turns[parent] if parent else np.eye(3)
        places[name] = (turns[parent] @ joint["offset_m"] + places[parent]) if parent else np.array(joint["offset_m"])
        if name.endswith("UpperArm"):
            turns[name] = about(Z, -arms_down_rad if name.startswith("left") else arms_down_rad) @ turns[name]
    return places


def about(axis: Array, angle_rad: float) -> Array:
    """The rotation (3, 3) about an axis by Rodrigues' formula."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn: Array = np.eye(3) + np.sin(angle_rad) * cross + (1 - np.cos(angle_rad)) * cross @ cross
    return turn


def places_of(armature: Armature, rotations: Mapping[str, Array], moved: Array) -> dict[str, Array]:
    """Where the bones' heads are in one frame, by Blender's own rule: a pose bone is turned by its rotation after its
    rest, as its parent carries it. `rotations` are quaternions (4; w x y z), `moved` the hips' location (3)."""
    world: dict[str, Array] = {}
    heads: dict[str, Array] = {}
    for name, bone in armature.bones.items():
        if bone.parent:
            above = armature.bones[bone.parent]
            carried = world[bone.parent] @ above.rotation.T
            heads[name] = heads[bone.parent] + carried @ (bone.head - above.head)
        else:
            carried, heads[name] = np.eye(3), bone.head + bone.rotation @ moved
        world[name] = carried @ bone.rotation @ matrix_of(rotations.get(name, np.array([1.0, 0, 0, 0])))
    return heads


def matrix_of(quaternion: Array) -> Array:
    w, vector = quaternion[0], quaternion[1:]
    length = float(np.linalg.norm(vector))
    return about(vector, 2 * np.arctan2(length, w)) if length > 1e-12 else np.eye(3)
