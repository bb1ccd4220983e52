"""Folds of clothes: shallow waves where cloth bunches, at elbows, waist and knees, mostly in the shading.

Conventions: metres in the T-pose of the average body; the left's folds are mirrored to the right. A fold displaces the
surface by a millimetre or two and tilts its normals as a deeper one would, since the mesh is too coarse for its shape.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ..body.skeleton import Skeleton
from .carrying import t_pose_m
from .surface import Surface

DEPTH_M = 0.0016
TILT = 2.3
"""How many times deeper folds look than they are."""
_STEP_M = 1e-3


@dataclass(frozen=True, slots=True)
class Folds:
    """Waves around a point at `offset_m` from a joint, fading over `reach_m`; `waves` are cycles per metre along x, y
    and z."""

    joint: str
    offset_m: tuple[float, float, float]
    reach_m: tuple[float, float, float]
    waves: tuple[float, float, float]
    depth: float = 1.0


FOLDS: Mapping[str, tuple[Folds, ...]] = MappingProxyType(
    {
        "jumper": (
            Folds("leftLowerArm", (-0.01, 0.0, 0.02), (0.055, 0.06, 0.05), (26.0, 9.0, -8.0)),
            Folds("leftHand", (-0.075, 0.0, 0.0), (0.035, 0.06, 0.06), (30.0, 0.0, 7.0), 0.7),
            Folds("leftUpperArm", (-0.02, -0.075, 0.03), (0.05, 0.055, 0.06), (14.0, 15.0, 0.0)),
            Folds("spine", (0.10, 0.0, 0.06), (0.09, 0.07, 0.12), (-5.0, 21.0, 0.0)),
            Folds("spine", (0.03, 0.09, 0.09), (0.07, 0.06, 0.09), (7.0, 15.0, 0.0), 0.6),
            Folds("upperChest", (0.09, -0.02, 0.08), (0.06, 0.08, 0.06), (13.0, -9.0, 0.0), 0.5),
        ),
        "legwear": (
            Folds("leftUpperLeg", (-0.02, -0.07, 0.06), (0.07, 0.06, 0.08), (11.0, 17.0, 0.0)),
            Folds("leftLowerLeg", (0.0, 0.01, 0.0), (0.07, 0.06, 0.07), (7.0, 24.0, 0.0)),
            Folds("leftFoot", (0.0, 0.09, 0.0), (0.06, 0.05, 0.07), (5.0, 27.0, 0.0)),
        ),
    }
)


def folded(surface: Surface, material: str, skeleton: Skeleton) -> Surface:
    """The surface with the folds of its material, if that has any."""
    folds = FOLDS.get(material)
    if not folds:
        return surface
    at_m = surface.positions_m
    heights = _heights(folds, at_m, skeleton)
    steps = _STEP_M * np.eye(3)
    slope = np.stack([_heights(folds, at_m + step, skeleton) - heights for step in steps], axis=-1) / _STEP_M
    slope -= np.sum(slope * surface.normals, axis=1, keepdims=True) * surface.normals
    normals = surface.normals - TILT * slope
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return replace(surface, positions_m=at_m + heights[:, None] * surface.normals, normals=normals)


def _heights(folds: tuple[Folds, ...], at_m: FloatArray, skeleton: Skeleton) -> FloatArray:
    """How far the folds stand out (V,)."""
    places_m, mirrored_m = t_pose_m(skeleton), at_m * [1.0, 1.0, 1.0]
    mirrored_m[:, 0] = np.abs(mirrored_m[:, 0])
    heights = np.zeros(len(at_m))
    for each in folds:
        way = mirrored_m - places_m[skeleton.index[each.joint]] - np.array(each.offset_m)
        fading = np.exp(-0.5 * np.sum((way / np.array(each.reach_m)) ** 2, axis=1))
        heights += each.depth * DEPTH_M * fading * np.sin(2 * np.pi * (way @ np.array(each.waves)))
    return heights
