"""Exports a VRM animation (`.vrma`, VRMC_vrm_animation 1.0) that plays on any VRM avatar.

Conventions: VRM's T-pose at rest, metres, 30 frames per second where the motion's rate is a multiple of it. Only the
hips are translated, nothing is scaled. An expression's weight is the x of its node's translation; the eyes' rotation is
that of the `lookAt` node (the mean of both eyes), so the eye bones have no tracks. Avatars have few expressions: the
five vowels are fitted to the ARKit shapes frame by frame. With `shapes`, the 52 ARKit shapes become custom expressions
instead, for avatars that have them ("perfect sync"), and the presets are left out so that the face does not move twice.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ..body.motion import SHAPES, Motion
from ..body.skeleton import Skeleton
from ..geometry.rotations import slerp, with_continuous_signs
from ..mannequin.face import VISEME_MIXTURES
from .animations import events_json
from .gltf import Accessors, Json, Tracks, joint_nodes, to_glb_bytes

EXTENSION = "VRMC_vrm_animation"
FRAME_RATE_HZ = 30
EYES = ("leftEye", "rightEye")
LOOK_AT_M = (0.0, 0.075, 0.085)

VOWELS: Mapping[str, str] = MappingProxyType({"aa": "aa", "ih": "I", "ou": "U", "ee": "E", "oh": "O"})
"""VRM's mouth expressions and their visemes."""

MOODS: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "happy": {"mouthSmileLeft": 0.5, "mouthSmileRight": 0.5},
        "angry": {"browDownLeft": 0.35, "browDownRight": 0.35, "noseSneerLeft": 0.15, "noseSneerRight": 0.15},
        "sad": {"browInnerUp": 0.4, "mouthFrownLeft": 0.3, "mouthFrownRight": 0.3},
        "surprised": {"browOuterUpLeft": 0.2, "browOuterUpRight": 0.2, "eyeWideLeft": 0.3, "eyeWideRight": 0.3},
    }
)
LIDS: Mapping[str, str] = MappingProxyType({"blinkLeft": "eyeBlinkLeft", "blinkRight": "eyeBlinkRight"})

_FIT_STEPS = 60


def to_vrma(motion: Motion, skeleton: Skeleton, *, shapes: bool = False) -> bytes:
    """The animation; `shapes` exports the ARKit shapes as custom expressions instead of VRM's presets."""
    frames = slice(None, None, _stride(motion))
    weights = np.clip(motion.shapes[frames], 0.0, 1.0)
    expressions = {name: weights[:, k] for k, name in enumerate(SHAPES)} if shapes else presets(weights)
    nodes = joint_nodes(skeleton)
    look_at, first = len(nodes), len(nodes) + 1
    nodes[skeleton.index["head"]]["children"] = [*(skeleton.index[eye] for eye in EYES), look_at]
    nodes.append({"name": "lookAt", "translation": list(LOOK_AT_M)})
    nodes += [{"name": name} for name in expressions]
    accessors = Accessors()
    tracks = Tracks(accessors, np.arange(len(weights)) * _stride(motion) / motion.frame_rate_hz)
    _add_body(tracks, motion, skeleton, frames)
    tracks.add(look_at, "rotation", with_continuous_signs(_gaze(motion, skeleton, frames)))
    for number, values in enumerate(expressions.values()):
        tracks.add(first + number, "translation", np.pad(values[:, None], ((0, 0), (0, 2))))
    named: Json = {name: {"node": first + number} for number, name in enumerate(expressions)}
    extension = _extension(skeleton, {"custom" if shapes else "preset": named}, look_at)
    tree: dict[str, Json] = {
        "extensionsUsed": [EXTENSION],
        "extensions": {EXTENSION: extension},
        "scene": 0,
        "scenes": [{"nodes": [0, *range(first, len(nodes))]}],
        "nodes": nodes,
        "animations": [{"name": "performance", **tracks.tree(), "extras": events_json(motion)}],
    }
    return to_glb_bytes(tree, accessors)


def _stride(motion: Motion) -> int:
    """The number of motion frames per frame of the animation."""
    return motion.frame_rate_hz // FRAME_RATE_HZ if motion.frame_rate_hz % FRAME_RATE_HZ == 0 else 1


def _extension(skeleton: Skeleton, expressions: Json, look_at: int) -> Json:
    bones: Json = {name: {"node": joint} for joint, name in enumerate(skeleton.names) if name not in EYES}
    return {
        "specVersion": "1.0",
        "humanoid": {"humanBones": bones},
        "expressions": expressions,
        "lookAt": {"node": look_at},
    }


def presets(weights: FloatArray) -> dict[str, FloatArray]:
    """The weights (T,) of the VRM expressions that approximate the ARKit shapes (T, 52)."""
    found = dict(zip(VOWELS, _vowels(weights).T, strict=True))
    for name, shape in LIDS.items():
        found[name] = weights[:, SHAPES.index(shape)]
    for name, mixture in MOODS.items():
        found[name] = np.clip(sum(share * weights[:, SHAPES.index(shape)] for shape, share in mixture.items()), 0, 1)
    return found


def _vowels(weights: FloatArray) -> FloatArray:
    """Vowel weights (T, 5) by non-negative least squares: the mixture of vowel shapes nearest to each frame's mouth."""
    mouth = [k for k, name in enumerate(SHAPES) if name.startswith(("jawOpen", "mouth"))]
    basis = np.stack([_viseme_shapes(viseme)[mouth] for viseme in VOWELS.values()])
    gram, seen = basis @ basis.T, weights[:, mouth] @ basis.T
    step = 1.0 / float(np.linalg.eigvalsh(gram)[-1])
    found = np.zeros((len(weights), len(VOWELS)))
    for _ in range(_FIT_STEPS):
        found = np.clip(found - step * (found @ gram - seen), 0.0, 1.0)
    return np.where(found < 1e-4, 0.0, found)


def _viseme_shapes(viseme: str) -> FloatArray:
    """The ARKit shapes (52,) of a viseme."""
    shapes = np.zeros(len(SHAPES))
    for name, weight in VISEME_MIXTURES[viseme].items():
        for k, shape in enumerate(SHAPES):
            if shape.removesuffix("Left").removesuffix("Right") == name:
                shapes[k] = weight
    return shapes


def _add_body(tracks: Tracks, motion: Motion, skeleton: Skeleton, frames: slice) -> None:
    tracks.add(0, "translation", motion.body.hips_m[frames])
    for joint, name in enumerate(skeleton.names):
        if name not in EYES:
            tracks.add(joint, "rotation", with_continuous_signs(motion.body.rotations[frames, joint]))


def _gaze(motion: Motion, skeleton: Skeleton, frames: slice) -> FloatArray:
    """The mean rotation of both eyes (T, 4)."""
    left, right = (motion.body.rotations[frames, skeleton.index[eye]] for eye in EYES)
    return slerp(left, right, np.full(len(left), 0.5))
