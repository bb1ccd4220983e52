"""Carries places around the average body over to another: gesture space, rests, the listener.

Tables give places in metres about the average body. Around another body a place lies as much farther out as that body
is larger, and beside or before it as much farther as its flesh is thicker there; so hands that are by the hip, before
the belly or behind the back of one are there with the other. Conventions: (…, 3) in the hips' space of the upright
body, seen from the own side (x outwards, y up, z away), metres.
"""

from functools import lru_cache

import numpy as np

from ...model import FloatArray
from .contacts import TRUNK, Capsule
from .proportions import AVERAGE, Proportions
from .skeleton import Skeleton

_FOREARM_M = 0.035
_SHOULDER_M, _FRONT_M = 0.17, 0.10
"""From here on outwards, and away, a place is as far as can be from the flesh."""


def on_body_m(skeleton: Skeleton, place_m: FloatArray) -> FloatArray:
    """The place (…, 3) around this skeleton's body that `place_m` is around the average one."""
    to = skeleton.proportions
    if to == AVERAGE:
        return place_m
    heights_m, wider_m, deeper_m = _thicker(to)
    x, y, z = np.moveaxis(place_m, -1, 0)
    aside_m = np.interp(y, heights_m, wider_m) * np.clip(x / _SHOULDER_M, -1.0, 1.0)
    away_m = np.interp(y, heights_m, deeper_m) * np.clip(z / _FRONT_M, -1.0, 1.0)
    return np.stack([to.scale * x + aside_m, to.scale * y, to.scale * z + away_m], axis=-1)


@lru_cache(maxsize=64)
def _thicker(to: Proportions) -> tuple[FloatArray, FloatArray, FloatArray]:
    """At heights of the average body (N,), how much wider and deeper this one is than it would be by its size."""
    parts = {part.part: part for part in TRUNK}
    skeleton = Skeleton.standing()
    above_m = np.cumsum(skeleton.offsets_m[skeleton.chain("spine", "chest", "upperChest")][:, 1])
    levels = [
        (parts["pelvis"].start_m[1], *_excess_m(parts["pelvis"], to)),
        *(
            (up_m + parts[name].start_m[1], *_excess_m(parts[name], to))
            for name, up_m in zip(_UPPER, above_m, strict=True)
        ),
    ]
    shoulders = (levels[-1][0] + 0.07, _SHOULDER_M * (to.shoulders - to.scale), levels[-1][2])
    heights_m, wider_m, deeper_m = np.array([*levels, shoulders]).T
    return heights_m, wider_m, deeper_m


_UPPER = ("belly", "chest", "upper chest")


def _excess_m(part: Capsule, to: Proportions) -> tuple[float, float]:
    half_m, sleeve_m = part.end_m[0] + part.radius_m, _FOREARM_M * (to.width("leftLowerArm") - to.scale)
    return (
        half_m * (to.width(part.joint) - to.scale) + sleeve_m,
        part.radius_m * (to.depth(part.joint) - to.scale) + sleeve_m,
    )
