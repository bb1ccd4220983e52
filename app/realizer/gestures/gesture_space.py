"""McNeill's gesture space in metres: the wrist's position for each sector.

Conventions: the origin is the hips joint of the upright body; x points to the arm's own side, y up, z away from the
body. The heights follow docs/references.md, where 0 is the hips and 1 the shoulders; Gesture Engine §4.2 has `YUpperP`
at the shoulders. McNeill (1992) defines the sectors without metres; these fit the default body (arm .53 m to the
wrist), so that nearly every sector is within reach.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from .gesture import Depth, HandDirection, HeightSector, SectorPlace, Sideways

DIRECTIONS: Mapping[HandDirection, tuple[float, float, float]] = MappingProxyType(
    {
        HandDirection.UP: (0.0, 1.0, 0.0),
        HandDirection.DOWN: (0.0, -1.0, 0.0),
        HandDirection.INWARDS: (-1.0, 0.0, 0.0),
        HandDirection.OUTWARDS: (1.0, 0.0, 0.0),
        HandDirection.AWAY: (0.0, 0.0, 1.0),
        HandDirection.TOWARDS: (0.0, 0.0, -1.0),
    }
)
"""Unit vectors of the directions in these axes."""

SHOULDERS_ABOVE_HIPS_M = 0.43

SIDEWAYS_M: Mapping[Sideways, float] = MappingProxyType(
    {
        Sideways.EP: 0.54,
        Sideways.P: 0.36,
        Sideways.C: 0.20,
        Sideways.CC: 0.06,
        Sideways.OPP_C: -0.06,
        Sideways.OPP_P: -0.17,
        Sideways.OPP_EP: -0.28,
    }
)
HEIGHT: Mapping[HeightSector, float] = MappingProxyType(
    {
        HeightSector.UPPER_EP: 1.40,
        HeightSector.UPPER_P: 1.00,
        HeightSector.UPPER_C: 0.74,
        HeightSector.CC: 0.50,
        HeightSector.LOWER_C: 0.28,
        HeightSector.LOWER_P: 0.05,
        HeightSector.LOWER_EP: -0.25,
    }
)
"""As shares of the distance from the hips to the shoulders."""

DEPTH_M: Mapping[Depth, float] = MappingProxyType({Depth.NEAR: 0.20, Depth.MIDDLE: 0.31, Depth.FAR: 0.42})

NEAREST_M = 0.10
"""An amplitude brings no wrist nearer to the body than this, unless its gesture does so by itself."""

_UP_M = {height: share * SHOULDERS_ABOVE_HIPS_M for height, share in HEIGHT.items()}
_CENTRE_AS_NUMBERS_M = SIDEWAYS_M[Sideways.C], _UP_M[HeightSector.CC], DEPTH_M[Depth.MIDDLE]
_CENTRE_M = np.array(_CENTRE_AS_NUMBERS_M)


def sector_m(place: SectorPlace, amplitude: float = 1.0) -> FloatArray:
    """The wrist's position (3,) for a place: outwards, above the hips, away. `amplitude` scales its distance from the
    centre, but a larger movement is not one into the chest."""
    return np.array(place_m(place, amplitude))


def place_m(place: SectorPlace, amplitude: float = 1.0) -> tuple[float, float, float]:
    """The same position as numbers, of which few are computed sooner without arrays."""
    x_m, y_m, z_m = place.offset_m
    out_m, up_m, away_m = _CENTRE_AS_NUMBERS_M
    x_m, y_m, z_m = x_m + SIDEWAYS_M[place.sideways], y_m + _UP_M[place.height], z_m + DEPTH_M[place.depth]
    scaled_m = away_m + amplitude * (z_m - away_m)
    return (
        out_m + amplitude * (x_m - out_m),
        up_m + amplitude * (y_m - up_m),
        max(scaled_m, min(z_m, NEAREST_M)),
    )


def offset_from_centre_m(wrist_m: FloatArray, amplitude: float) -> tuple[float, float, float]:
    """The offset to the sector of the centre that brings the wrist to a position (3,) at that amplitude: what
    `sector_m` undoes."""
    x_m, y_m, z_m = (wrist_m - _CENTRE_M).tolist()
    is_kept = amplitude > 1 and wrist_m[2] < NEAREST_M
    return x_m / amplitude, y_m / amplitude, z_m if is_kept else z_m / amplitude
