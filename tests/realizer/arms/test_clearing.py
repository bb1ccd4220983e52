"""A stretch of frames is cleared without a jump, on the side that is asked for."""

import numpy as np
import pytest

from tests.realizer.arms.test_collisions import BODY, INSIDE, MIDDLE, moving
from understudy.model import Hand
from understudy.realizer.arms.clearing import Aside, ClearingMode, cleared
from understudy.realizer.body.contacts import PosedBody, depths_m
from understudy.realizer.gestures.gesture import SectorPlace

SWELL = 11


@pytest.mark.parametrize("as_it_ends", [False, True])
@pytest.mark.parametrize("keys", [((Hand.LEFT, INSIDE),), ((Hand.LEFT, MIDDLE), (Hand.RIGHT, MIDDLE))])
def test_limbs_leave_what_they_are_in(keys: tuple[tuple[Hand, SectorPlace], ...], as_it_ends: bool) -> None:
    body = moving(*keys)
    posed, everywhere = PosedBody.of(BODY, body.rotations, body.hips_m), np.ones((len(body.times_s), 1))
    rotations, left_m = cleared(BODY, posed, ClearingMode(SWELL, 0.3, as_it_ends), everywhere)
    assert left_m <= 0
    assert depths_m(BODY, rotations, body.hips_m).max() == pytest.approx(left_m, abs=1e-9)


def test_what_would_make_a_joint_jump_is_not_done() -> None:
    """Here in every second frame of those in which the hand is held inside."""
    body = moving((Hand.LEFT, INSIDE))
    held = slice(66, 96)
    posed = PosedBody.of(BODY, body.rotations[held], body.hips_m[held])
    every_second = (np.arange(30) % 2.0)[:, None]
    rotations, left_m = cleared(BODY, posed, ClearingMode(SWELL, 0.01), every_second)
    assert left_m == pytest.approx(depths_m(BODY, posed.rotations, body.hips_m[held]).max())
    assert rotations is posed.rotations


@pytest.mark.parametrize("side", ["left", "right"])
def test_only_the_arm_that_is_to_go_aside_does(side: str) -> None:
    body = moving((Hand.LEFT, MIDDLE), (Hand.RIGHT, MIDDLE))
    posed, everywhere = PosedBody.of(BODY, body.rotations, body.hips_m), np.ones((len(body.times_s), 1))
    aside = Aside(side, (0.0, 0.18, 0.0))
    rotations, left_m = cleared(BODY, posed, ClearingMode(SWELL, 0.3, aside=aside, rounds=1), everywhere)
    assert left_m <= 0
    moved = {name for number, name in enumerate(BODY.names) if (rotations != posed.rotations)[:, number].any()}
    assert moved == {side + joint for joint in ("UpperArm", "LowerArm", "Hand")}
