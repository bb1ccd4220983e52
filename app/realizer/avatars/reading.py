"""Reads an avatar from a GLB or VRM file: its nodes, which of them are our joints, and its rest pose.

Joints are found by VRM's humanoid bone table if the file has one, else by the joint names of a rig
(`lexicon/retarget`). Conventions: metres, quaternions x y z w; the rest pose is that of the file without animation.
Nothing is read that `avatar_schema` has not checked, and what is computed from it is finite.
"""

import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NoReturn

import numpy as np

from ...errors import InputError, UndecodableError
from ...model import FloatArray
from ..body.skeleton import SIDES
from ..exporting.gltf_reading import LARGEST, AvatarFile, Node
from ..exporting.retargeting import Rig
from ..geometry.rotations import IDENTITY, from_axes, multiply, normalized, rotate

NEEDED = ("hips", "spine", "head", *(f"{side}{part}" for side in SIDES for part in ("UpperArm", "LowerArm", "Hand")))
"""The joints that an avatar must have."""

MOST_NODES = 20_000

_LEAST_TURN, _MOST_TURN = 0.5, 2.0
"""How long a quaternion may be that is meant to be of length 1."""

_SHEARED = 1e-3
"""How far a joint's matrix may be from a rotation, translation and scale."""

_FLATTENED = 1e9
"""The most that the space above the hips may enlarge what is in it."""


@dataclass(frozen=True, slots=True, eq=False)
class Avatar:
    """An avatar: the JSON `tree` of its file, to be passed on, `file`, what is read of it, and its buffer; its nodes'
    parents (-1 for roots), and in the rest pose their transforms (N, 4, 4) and orientations (N, 4) in the world; and
    the node of each of our joints that it has."""

    tree: dict[str, Any]
    file: AvatarFile
    content: bytes
    parents: tuple[int, ...]
    matrices: FloatArray
    orientations: FloatArray
    nodes: Mapping[str, int]

    @property
    def positions_m(self) -> FloatArray:
        """The nodes' positions (N, 3) in the world."""
        return np.asarray(self.matrices[:, :3, 3])

    def in_order(self) -> Iterator[int]:
        """Node numbers, parents before their children."""
        return _in_order(self.file.nodes, self.parents)


def read_avatar(content: bytes, rigs: Mapping[str, Rig]) -> Avatar:
    """The avatar in a GLB or VRM file.

    Raises UndecodableError if it is not such a file, or one that cannot be right, and InputError `unknown_avatar` if
    its joints are not found.
    """
    try:
        tree, buffer = _chunks(content)
        file = AvatarFile.of(tree)
        parents = _parents(file, len(buffer))
        named = _vrm_bones(file) or _named_bones(file.nodes, rigs)
        _refuse_strange_bones(named, len(file.nodes))
        missing = [joint for joint in NEEDED if joint not in named]
        if missing:
            message = f"the avatar has no {', '.join(missing)} under the names of VRM or of {', '.join(rigs)}"
            raise InputError("unknown_avatar", message, field="avatar")
        matrices, orientations = _at_rest(file.nodes, parents, frozenset(named.values()))
        _refuse_flat_space(matrices, parents[named["hips"]])
    except (struct.error, ValueError, RecursionError) as error:
        message = f"the avatar is not a usable GLB or VRM file: {error}"
        raise UndecodableError("avatar_undecodable", message, field="avatar") from None
    return Avatar(tree, file, buffer[: file.buffers[0].byte_length], parents, matrices, orientations, named)


def _chunks(content: bytes) -> tuple[dict[str, Any], bytes]:
    """The JSON tree and the buffer."""
    magic, version, _length, size, kind = struct.unpack_from("<4sII I4s", content)
    if (magic, version, kind) != (b"glTF", 2, b"JSON"):
        raise ValueError("not binary glTF 2.0")
    start = 20 + size
    tree = json.loads(content[20:start], parse_constant=_not_finite, parse_float=_finite)
    length, kind = struct.unpack_from("<I4s", content, start) if len(content) > start else (0, b"BIN\0")
    if kind != b"BIN\0":
        raise ValueError("its second chunk is not its data")
    return tree, content[start + 8 : start + 8 + length]


def _finite(text: str) -> float:
    value = float(text)
    return value if abs(value) < float("inf") else _not_finite(text)


def _not_finite(text: str) -> NoReturn:
    raise ValueError(f"{text[:20]} is not a JSON number")


def _parents(file: AvatarFile, size: int) -> tuple[int, ...]:
    """The parent of each node. Raises ValueError where one part refers to another that is not there."""
    count = len(file.nodes)
    if count > MOST_NODES:
        raise ValueError(f"it has {count} nodes; {MOST_NODES} at most can be used")
    parents = [-1] * count
    for number, node in enumerate(file.nodes):
        if node.mesh is not None and node.mesh >= len(file.meshes):
            raise ValueError(f"nodes.{number}.mesh: there is no mesh {node.mesh}")
        for child in node.children:
            if child >= count:
                raise ValueError(f"nodes.{number}.children: there is no node {child}")
            if parents[child] >= 0:
                raise ValueError(f"node {child} has two parents")
            parents[child] = number
    if sum(1 for _ in _in_order(file.nodes, parents)) < count:
        raise ValueError("nodes are their own ancestors")
    _refuse_short_buffer(file, size)
    return tuple(parents)


def _refuse_short_buffer(file: AvatarFile, size: int) -> None:
    length = file.buffers[0].byte_length
    if length > size:
        raise ValueError(f"buffers.0.byteLength is {length}, but {size} bytes are there")
    for number, view in enumerate(file.views):
        if view.byte_offset + view.byte_length > length:
            raise ValueError(f"bufferViews.{number} goes beyond the {length} bytes of the buffer")
    for number, accessor in enumerate(file.accessors):
        if accessor.view is not None and accessor.view >= len(file.views):
            raise ValueError(f"accessors.{number}.bufferView: there is no view {accessor.view}")


def _in_order(nodes: Sequence[Node], parents: Sequence[int]) -> Iterator[int]:
    waiting = [number for number, parent in enumerate(parents) if parent < 0]
    while waiting:
        number = waiting.pop()
        yield number
        waiting += nodes[number].children


def _vrm_bones(file: AvatarFile) -> dict[str, int]:
    """The bone table of VRM 1.0 or VRM 0, whose thumb joints have different names."""
    vrm1, vrm0 = file.extensions.vrm1, file.extensions.vrm0
    if vrm1 is not None:
        return {name: bone.node for name, bone in vrm1.humanoid.human_bones.items()}
    named = {bone.bone: bone.node for bone in vrm0.humanoid.human_bones} if vrm0 is not None else {}
    for side in SIDES:
        for old, new in (("Proximal", "Metacarpal"), ("Intermediate", "Proximal")):
            if f"{side}Thumb{old}" in named:
                named[f"{side}Thumb{new}"] = named.pop(f"{side}Thumb{old}")
    return named


def _named_bones(nodes: Sequence[Node], rigs: Mapping[str, Rig]) -> dict[str, int]:
    """The joints by the rig that matches most node names; colons are optional, since some tools drop them."""
    places = {node.name.replace(":", ""): number for number, node in enumerate(nodes)}
    found = [
        {joint: places[name.replace(":", "")] for joint, name in rig.names.items() if name.replace(":", "") in places}
        for rig in rigs.values()
    ]
    return max(found, key=len, default={})


def _refuse_strange_bones(named: Mapping[str, int], count: int) -> None:
    """Bones that are no nodes, or two that are the same."""
    for (bone, node), (other, same) in pairwise(sorted(named.items(), key=lambda each: each[1])):
        if node == same:
            raise ValueError(f"node {node} is both {_shown(bone)} and {_shown(other)}")
    beyond = next((bone for bone, node in named.items() if node >= count), None)
    if beyond is not None:
        raise ValueError(f"{_shown(beyond)} is node {named[beyond]}, of {count} nodes")


def _shown(name: str) -> str:
    return ascii(name[:40])


def _at_rest(nodes: Sequence[Node], parents: Sequence[int], joints: frozenset[int]) -> tuple[FloatArray, FloatArray]:
    """The nodes' transforms (N, 4, 4) and orientations (N, 4) in the world; each node that is a joint is a rotation, a
    scale and a translation."""
    matrices, orientations = np.tile(np.eye(4), (len(nodes), 1, 1)), np.tile(IDENTITY, (len(nodes), 1))
    with np.errstate(over="ignore", invalid="ignore"):
        for number in _in_order(nodes, parents):
            parent, matrix = parents[number], local_matrix(nodes[number], number)
            turn = _turn(nodes[number], matrix, number, joint=number in joints)
            above = (matrices[parent], orientations[parent]) if parent >= 0 else (np.eye(4), IDENTITY)
            matrices[number], orientations[number] = above[0] @ matrix, multiply(above[1], turn)
    within = np.abs(matrices).reshape(len(nodes), -1).max(axis=1) <= LARGEST
    if not within.all():
        raise ValueError(f"node {np.argmin(within)} is further than {LARGEST:g} m away, or larger")
    return matrices, normalized(orientations)


def local_matrix(node: Node, number: int) -> FloatArray:
    """The transform (4, 4) of the node with this number, relative to its parent."""
    if node.matrix is not None:
        return np.array(node.matrix).reshape(4, 4).T
    found, turn = np.eye(4), np.array(node.rotation)
    size = float(np.linalg.norm(turn))
    if not _LEAST_TURN <= size <= _MOST_TURN:
        raise ValueError(f"nodes.{number}.rotation: a quaternion has length 1, not {size:g}")
    found[:3, :3] = rotate(np.tile(turn / size, (3, 1)), np.eye(3)).T * np.array(node.scale)
    found[:3, 3] = node.translation
    return found


def _turn(node: Node, matrix: FloatArray, number: int, *, joint: bool) -> FloatArray:
    """The rotation (4,) in a node's transform."""
    if node.matrix is None:
        return normalized(np.array(node.rotation))
    turn, sizes = turn_and_scale(matrix)
    if joint and np.abs(rotate(np.tile(turn, (3, 1)), np.eye(3)).T * sizes - matrix[:3, :3]).max() > _SHEARED:
        raise ValueError(f"nodes.{number}.matrix is not a rotation, translation and scale, as a joint's must be")
    return turn


def turn_and_scale(matrix: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The rotation (4,) nearest to a transform (4, 4), and the scales (3,) along its axes."""
    left, _sizes, right = np.linalg.svd(matrix[:3, :3])
    axes = left @ right
    axes = axes if np.linalg.det(axes) > 0 else -axes
    return from_axes(axes[:, 0], axes[:, 1], axes[:, 2]), np.diag(axes.T @ matrix[:3, :3])


def _refuse_flat_space(matrices: FloatArray, parent: int) -> None:
    """A space above the hips in which they cannot be placed."""
    if parent >= 0:
        axes = matrices[parent, :3, :3]
        smallest = float(np.linalg.svd(axes, compute_uv=False)[-1])
        if smallest * _FLATTENED < 1.0:
            raise ValueError(f"node {parent}, above the hips, is scaled to nothing")
