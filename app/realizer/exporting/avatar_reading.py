"""Reads an avatar from a GLB or VRM file: its nodes, which of them are our joints, and its rest pose.

Joints are found by VRM's humanoid bone table if the file has one, else by the joint names of a rig
(`lexicon/retarget`). Conventions: metres, quaternions x y z w; the rest pose is that of the file without animation.
"""

import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...errors import InputError, UndecodableError
from ...model import FloatArray
from ..body.skeleton import SIDES
from ..geometry.rotations import IDENTITY, multiply, normalized, rotate
from .retargeting import Rig

Tree = dict[str, Any]

NEEDED = ("hips", "spine", "head", *(f"{side}{part}" for side in SIDES for part in ("UpperArm", "LowerArm", "Hand")))
"""The joints that an avatar must have."""


@dataclass(frozen=True, slots=True, eq=False)
class Avatar:
    """The file's JSON tree and buffer; its nodes' parents (-1 for roots), positions (N, 3) and orientations (N, 4) in
    the world in the rest pose; and the node index of each of our joints that it has."""

    tree: Tree
    content: bytes
    parents: tuple[int, ...]
    positions_m: FloatArray
    orientations: FloatArray
    nodes: Mapping[str, int]

    def in_order(self) -> Iterator[int]:
        """Node indices, parents before their children."""
        waiting = [number for number, parent in enumerate(self.parents) if parent < 0]
        while waiting:
            number = waiting.pop()
            yield number
            waiting += self.tree["nodes"][number].get("children", [])


def read_avatar(content: bytes, rigs: Mapping[str, Rig]) -> Avatar:
    """The avatar in a GLB or VRM file.

    Raises UndecodableError if it is not such a file, and InputError `unknown_avatar` if its joints are not found.
    """
    tree, buffer = _chunks(content)
    try:
        return _avatar(tree, buffer, rigs)
    except (KeyError, IndexError, TypeError, ValueError, AttributeError) as error:
        raise _undecodable(f"its parts do not fit together: {error!r}") from None


def _avatar(tree: Tree, buffer: bytes, rigs: Mapping[str, Rig]) -> Avatar:
    nodes: Sequence[Tree] = tree["nodes"]
    parents = [-1] * len(nodes)
    for number, node in enumerate(nodes):
        for child in node.get("children", []):
            if parents[child] >= 0:
                raise ValueError(f"node {child} has two parents")
            parents[child] = number
    named = _vrm_bones(tree) or _named_bones(nodes, rigs)
    missing = [joint for joint in NEEDED if joint not in named]
    if missing:
        message = f"the avatar has no {', '.join(missing)} by the names of VRM or of {', '.join(rigs)}"
        raise InputError("unknown_avatar", message, field="avatar")
    avatar = Avatar(tree, buffer, tuple(parents), np.zeros((len(nodes), 3)), np.zeros((len(nodes), 4)), named)
    positions_m, orientations = _at_rest(avatar)
    return replace(avatar, positions_m=positions_m, orientations=orientations)


def _undecodable(why: str) -> UndecodableError:
    return UndecodableError(
        "avatar_undecodable", f"the avatar is no GLB or VRM file that can be used: {why}", field="avatar"
    )


def _chunks(content: bytes) -> tuple[Tree, bytes]:
    """The JSON tree and the buffer."""
    try:
        magic, version, _length, size, kind = struct.unpack_from("<4sII I4s", content)
        if (magic, version, kind) != (b"glTF", 2, b"JSON"):
            raise ValueError("not binary glTF 2.0")
        tree = json.loads(content[20 : 20 + size])
        start = 20 + size
        length = struct.unpack_from("<I", content, start)[0] if len(content) > start else 0
    except (struct.error, ValueError, RecursionError) as error:
        raise _undecodable(str(error)) from None
    buffers = tree.get("buffers", []) if isinstance(tree, dict) else []
    if len(buffers) != 1 or "uri" in buffers[0]:
        raise _undecodable("its data must all be inside it")
    return tree, content[start + 8 : start + 8 + length]


def _vrm_bones(tree: Tree) -> dict[str, int]:
    """The bone table of VRM 1.0 or VRM 0, whose thumb joints have different names."""
    extensions = tree.get("extensions", {})
    if "VRMC_vrm" in extensions:
        bones = extensions["VRMC_vrm"]["humanoid"]["humanBones"]
        return {name: int(bone["node"]) for name, bone in bones.items()}
    bones = extensions.get("VRM", {}).get("humanoid", {}).get("humanBones", [])
    named = {bone["bone"]: int(bone["node"]) for bone in bones}
    for side in SIDES:
        for old, new in (("Proximal", "Metacarpal"), ("Intermediate", "Proximal")):
            if f"{side}Thumb{old}" in named:
                named[f"{side}Thumb{new}"] = named.pop(f"{side}Thumb{old}")
    return named


def _named_bones(nodes: Sequence[Tree], rigs: Mapping[str, Rig]) -> dict[str, int]:
    """The joints by the rig that matches most node names; colons are optional, since some tools drop them."""
    places = {str(node.get("name", "")).replace(":", ""): number for number, node in enumerate(nodes)}
    found = [
        {joint: places[name.replace(":", "")] for joint, name in rig.names.items() if name.replace(":", "") in places}
        for rig in rigs.values()
    ]
    return max(found, key=len, default={})


def _at_rest(avatar: Avatar) -> tuple[FloatArray, FloatArray]:
    """The nodes' positions (N, 3) and orientations (N, 4) in the world."""
    nodes = avatar.tree["nodes"]
    matrices, orientations = np.tile(np.eye(4), (len(nodes), 1, 1)), np.tile(IDENTITY, (len(nodes), 1))
    reached = 0
    for number in avatar.in_order():
        parent = avatar.parents[number]
        turn = np.array(nodes[number].get("rotation", IDENTITY), dtype=np.float64)
        matrices[number] = local_matrix(nodes[number])
        orientations[number] = turn
        if parent >= 0:
            matrices[number] = matrices[parent] @ matrices[number]
            orientations[number] = multiply(orientations[parent], turn)
        reached += 1
    if reached < len(nodes):
        raise ValueError("nodes are their own ancestors")
    return matrices[:, :3, 3], normalized(orientations)


def local_matrix(node: Tree) -> FloatArray:
    """A node's transform relative to its parent, as a matrix (4, 4)."""
    if "matrix" in node:
        return np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
    found = np.eye(4)
    turn = np.array(node.get("rotation", IDENTITY), dtype=np.float64)
    found[:3, :3] = rotate(np.tile(turn, (3, 1)), np.eye(3)).T * np.array(node.get("scale", (1.0, 1.0, 1.0)))
    found[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return found


def target_names(tree: Tree, node: Tree) -> list[str]:
    """The names of the node's morph targets, from wherever exporters put them."""
    if "mesh" not in node:
        return []
    mesh = tree["meshes"][node["mesh"]]
    extras = mesh.get("extras", {}) or mesh["primitives"][0].get("extras", {})
    count = len(mesh["primitives"][0].get("targets", []))
    names = [str(name) for name in extras.get("targetNames", [])]
    return names if len(names) == count else []
