"""VRM files of our own mannequin, as others' avatars are made: its bones have other names, in VRM 1.0 axes of their own
at rest, in VRM 0 they face -Z; the face has expressions alone, for its morph targets have names that nobody knows."""

import re
from typing import Any, Literal

import numpy as np
from scipy.spatial.transform import Rotation

from tests.support.motion.gltf_reading import read
from tests.support.motion.hand_made_motion import BODY, still
from understudy.model import FloatArray
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.exporting.gltf import Accessors, to_glb_bytes
from understudy.realizer.mannequin.face import FACE_SHAPES

SHAPES_SHOWN = {
    "aa": "viseme_aa",
    "ih": "viseme_I",
    "ou": "viseme_U",
    "ee": "viseme_E",
    "oh": "viseme_O",
    "blinkLeft": "eyeBlinkLeft",
    "blinkRight": "eyeBlinkRight",
}
"""The shape that each expression shows."""
NAMES_IN_VRM_0 = dict(zip(SHAPES_SHOWN, ("a", "i", "u", "e", "o", "blink_l", "blink_r"), strict=True))
THUMBS_IN_VRM_0 = {"ThumbProximal": "ThumbIntermediate", "ThumbMetacarpal": "ThumbProximal"}
FACE_MESH = 1


def vrm_of_the_mannequin(version: Literal[0, 1]) -> bytes:
    """The file, in the T-pose."""
    given = read(to_glb(still(2), BODY))
    joints = len(BODY.names)
    front = Rotation.from_euler("y", 180 if version == 0 else 0, degrees=True)
    turns = [_axes(joint) if version == 1 else Rotation.identity() for joint in range(joints)]
    tree = given.tree
    accessors = Accessors(tree["bufferViews"], tree["accessors"], given.buffer)
    skin = tree["skins"][0] | {"inverseBindMatrices": accessors.floats(_inverse_binds(turns, front))}
    mesh = tree["meshes"][FACE_MESH]
    unknown = {"extras": {"targetNames": [f"Fcl_{number}" for number in range(len(FACE_SHAPES))]}}
    own = {
        "nodes": [*_bones(tree["nodes"], turns, front), *tree["nodes"][joints:]],
        "meshes": [*tree["meshes"][:FACE_MESH], mesh | unknown],
        "skins": [skin],
        **(_vrm_1(joints + FACE_MESH) if version == 1 else _vrm_0()),
    }
    kept = {key: tree[key] for key in ("scene", "scenes", "materials")}
    return to_glb_bytes(kept | own, accessors)


def _axes(joint: int) -> Rotation:
    return Rotation.from_euler("xyz", [20 * joint, 7 * joint, 0], degrees=True)


def _bones(nodes: list[dict[str, Any]], turns: list[Rotation], front: Rotation) -> list[dict[str, Any]]:
    """The nodes of the joints by other names, each turned so in the body's space."""
    bones = []
    for joint, parent in enumerate(BODY.parents):
        above = turns[parent].inv() if parent >= 0 else Rotation.identity()
        moved = above.apply(front.apply(nodes[joint]["translation"]))
        own = {"translation": moved.tolist(), "rotation": (above * turns[joint]).as_quat().tolist()}
        bones.append(nodes[joint] | own | {"name": f"J_{joint}"})
    return bones


def _inverse_binds(turns: list[Rotation], front: Rotation) -> FloatArray:
    """A matrix a joint (J, 4, 4), by columns: from the mannequin as it was given into the joint at rest."""
    matrices = np.tile(np.eye(4), (len(turns), 1, 1))
    places_m = np.zeros((len(turns), 3))
    for joint, parent in enumerate(BODY.parents):
        places_m[joint] = BODY.offsets_m[joint] + (places_m[parent] if parent >= 0 else 0.0)
        matrices[joint, :3, :3] = (turns[joint].inv() * front).as_matrix()
        matrices[joint, :3, 3] = turns[joint].inv().apply(-front.apply(places_m[joint]))
    return matrices.transpose(0, 2, 1)


def _vrm_1(face: int) -> dict[str, Any]:
    expressions = {
        name: {"morphTargetBinds": [{"node": face, "index": FACE_SHAPES.index(shape), "weight": 1.0}]}
        for name, shape in SHAPES_SHOWN.items()
    }
    extension = {
        "specVersion": "1.0",
        "meta": {"name": "Mannequin", "authors": ["Understudy"], "licenseUrl": "https://vrm.dev/licenses/1.0/"},
        "humanoid": {"humanBones": {name: {"node": joint} for name, joint in BODY.index.items()}},
        "expressions": {"preset": expressions},
    }
    return {"extensionsUsed": ["VRMC_vrm"], "extensions": {"VRMC_vrm": extension}}


def _vrm_0() -> dict[str, Any]:
    groups = [
        {
            "name": name,
            "presetName": NAMES_IN_VRM_0[name],
            "binds": [{"mesh": FACE_MESH, "index": FACE_SHAPES.index(shape), "weight": 100}],
        }
        for name, shape in SHAPES_SHOWN.items()
    ]
    bones = [{"bone": _name_in_vrm_0(name), "node": joint} for name, joint in BODY.index.items()]
    extension = {
        "specVersion": "0.0",
        "meta": {"title": "Mannequin"},
        "humanoid": {"humanBones": bones},
        "blendShapeMaster": {"blendShapeGroups": groups},
    }
    return {"extensionsUsed": ["VRM"], "extensions": {"VRM": extension}}


def _name_in_vrm_0(joint: str) -> str:
    return re.sub("Thumb(Proximal|Metacarpal)", lambda found: THUMBS_IN_VRM_0[found[0]], joint)
