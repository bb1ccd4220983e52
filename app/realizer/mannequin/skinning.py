"""The mannequin: procedural skinned surfaces around a skeleton, and their deformation in a pose.

Conventions: metres, in the T-pose of the skeleton (`understudy.realizer.body.skeleton`). Surfaces are made around the
average body and carried over to the one at hand.
Each vertex is influenced by at most four joints, whose weights sum to 1.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from ...model import FloatArray
from ...model.figure import PLAIN, Hair, Legwear, Looks
from ..body.motion import SHAPES
from ..body.skeleton import SIDES, Skeleton, forward
from ..geometry.rotations import length, rotate
from . import head as mannequin_head
from .body import drawn_capsules, folded, garments_of, skinning_capsules
from .carrying import carried, on_head, t_pose_m
from .eyes import ball, brow, lids
from .face import displacements_m
from .head import teeth, tongue
from .looks import HANGS_FROM_M, HANGS_TO_M, Colour, colours_of, hair
from .surface import IntArray, SkinnedCapsule, Surface, distances_m, mesh

INFLUENCES = 4

SOFTNESS_M = 0.012
"""The distance from a joint over which skinning blends into the next one."""

FLESH_SOFTNESS_M = 0.03
"""The same for the thickness of the flesh, which changes slowly."""


@dataclass(frozen=True, slots=True, eq=False)
class MeshPart:
    """A surface of one material. `joints` (V, 4) influence each vertex with `weights` (V, 4); `shapes` are
    displacements (V, 3) by the blendshapes that affect it."""

    material: str
    surface: Surface
    joints: IntArray
    weights: FloatArray
    shapes: Mapping[str, FloatArray] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, eq=False)
class Mannequin:
    """The complete figure, and the colours of its materials."""

    skeleton: Skeleton
    parts: tuple[MeshPart, ...]
    colours: Mapping[str, Colour]

    @classmethod
    def around(cls, skeleton: Skeleton, looks: Looks = PLAIN.looks) -> "Mannequin":
        """The mannequin on this skeleton, of its proportions."""
        return cls(skeleton, _parts(skeleton, looks.hair, looks.legwear), colours_of(looks))


@lru_cache(maxsize=8)
def _parts(skeleton: Skeleton, hair: Hair, legwear: Legwear) -> tuple[MeshPart, ...]:
    """Cached, since building takes a second; never mutated."""
    garments = garments_of(skeleton.proportions.physique.sex, legwear)
    average = Skeleton.standing()
    bones = tuple(capsule for garment in garments for capsule in skinning_capsules(garment, average))
    parts = []
    for garment in garments:
        surface = mesh(drawn_capsules(garment, average), blend_m=garment.blend_m, grid_m=garment.grid_m)
        surface = folded(surface, garment.material, average)
        closeness = _hanging(surface, average) if garment.hangs else _closeness(surface, bones, average, SOFTNESS_M)
        flesh = closeness if garment.hangs else _closeness(surface, bones, average, FLESH_SOFTNESS_M)
        shares = flesh / flesh.sum(axis=1, keepdims=True)
        parts.append(MeshPart(garment.material, carried(surface, shares, skeleton), *_most(closeness)))
    return (*parts, *_head_parts(skeleton, hair))


def _hanging(surface: Surface, skeleton: Skeleton) -> FloatArray:
    """The joints' shares (V, J) in what hangs from the hips."""
    shares = np.zeros((len(surface.positions_m), len(skeleton.names)))
    low_m, high_m = (t_pose_m(skeleton)[skeleton.index[name], 1] for name in ("leftLowerLeg", "hips"))
    from_hips = np.clip((surface.positions_m[:, 1] - low_m) / (high_m - low_m), 0.0, 1.0)
    shares[:, skeleton.index["hips"]] = from_hips
    shares[:, skeleton.chain("leftLowerLeg", "rightLowerLeg")] = (1 - from_hips[:, None]) / 2
    return shares


def _head_parts(skeleton: Skeleton, style: Hair) -> tuple[MeshPart, ...]:
    """Everything attached to the head joint, and the eyeballs."""
    average = Skeleton.standing()
    moving = list(mannequin_head.skin())
    moving += [("teeth", *teeth(upper=upper)) for upper in (True, False)]
    moving.append(("tongue", *tongue()))
    fixed = [("skin", mannequin_head.ears(), "head")]
    for side in SIDES:
        eye_m = average.offsets_m[average.index[f"{side}Eye"]]
        moving += [*lids(eye_m, side), ("brows", *brow(side))]
        fixed += [(material, surface, f"{side}Eye") for material, surface in ball(eye_m)]
    rigid = [_on_head(material, surface, skeleton, joint) for material, surface, joint in fixed]
    grown = hair(style)
    hanging = () if grown is None else (_falling(_on_head("hair", grown, skeleton, "head"), grown, skeleton),)
    carried_along = [
        replace(_on_head(material, surface, skeleton, "head"), shapes=_scaled(displacements_m(tissue), skeleton))
        for material, surface, tissue in moving
    ]
    return (*rigid, *hanging, *carried_along)


def _scaled(shapes: Mapping[str, FloatArray], skeleton: Skeleton) -> dict[str, FloatArray]:
    return {name: skeleton.proportions.head * moved for name, moved in shapes.items()}


def _on_head(material: str, surface: Surface, skeleton: Skeleton, joint: str) -> MeshPart:
    """A part attached to one joint, whose surface is given in the space of the average head."""
    count = len(surface.positions_m)
    joints = np.zeros((count, INFLUENCES), dtype=np.int64)
    joints[:, 0] = skeleton.index[joint]
    weights = np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
    head_m = t_pose_m(skeleton)[skeleton.index["head"]]
    positions_m = head_m + on_head(surface.positions_m, skeleton.proportions)
    return MeshPart(material, replace(surface, positions_m=positions_m), joints, weights)


def _falling(part: MeshPart, grown: Surface, skeleton: Skeleton) -> MeshPart:
    """Hair that follows the chest below the chin."""
    below = np.clip((HANGS_FROM_M - grown.positions_m[:, 1]) / (HANGS_FROM_M - HANGS_TO_M), 0.0, 1.0)
    joints, weights = part.joints.copy(), part.weights.copy()
    joints[:, 1] = skeleton.index["upperChest"]
    weights[:, :2] = np.stack([1 - below, below], axis=1)
    return replace(part, joints=joints, weights=weights)


def joined(parts: tuple[MeshPart, ...]) -> tuple[MeshPart, ...]:
    """The parts merged by material, for rendering in one pass."""
    materials = dict.fromkeys(part.material for part in parts)
    return tuple(_as_one(tuple(part for part in parts if part.material == material)) for material in materials)


def _as_one(parts: tuple[MeshPart, ...]) -> MeshPart:
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
    return MeshPart(parts[0].material, surface, joints, weights, shapes)


def posed(mannequin: Mannequin, rotations: FloatArray, hips_m: FloatArray, shapes: FloatArray) -> tuple[Surface, ...]:
    """The surfaces in a pose: local `rotations` (J, 4), hip position `hips_m` (3,), blendshape weights `shapes`
    (52,)."""
    places, turns = forward(mannequin.skeleton, rotations, hips_m)
    moves, parts = places - rotate(turns, t_pose_m(mannequin.skeleton)), mannequin.parts
    weight = {name: share for name, share in zip(SHAPES, shapes, strict=True) if share}
    at = np.concatenate([_shaped(part, weight) for part in parts])
    across = np.concatenate([part.surface.normals for part in parts])
    joints, weights = (np.concatenate([getattr(part, name) for part in parts]) for name in ("joints", "weights"))
    positions, normals = np.zeros_like(at), np.zeros_like(at)
    for influence in range(INFLUENCES):
        moved = np.flatnonzero(weights[:, influence])
        joint, share = joints[moved, influence], weights[moved, influence, None]
        positions[moved] += share * (rotate(turns[joint], at[moved]) + moves[joint])
        normals[moved] += share * rotate(turns[joint], across[moved])
    normals /= length(normals)
    ends = np.cumsum([len(part.joints) for part in parts])[:-1]
    split = zip(parts, np.split(positions, ends), np.split(normals, ends), strict=True)
    return tuple(Surface(position, normal, part.surface.triangles) for part, position, normal in split)


def _shaped(part: MeshPart, weight: Mapping[str, float]) -> FloatArray:
    """The part's vertices, displaced by the blendshapes that have a weight."""
    moved = part.surface.positions_m.copy()
    for name, shape in part.shapes.items():
        if name in weight:
            moved += weight[name] * shape
    return moved


def _closeness(
    surface: Surface, bones: tuple[SkinnedCapsule, ...], skeleton: Skeleton, softness_m: float
) -> FloatArray:
    """How close each joint is to each vertex (V, J): 1 is the nearest, and the nearer to a bone's surface, the more."""
    distances = distances_m(bones, surface.positions_m)
    closeness = np.zeros((len(surface.positions_m), len(skeleton.names)))
    nearest = distances.min(axis=0)
    for bone, distance in zip(bones, distances, strict=True):
        joint = skeleton.index[bone.joint]
        closeness[:, joint] = np.maximum(closeness[:, joint], np.exp((nearest - distance) / softness_m))
    return closeness


def _most(closeness: FloatArray) -> tuple[IntArray, FloatArray]:
    """The joints (V, 4) with the most influence, and their weights."""
    joints = np.argsort(-closeness, axis=1)[:, :INFLUENCES]
    weights = np.take_along_axis(closeness, joints, axis=1)
    weights[weights < 0.02] = 0.0
    return joints, weights / weights.sum(axis=1, keepdims=True)
