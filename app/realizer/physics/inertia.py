"""How hard a part of the body is to turn: the inertia of everything beyond a joint."""

from functools import lru_cache

import numpy as np

from ...model import FloatArray
from ..body.masses import parts_of
from ..body.skeleton import Skeleton


@lru_cache(maxsize=1024)
def inertia_beyond_kg_m2(skeleton: Skeleton, joint: str) -> float:
    """The inertia about a joint of everything that it carries, in the T-pose: about an axis across the way to
    each part."""
    places_m = _places_m(skeleton)
    about_m = places_m[skeleton.index[joint]]
    found = 0.0
    for part in parts_of(skeleton):
        at = skeleton.index[part.joint]
        if _carries(skeleton, skeleton.index[joint], at):
            away_m = places_m[at] + np.array(part.centre_m) - about_m
            found += float(np.mean(part.inertia_kg_m2)) + part.mass_kg * float(away_m @ away_m)
    return found


@lru_cache(maxsize=64)
def _places_m(skeleton: Skeleton) -> list[FloatArray]:
    places_m: list[FloatArray] = []
    for parent, offset_m in zip(skeleton.parents, skeleton.offsets_m, strict=True):
        places_m.append(offset_m + (places_m[parent] if parent >= 0 else 0.0))
    return places_m


def _carries(skeleton: Skeleton, joint: int, other: int) -> bool:
    while other > joint:
        other = skeleton.parents[other]
    return other == joint
