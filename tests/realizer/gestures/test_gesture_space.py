"""Where a place of gesture space is, and how an amplitude scales it."""

from dataclasses import replace

import numpy as np
import pytest

from understudy.realizer.gestures.gesture import Depth, HeightSector, SectorPlace, Sideways
from understudy.realizer.gestures.gesture_space import NEAREST_M, offset_from_centre_m, sector_m

CENTRE = SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE)
NEAR = replace(CENTRE, depth=Depth.NEAR)


def test_an_amplitude_scales_the_distance_from_the_centre() -> None:
    far = SectorPlace(Sideways.EP, HeightSector.UPPER_P, Depth.FAR)
    assert sector_m(far, 1.5) - sector_m(CENTRE) == pytest.approx(1.5 * (sector_m(far) - sector_m(CENTRE)))


def test_a_large_movement_brings_no_hand_into_the_chest() -> None:
    assert NEAREST_M < sector_m(NEAR, 1.3)[2] < sector_m(NEAR)[2]
    assert sector_m(NEAR, 2.0)[2] == NEAREST_M


def test_what_is_at_the_chest_by_itself_stays_there() -> None:
    at_chest = replace(NEAR, offset_m=(0.0, 0.0, -0.12))
    assert sector_m(at_chest, 1.6)[2] == sector_m(at_chest)[2]
    assert sector_m(at_chest, 0.6)[2] > sector_m(at_chest)[2]


@pytest.mark.parametrize("amplitude", [0.4, 1.0, 1.7])
@pytest.mark.parametrize("wrist_m", [(0.4, 0.1, 0.08), (-0.1, 0.5, 0.5)])
def test_an_offset_brings_the_wrist_where_it_is_wanted(amplitude: float, wrist_m: tuple[float, float, float]) -> None:
    place = replace(CENTRE, offset_m=offset_from_centre_m(np.array(wrist_m), amplitude))
    assert sector_m(place, amplitude) == pytest.approx(np.array(wrist_m))
