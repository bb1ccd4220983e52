"""A body with mass makes the motion that it is asked for, and stays on its feet."""

import sys
from dataclasses import replace

import numpy as np
import pytest

from understudy.errors import ServiceError
from understudy.model import FloatArray
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import SIDES, Skeleton, forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.physics.tracking import require_physics, with_physics

from .bodies import RATE_HZ, still_body, striking_body

SKELETON = Skeleton.standing()
ARRIVED = round(0.75 * RATE_HZ)


@pytest.fixture(scope="module")
def struck() -> BodyMotion:
    return with_physics(SKELETON, striking_body(SKELETON))[0]


def places_m(body: BodyMotion, *joints: str) -> FloatArray:
    return forward(SKELETON, body.rotations, body.hips_m)[0][:, SKELETON.chain(*joints)]


def bend_degrees(body: BodyMotion) -> FloatArray:
    joint = SKELETON.index["leftLowerArm"]
    return np.degrees(angle_between(body.rotations[:, joint], body.rotations[:1, joint]))


def test_a_forearm_goes_beyond_where_it_stops_and_comes_back(struck: BodyMotion) -> None:
    asked = bend_degrees(striking_body(SKELETON))
    assert asked.max() == pytest.approx(80)
    assert 82 < bend_degrees(struck)[ARRIVED - 3 :].max() < 110
    assert bend_degrees(struck)[-1] == pytest.approx(80, abs=3)


def test_a_hand_swings_on_at_the_wrist(struck: BodyMotion) -> None:
    hand = SKELETON.index["leftHand"]
    swing = np.degrees(angle_between(struck.rotations[:, hand], striking_body(SKELETON).rotations[:, hand]))
    assert swing[:ARRIVED].max() > 3
    assert swing[-1] < 2


def test_feet_stay_to_the_micrometre(struck: BodyMotion) -> None:
    feet = [side + part for side in SIDES for part in ("Foot", "Toes")]
    asked_m = places_m(striking_body(SKELETON), *feet)
    np.testing.assert_allclose(places_m(struck, *feet), asked_m, atol=1e-6)


def test_motion_is_as_long_and_the_same_every_time(struck: BodyMotion) -> None:
    again, told = with_physics(SKELETON, striking_body(SKELETON))
    assert told == ()
    np.testing.assert_array_equal(again.times_s, striking_body(SKELETON).times_s)
    np.testing.assert_array_equal(again.rotations, struck.rotations)
    np.testing.assert_array_equal(again.hips_m, struck.hips_m)


def test_eyes_look_where_they_looked(struck: BodyMotion) -> None:
    asked = striking_body(SKELETON)
    eyes = SKELETON.chain("leftEye", "rightEye")
    turned = [forward(SKELETON, each.rotations, each.hips_m)[1][:, eyes] for each in (asked, struck)]
    assert angle_between(*turned).max() < 1e-6
    assert np.degrees(angle_between(struck.rotations[:, eyes], asked.rotations[:, eyes])).max() > 0.05


def test_a_body_that_would_fall_moves_without_physics() -> None:
    floating = still_body(SKELETON)
    floating = replace(floating, hips_m=floating.hips_m + np.array([0, 0.5, 0]))
    body, (told,) = with_physics(SKELETON, floating)
    assert body is floating
    assert (told.action, "would fall at" in told.reason) == ("replaced", True)


def test_without_mujoco_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    with pytest.raises(ServiceError, match=r"pip install .*\[physics\]"):
        require_physics()
