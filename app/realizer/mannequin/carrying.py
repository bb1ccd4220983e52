"""Carries the average mannequin's surfaces over to a body of other proportions.

Every vertex lies about its joints as in the average body: as far along the bones as these are longer, as far across as
the flesh is thicker there. The trunk's thickness changes evenly from joint to joint, limbs keep theirs along a bone.
Conventions: metres in the T-pose, vertices (V, 3).
"""

from functools import lru_cache

import numpy as np

from ...model import FloatArray
from ...model.figure import Sex
from ..body.proportions import AVERAGE, Proportions
from ..body.skeleton import Skeleton
from .surface import Surface

_TRUNK = ("hips", "spine", "chest", "upperChest")
_JAW_M, _JAW_SOFTNESS_M = 0.030, 0.020
_JAWS = {Sex.FEMALE: 0.94, Sex.NEUTRAL: 1.0, Sex.MALE: 1.07}
"""How wide jaw and chin are."""


def carried(surface: Surface, shares: FloatArray, skeleton: Skeleton) -> Surface:
    """The surface on this skeleton; `shares` (V, J) are the joints' shares in each vertex, which sum to 1."""
    if skeleton.proportions == AVERAGE:
        return surface
    average, to = Skeleton.standing(), skeleton.proportions
    before_m, after_m = t_pose_m(average), t_pose_m(skeleton)
    positions = np.zeros_like(surface.positions_m)
    factors = np.zeros_like(surface.positions_m)
    for joint, name in enumerate(skeleton.names):
        touched = shares[:, joint] > 1e-4
        if touched.any():
            share, at_m = shares[touched, joint, None], surface.positions_m[touched]
            factor = _factors(name, at_m[:, 1], before_m[:, 1], to)
            positions[touched] += share * (after_m[joint] + factor * (at_m - before_m[joint]))
            factors[touched] += share * factor
    normals = surface.normals / factors
    return Surface(positions, normals / np.linalg.norm(normals, axis=1, keepdims=True), surface.triangles)


def t_pose_m(skeleton: Skeleton) -> FloatArray:
    """The joints' positions in the T-pose (J, 3)."""
    places = np.zeros_like(skeleton.offsets_m)
    for joint, parent in enumerate(skeleton.parents):
        places[joint] = skeleton.offsets_m[joint] + (places[parent] if parent >= 0 else 0.0)
    return places


def _factors(joint: str, height_m: FloatArray, joints_m: FloatArray, to: Proportions) -> FloatArray:
    """How much longer the flesh of a joint is along x, y and z (V, 3)."""
    ones = np.ones_like(height_m)
    if joint in _TRUNK:
        levels_m = joints_m[_trunk_rows()]
        wide, deep = (np.interp(height_m, levels_m, [of(each) for each in _TRUNK]) for of in (to.width, to.depth))
        return np.stack([wide, to.scale * ones, deep], axis=-1)
    part, girth = joint.removeprefix("left").removeprefix("right"), to.width(joint)
    if part in {"neck", "UpperLeg", "LowerLeg", "Foot", "Toes"}:
        along_y = np.stack([girth * ones, to.scale * ones, girth * ones], axis=-1)
        return to.scale * np.ones_like(along_y) if part in {"Foot", "Toes"} else along_y
    if joint == "head":
        return to.head * np.stack([ones, ones, ones], axis=-1)
    return np.stack([to.scale * ones, girth * ones, girth * ones], axis=-1)


@lru_cache(maxsize=1)
def _trunk_rows() -> list[int]:
    return Skeleton.standing().chain(*_TRUNK)


def on_head(points_m: FloatArray, to: Proportions) -> FloatArray:
    """Points (V, 3) in the space of the head's joint, on this body's head."""
    low = 0.5 + 0.5 * np.tanh((_JAW_M - points_m[:, 1]) / _JAW_SOFTNESS_M)
    jaw = 1 + (_JAWS[to.physique.sex] - 1) * low
    return np.asarray(to.head * points_m * np.stack([jaw, np.ones_like(jaw), np.ones_like(jaw)], axis=1))
