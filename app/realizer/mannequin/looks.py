"""A character's looks on the mannequin: the colours of its materials, linear light in [0, 1] from the sRGB colours of
the character's file, and its hair, a cap of capsules for each style, in metres in the space of the average head's
joint.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ...model.figure import Hair, Looks
from .surface import SkinnedCapsule, Surface, mesh

Colour = tuple[float, float, float]

_OF_LOOKS: Mapping[str, str] = MappingProxyType(
    {
        "skin": "skin_colour",
        "jumper": "top_colour",
        "legwear": "legwear_colour",
        "shoes": "shoe_colour",
        "hair": "hair_colour",
        "brows": "hair_colour",
        "iris": "eye_colour",
    }
)
_LIPS_OF_SKIN = np.array([0.79, 0.55, 0.63])
_BROW_OF_HAIR = 0.7
_OWN: Mapping[str, Colour] = MappingProxyType(
    {
        "lashes": (0.02, 0.015, 0.012),
        "mouth": (0.10, 0.02, 0.02),
        "teeth": (0.80, 0.77, 0.70),
        "tongue": (0.45, 0.14, 0.13),
        "eye_white": (0.82, 0.82, 0.80),
        "pupil": (0.008, 0.008, 0.01),
    }
)
MATERIALS: tuple[str, ...] = (*_OF_LOOKS, "lips", *_OWN)
"""The materials of every mannequin, in the order of files."""


def colours_of(looks: Looks) -> Mapping[str, Colour]:
    """The colour of each of `MATERIALS`."""
    found = {material: _linear(getattr(looks, field)) for material, field in _OF_LOOKS.items()}
    found["brows"] = _triple(_BROW_OF_HAIR * np.array(found["brows"]))
    found["lips"] = _triple(_LIPS_OF_SKIN * found["skin"])
    return MappingProxyType({material: (found | dict(_OWN))[material] for material in MATERIALS})


def _linear(colour: str) -> Colour:
    """The inverse of sRGB's transfer function."""
    shown = np.array([int(colour[place : place + 2], 16) for place in (1, 3, 5)]) / 255
    return _triple(np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4))


def _triple(light: FloatArray) -> Colour:
    red, green, blue = (float(part) for part in light)
    return red, green, blue


BLEND_M, GRID_M = 0.012, 0.010

HANGS_FROM_M, HANGS_TO_M = -0.02, -0.12
"""Between these heights long hair passes from the head's movement to the chest's."""


def _rod(
    start: tuple[float, float, float], end: tuple[float, float, float], first: float, last: float
) -> SkinnedCapsule:
    return SkinnedCapsule("head", start, end, first, last)


def _both(
    start: tuple[float, float, float], end: tuple[float, float, float], radius_m: float
) -> tuple[SkinnedCapsule, ...]:
    (x, y, z), (u, v, w) = start, end
    return _rod(start, end, radius_m, radius_m), _rod((-x, y, z), (-u, v, w), radius_m, radius_m)


_CAP = (
    _rod((0, 0.118, -0.020), (0, 0.128, 0.000), 0.080, 0.077),
    _rod((0, 0.056, -0.036), (0, 0.085, -0.022), 0.044, 0.066),
)
_FULL_CAP = (
    _rod((0, 0.116, -0.022), (0, 0.130, 0.000), 0.086, 0.081),
    _rod((0, 0.056, -0.036), (0, 0.085, -0.022), 0.050, 0.070),
)
STYLES: Mapping[Hair, tuple[SkinnedCapsule, ...]] = MappingProxyType(
    {
        Hair.BALD: (),
        Hair.SHORT: (
            *_CAP,
            _rod((-0.040, 0.164, 0.034), (0.044, 0.172, 0.026), 0.024, 0.030),
            _rod((-0.056, 0.146, 0.024), (-0.030, 0.170, 0.040), 0.016, 0.020),
            *_both((0.072, 0.110, 0.004), (0.0735, 0.090, 0.008), 0.008),
        ),
        Hair.BOB: (
            *_FULL_CAP,
            *_both((0.064, 0.105, -0.014), (0.068, 0.010, -0.022), 0.026),
            *_both((0.040, 0.080, -0.062), (0.044, 0.004, -0.055), 0.036),
        ),
        Hair.LONG: (
            *_FULL_CAP,
            *_both((0.066, 0.105, -0.016), (0.074, -0.060, -0.040), 0.026),
            *_both((0.036, 0.080, -0.066), (0.048, -0.170, -0.100), 0.040),
        ),
        Hair.BUN: (
            *_CAP,
            _rod((0, 0.150, -0.104), (0, 0.158, -0.114), 0.034, 0.032),
        ),
    }
)


def hair(style: Hair) -> Surface | None:
    """The hair's surface; None for the bald."""
    capsules = STYLES[style]
    return mesh(capsules, blend_m=BLEND_M, grid_m=GRID_M) if capsules else None
