"""The colours of a mannequin's materials: linear light in [0, 1], from the sRGB colours of a character's looks."""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ...model.figure import Looks

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
