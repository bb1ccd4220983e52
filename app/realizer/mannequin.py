"""The mannequin: skinned surfaces around a skeleton, drawn by code, and what they look like in a pose.

Conventions: metres, in the T-pose of the skeleton (`app.realizer.skeleton`); colours are linear, in [0, 1]. Each vertex
follows at most four joints, whose weights sum to 1.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from app.model import FloatArray
from app.realizer.mannequin_body import GARMENTS, capsules, t_pose_m
from app.realizer.mannequin_surface import Capsule, IntArray, Surface, distances_m, mesh
from app.realizer.motion import SHAPES
from app.realizer.rotations import rotate
from app.realizer.skeleton import Skeleton, forward

INFLUENCES = 4

SOFTNESS_M = 0.009
"""How far from a joint the skin begins to follow the next one."""

COLOURS: Mapping[str, tuple[float, float, float]] = MappingProxyType(
    {
        "skin": (0.62, 0.40, 0.29),
        "jumper": (0.10, 0.20, 0.27),
        "trousers": (0.055, 0.065, 0.085),
        "shoes": (0.03, 0.03, 0.035),
    }
)


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A surface of one material. `joints` (V, 4) are those that each vertex follows, by `weights` (V, 4); `shapes` are
    the displacements (V, 3) of the face shapes that move it."""

    material: str
    surface: Surface
    joints: IntArray
    weights: FloatArray
    shapes: Mapping[str, FloatArray] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, eq=False)
class Mannequin:
    """The whole figure."""

    skeleton: Skeleton
    parts: tuple[Part, ...]

    @classmethod
    def around(cls, skeleton: Skeleton) -> "Mannequin":
        """The mannequin that we ship, about this skeleton."""
        made = {garment: capsules(garment, skeleton) for garment in GARMENTS}
        bones = tuple(capsule for each in made.values() for capsule in each)
        parts = []
        for garment, its in made.items():
            surface = mesh(its, melt_m=garment.melt_m, grid_m=garment.grid_m)
            parts.append(Part(garment.material, surface, *_skinned(surface.positions_m, bones, skeleton)))
        return cls(skeleton, tuple(parts))


def posed(mannequin: Mannequin, rotations: FloatArray, hips_m: FloatArray, shapes: FloatArray) -> tuple[Surface, ...]:
    """The parts in a pose: local `rotations` (J, 4), `hips_m` (3,), the face's `shapes` (52,)."""
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
    """The joints (V, 4) that points follow and how much: the nearer a bone's skin, the more."""
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
