"""Exports the motion on another avatar: its own GLB or VRM file, with the motion as its animation.

The rest pose may be any: where an arm, leg or finger does not point as in our T-pose (as in an A-pose), it is first
rotated there by the smallest rotation. Nodes that the rig does not name keep their rest pose. Face weights go to every
mesh that has morph targets with ARKit's names. Conventions as in `understudy.realizer.avatars.reading`.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain

import numpy as np

from ...model import Behavior, FloatArray
from ..body.motion import SHAPES, Motion
from ..body.skeleton import FINGERS, SIDES, Skeleton, forward
from ..exporting.animations import Layer, NodeTrack, animations, joint_track
from ..exporting.gltf import Accessors, Json, to_glb_bytes
from ..exporting.retargeting import Rig
from ..geometry.rotations import (
    IDENTITY,
    from_axis_angle,
    inverse,
    length,
    multiply,
    normalized,
    rotate,
    shortest_rotation,
)
from ..mannequin.carrying import t_pose_m
from .reading import Avatar, read_avatar, turn_and_scale

_POINTED: tuple[tuple[str, str], ...] = (
    ("UpperArm", "LowerArm"),
    ("LowerArm", "Hand"),
    ("Hand", "MiddleProximal"),
    ("UpperLeg", "LowerLeg"),
    ("LowerLeg", "Foot"),
    *((f"{finger}Proximal", f"{finger}Intermediate") for finger in FINGERS[1:]),
    *((f"{finger}Intermediate", f"{finger}Distal") for finger in FINGERS[1:]),
)
"""Joints that are rotated to point to the second joint as in our T-pose."""

_NO_LENGTH_M = 1e-9
"""A bone this short points nowhere, and stays as it rests."""


def to_avatar_glb(
    motion: Motion,
    skeleton: Skeleton,
    avatar: bytes,
    rigs: Mapping[str, Rig],
    *,
    sparse_for: Sequence[Behavior] | None = None,
) -> bytes:
    """The avatar's file with the motion as its only animation, or with sparse keys and markers for these behaviours
    (`animations`).

    Raises UndecodableError if it is not binary glTF, and InputError `unknown_avatar` if its joints are not found.
    """
    found = read_avatar(avatar, rigs)
    tree = found.tree | {"nodes": _nodes(found)}
    accessors = Accessors(tree.pop("bufferViews", []), tree.pop("accessors", []), found.content)
    tree.pop("buffers")
    tracks = chain(_body_tracks(found, motion, skeleton), _face_tracks(found, motion))
    tree["animations"] = animations(tracks, motion, accessors, sparse_for)
    return to_glb_bytes(tree, accessors)


def _nodes(avatar: Avatar) -> list[Json]:
    """The file's nodes. A node that is animated has no matrix (glTF 2.0 §5.25), but its parts."""
    nodes: list[Json] = list(avatar.tree["nodes"])
    for number in avatar.nodes.values():
        matrix = avatar.file.nodes[number].matrix
        if matrix is not None:
            turn, sizes = turn_and_scale(np.array(matrix).reshape(4, 4).T)
            kept = {key: value for key, value in avatar.tree["nodes"][number].items() if key != "matrix"}
            nodes[number] = kept | {
                "translation": list(matrix[12:15]),
                "rotation": turn.tolist(),
                "scale": sizes.tolist(),
            }
    return nodes


def _body_tracks(avatar: Avatar, motion: Motion, skeleton: Skeleton) -> Iterator[NodeTrack]:
    """The joints' local rotations, and the hips' position scaled to the length of the avatar's legs."""
    joints = {node: joint for joint, node in avatar.nodes.items() if joint in skeleton.index}
    for node, turned in _turned(avatar, joints, motion, skeleton).items():
        yield joint_track(node, joints[node], normalized(turned))
    yield NodeTrack(avatar.nodes["hips"], "translation", _hips_m(avatar, motion, skeleton), Layer.BODY)


def _turned(avatar: Avatar, joints: Mapping[int, str], motion: Motion, skeleton: Skeleton) -> dict[int, FloatArray]:
    """The rotation of each joint's node in its parent in each frame (T, 4), such that in the world it is turned as our
    joint is. Nodes between joints stay as they rest."""
    front, rest = at_front(avatar), avatar.orientations
    _places, ours = forward(skeleton, motion.body.rotations, motion.body.hips_m)
    t_posed = to_t_pose(avatar, skeleton)
    world: dict[int, FloatArray] = {}
    found: dict[int, FloatArray] = {}
    for node in (number for number in avatar.in_order() if number in joints):
        here = multiply(multiply(front, ours[:, skeleton.index[joints[node]]]), inverse(front))
        world[node] = multiply(here, multiply(t_posed[joints[node]], rest[node]))
        parent = avatar.parents[node]
        moved = _joint_above(avatar, parent, world)
        above = rest[parent] if parent >= 0 else IDENTITY
        if moved >= 0:
            above = multiply(world[moved], multiply(inverse(rest[moved]), above))
        found[node] = multiply(inverse(above), world[node])
    return found


def _joint_above(avatar: Avatar, node: int, joints: Mapping[int, FloatArray]) -> int:
    """The node, or the nearest one above it, that is a joint; -1 if there is none."""
    while node >= 0 and node not in joints:
        node = avatar.parents[node]
    return node


def at_front(avatar: Avatar) -> FloatArray:
    """A half turn about Y if the avatar faces -Z, as in VRM 0; else the identity."""
    left, right = (avatar.positions_m[avatar.nodes[f"{side}UpperArm"], 0] for side in SIDES)
    return from_axis_angle((0.0, 1.0, 0.0), np.array(0.0 if left > right else np.pi))


def to_t_pose(avatar: Avatar, skeleton: Skeleton) -> dict[str, FloatArray]:
    """The rotation of each joint, with its descendants, from the avatar's rest pose to our T-pose."""
    ours_m, front = t_pose_m(skeleton), at_front(avatar)
    pointed = {side + first: side + second for side in SIDES for first, second in _POINTED}
    turns: dict[str, FloatArray] = {}
    for joint, parent in zip(skeleton.names, skeleton.parents, strict=True):
        turn = turns[skeleton.names[parent]] if parent >= 0 else np.array(IDENTITY)
        towards = pointed.get(joint)
        if towards is not None and joint in avatar.nodes and towards in avatar.nodes:
            there = avatar.positions_m[avatar.nodes[towards]] - avatar.positions_m[avatar.nodes[joint]]
            wanted = rotate(front, ours_m[skeleton.index[towards]] - ours_m[skeleton.index[joint]])
            if length(there)[0] > _NO_LENGTH_M:
                turn = multiply(shortest_rotation(rotate(turn, there), wanted), turn)
        turns[joint] = turn
    return turns


def _hips_m(avatar: Avatar, motion: Motion, skeleton: Skeleton) -> FloatArray:
    """The position of the hips' node relative to its parent (T, 3)."""
    node = avatar.nodes["hips"]
    rest_m = skeleton.offsets_m[0]
    size = avatar.positions_m[node, 1] / rest_m[1]
    world = avatar.positions_m[node] + size * rotate(at_front(avatar), motion.body.hips_m - rest_m)
    parent = avatar.parents[node]
    above = avatar.matrices[parent] if parent >= 0 else np.eye(4)
    local = np.linalg.inv(above) @ np.concatenate([world, np.ones((len(world), 1))], axis=1).T
    return np.asarray(local[:3].T)


def _face_tracks(avatar: Avatar, motion: Motion) -> Iterator[NodeTrack]:
    """A weights track for each mesh with ARKit's morph targets. Eyes that turn by joints get no look weights as
    well."""
    eyes_turn = all(f"{side}Eye" in avatar.nodes for side in SIDES)
    weights = np.clip(motion.shapes, 0.0, 1.0)
    for number, node in enumerate(avatar.file.nodes):
        names = avatar.file.meshes[node.mesh].target_names() if node.mesh is not None else []
        only_looks = all(name.startswith("eyeLook") for name in names)
        if not set(names) & set(SHAPES) or (only_looks and eyes_turn):
            continue
        columns = [weights[:, SHAPES.index(name)] if name in SHAPES else np.zeros(len(weights)) for name in names]
        yield NodeTrack(number, "weights", np.stack(columns, axis=1), Layer.FACE)
