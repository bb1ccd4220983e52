"""The mannequin: procedural skinned surfaces around a skeleton, and their deformation in a pose.

Conventions: metres, in the T-pose of the skeleton (`understudy.realizer.body.skeleton`); colours are linear, in [0, 1].
Each vertex is influenced by at most four joints, whose weights sum to 1.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ..body.motion import SHAPES
from ..body.skeleton import SIDES, Skeleton, forward
from ..geometry.rotations import rotate
from . import head as mannequin_head
from .body import GARMENTS, drawn_capsules, skinning_capsules, t_pose_m
from .eyes import ball, brow, lids
from .face import displacements_m
from .mouth import teeth, tongue
from .surface import Capsule, IntArray, Surface, distances_m, mesh

INFLUENCES = 4

SOFTNESS_M = 0.009
"""The distance from a joint over which skinning blends into the next one."""

COLOURS: Mapping[str, tuple[float, float, float]] = MappingProxyType(
    {
        "skin": (0.56, 0.345, 0.245),
        "jumper": (0.10, 0.20, 0.27),
        "trousers": (0.055, 0.065, 0.085),
        "shoes": (0.03, 0.03, 0.035),
        "hair": (0.045, 0.03, 0.022),
        "lips": (0.44, 0.19, 0.155),
        "mouth": (0.10, 0.02, 0.02),
        "teeth": (0.80, 0.77, 0.70),
        "tongue": (0.45, 0.14, 0.13),
        "eye_white": (0.82, 0.82, 0.80),
        "iris": (0.10, 0.17, 0.20),
        "pupil": (0.008, 0.008, 0.01),
    }
)


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A surface of one material. `joints` (V, 4) influence each vertex with `weights` (V, 4); `shapes` are
    displacements (V, 3) by the blendshapes that affect it."""

    material: str
    surface: Surface
    joints: IntArray
    weights: FloatArray
    shapes: Mapping[str, FloatArray] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, eq=False)
class Mannequin:
    """The complete figure."""

    skeleton: Skeleton
    parts: tuple[Part, ...]

    @classmethod
    def around(cls, skeleton: Skeleton) -> "Mannequin":
        """The default mannequin on this skeleton."""
        return cls(skeleton, _parts(skeleton))


@lru_cache(maxsize=2)
def _parts(skeleton: Skeleton) -> tuple[Part, ...]:
    """Cached per skeleton, since building takes a second; never mutated."""
    bones = tuple(capsule for garment in GARMENTS for capsule in skinning_capsules(garment, skeleton))
    parts = []
    for garment in GARMENTS:
        surface = mesh(drawn_capsules(garment, skeleton), blend_m=garment.blend_m, grid_m=garment.grid_m)
        parts.append(Part(garment.material, surface, *_skinned(surface.positions_m, bones, skeleton)))
    return (*parts, *_head_parts(skeleton))


def _head_parts(skeleton: Skeleton) -> tuple[Part, ...]:
    """Everything attached to the head joint, and the eyeballs."""
    moving = list(mannequin_head.skin())
    moving += [("teeth", *teeth(upper=upper)) for upper in (True, False)]
    moving.append(("tongue", *tongue()))
    fixed = [("skin", mannequin_head.ears(), "head"), ("hair", mannequin_head.hair(), "head")]
    for side in SIDES:
        eye_m = skeleton.offsets_m[skeleton.index[f"{side}Eye"]]
        moving += [*lids(eye_m, side), ("hair", *brow(side))]
        fixed += [(material, surface, f"{side}Eye") for material, surface in ball(eye_m)]
    head_m = t_pose_m(skeleton)[skeleton.index["head"]]
    rigid = [_rigid(material, surface, skeleton.index[joint], head_m) for material, surface, joint in fixed]
    carried = [
        replace(_rigid(material, surface, skeleton.index["head"], head_m), shapes=displacements_m(tissue))
        for material, surface, tissue in moving
    ]
    return (*rigid, *carried)


def _rigid(material: str, surface: Surface, joint: int, origin_m: FloatArray) -> Part:
    """A part attached to one joint, whose surface is given relative to `origin_m`."""
    count = len(surface.positions_m)
    joints = np.zeros((count, INFLUENCES), dtype=np.int64)
    joints[:, 0] = joint
    weights = np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
    return Part(material, replace(surface, positions_m=surface.positions_m + origin_m), joints, weights)


def joined(parts: tuple[Part, ...]) -> tuple[Part, ...]:
    """The parts merged by material, for rendering in one pass."""
    materials = dict.fromkeys(part.material for part in parts)
    return tuple(_as_one(tuple(part for part in parts if part.material == material)) for material in materials)


def _as_one(parts: tuple[Part, ...]) -> Part:
    starts = np.cumsum([0, *(len(part.joints) for part in parts)])
    surface = Surface(
        np.concatenate([part.surface.positions_m for part in parts]),
        np.concatenate([part.surface.normals for part in parts]),
        np.concatenate([part.surface.triangles + start for part, start in zip(parts, starts, strict=False)]),
    )
    shapes = {name: np.zeros_like(surface.positions_m) for part in parts for name in part.shapes}
    for part, start in zip(parts, starts, strict=False):
        for name, moved in part.shapes.items():
            shapes[name][start : start + len(moved)] = moved
    joints, weights = (np.concatenate([getattr(part, name) for part in parts]) for name in ("joints", "weights"))
    return Part(parts[0].material, surface, joints, weights, shapes)


def posed(mannequin: Mannequin, rotations: FloatArray, hips_m: FloatArray, shapes: FloatArray) -> tuple[Surface, ...]:
    """The surfaces in a pose: local `rotations` (J, 4), hip position `hips_m` (3,), blendshape weights `shapes`
    (52,)."""
    places, turns = forward(mannequin.skeleton, rotations, hips_m)
    moves = places - rotate(turns, t_pose_m(mannequin.skeleton))
    weight = dict(zip(SHAPES, shapes, strict=True))
    return tuple(_posed(part, turns, moves, weight) for part in mannequin.parts)


def _posed(part: Part, turns: FloatArray, moves: FloatArray, weight: Mapping[str, float]) -> Surface:
    at = part.surface.positions_m + sum(
        (weight[name] * shape for name, shape in part.shapes.items() if weight.get(name)), np.zeros(3)
    )
    positions, normals = np.zeros_like(at), np.zeros_like(at)
    for k in range(INFLUENCES):
        turn, share = turns[part.joints[:, k]], part.weights[:, k, None]
        positions += share * (rotate(turn, at) + moves[part.joints[:, k]])
        normals += share * rotate(turn, part.surface.normals)
    return Surface(positions, normals / np.linalg.norm(normals, axis=-1, keepdims=True), part.surface.triangles)


def _skinned(points_m: FloatArray, bones: tuple[Capsule, ...], skeleton: Skeleton) -> tuple[IntArray, FloatArray]:
    """The joints (V, 4) that influence the points, and their weights: the nearer to a bone's surface, the more."""
    distances = distances_m(bones, points_m)
    closeness = np.zeros((len(points_m), len(skeleton.names)))
    nearest = distances.min(axis=0)
    for bone, distance in zip(bones, distances, strict=True):
        joint = skeleton.index[bone.joint]
        closeness[:, joint] = np.maximum(closeness[:, joint], np.exp((nearest - distance) / SOFTNESS_M))
    joints = np.argsort(-closeness, axis=1)[:, :INFLUENCES]
    weights = np.take_along_axis(closeness, joints, axis=1)
    weights[weights < 0.02] = 0.0
    return joints, weights / weights.sum(axis=1, keepdims=True)
