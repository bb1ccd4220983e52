"""Exports binary glTF: the skinned mannequin with 52 ARKit blendshapes and 15 visemes, animated.

Conventions (docs/references.md): metres, seconds from the first frame, LINEAR interpolation. Successive quaternions
have continuous signs. The weights of all morph targets are one track; the visemes' stay 0, since the ARKit shapes
already show the speech.
"""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ...model import Behavior
from ...model.figure import PLAIN, Looks
from ..body.motion import Motion
from ..body.skeleton import Skeleton
from ..mannequin.carrying import t_pose_m
from ..mannequin.face import FACE_SHAPES
from ..mannequin.looks import MATERIALS, Colour
from ..mannequin.skinning import Mannequin, MeshPart, joined
from .animations import Layer, NodeTrack, animations, joint_track
from .gltf import Accessors, Json, joint_nodes, to_glb_bytes


def to_glb(
    motion: Motion, skeleton: Skeleton, looks: Looks = PLAIN.looks, *, sparse_for: Sequence[Behavior] | None = None
) -> bytes:
    """The GLB file, baked, or with sparse keys and markers for these behaviours (`animations`)."""
    mannequin = Mannequin.around(skeleton, looks)
    accessors = Accessors()
    nodes = joint_nodes(skeleton)
    still = joined(tuple(part for part in mannequin.parts if not part.shapes))
    moving = joined(tuple(part for part in mannequin.parts if part.shapes))
    meshes = [_mesh("Body", still, accessors), _mesh("Face", moving, accessors)]
    face = len(nodes) + 1
    nodes += [{"name": mesh["name"], "mesh": number, "skin": 0} for number, mesh in enumerate(meshes)]
    tree: dict[str, Json] = {
        "scene": 0,
        "scenes": [{"name": "Understudy", "nodes": [0, face - 1, face]}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": [_material(name, colour) for name, colour in mannequin.colours.items()],
        "skins": [_skin(skeleton, accessors)],
        "animations": animations(_tracks(motion, skeleton, face), motion, accessors, sparse_for),
    }
    return to_glb_bytes(tree, accessors)


def _mesh(name: str, parts: tuple[MeshPart, ...], accessors: Accessors) -> dict[str, Json]:
    with_shapes = any(part.shapes for part in parts)
    mesh: dict[str, Json] = {"name": name, "primitives": [_primitive(part, accessors) for part in parts]}
    if with_shapes:
        mesh |= {"weights": [0.0] * len(FACE_SHAPES), "extras": {"targetNames": list(FACE_SHAPES)}}
    return mesh


def _primitive(part: MeshPart, accessors: Accessors) -> Json:
    surface = part.surface
    attributes: dict[str, Json] = {
        "POSITION": accessors.floats(surface.positions_m, bounds=True, target="ARRAY_BUFFER"),
        "NORMAL": accessors.floats(surface.normals, target="ARRAY_BUFFER"),
        "JOINTS_0": accessors.joints(np.where(part.weights > 0, part.joints, 0)),
        "WEIGHTS_0": accessors.floats(part.weights, target="ARRAY_BUFFER"),
    }
    primitive: dict[str, Json] = {
        "attributes": attributes,
        "indices": accessors.indices(surface.triangles),
        "material": MATERIALS.index(part.material),
    }
    if part.shapes:
        nothing = np.zeros_like(surface.positions_m)
        primitive["targets"] = [
            {"POSITION": accessors.displacements(part.shapes.get(name, nothing))} for name in FACE_SHAPES
        ]
    return primitive


def _material(name: str, colour: Colour) -> Json:
    return {
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [*colour, 1.0],
            "metallicFactor": 0.0,
            "roughnessFactor": 0.35 if name in _GLOSSY else 0.8,
        },
    }


def _skin(skeleton: Skeleton, accessors: Accessors) -> Json:
    """The joints' inverse bind matrices: pure translations, since no joint is rotated in the T-pose."""
    matrices = np.tile(np.eye(4), (len(skeleton.names), 1, 1))
    matrices[:, 3, :3] = -t_pose_m(skeleton)
    return {
        "inverseBindMatrices": accessors.floats(matrices),
        "skeleton": 0,
        "joints": list(range(len(skeleton.names))),
    }


def _tracks(motion: Motion, skeleton: Skeleton, face: int) -> Iterator[NodeTrack]:
    yield NodeTrack(0, "translation", motion.body.hips_m, Layer.BODY)
    for joint, name in enumerate(skeleton.names):
        yield joint_track(joint, name, motion.body.rotations[:, joint])
    weights = np.zeros((len(motion.shapes), len(FACE_SHAPES)), dtype=np.float32)
    np.clip(motion.shapes, 0.0, 1.0, out=weights[:, : motion.shapes.shape[1]], casting="same_kind")
    yield NodeTrack(face, "weights", weights, Layer.FACE)


_GLOSSY: Mapping[str, None] = {"eye_white": None, "iris": None, "pupil": None}
