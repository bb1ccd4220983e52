"""Legs carry the hips wherever they go, and the feet stay where they stand."""

import numpy as np
import pytest

from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import IDENTITY, from_pitch_yaw_roll, to_rotation_vector
from understudy.realizer.torso.balance import hips_height_m, set_legs, standing

BODY = Skeleton.standing()
COUNT = 200


def test_feet_stay_flat_and_in_place_under_hips_that_move_and_turn() -> None:
    generator = np.random.default_rng(1)
    rotations = np.tile(IDENTITY, (COUNT, len(BODY.names), 1))
    rotations[:, 0] = from_pitch_yaw_roll(*generator.uniform(-0.1, 0.1, (3, COUNT)))
    hips_m = np.zeros((COUNT, 3))
    hips_m[:, [0, 2]] = generator.uniform(-0.06, 0.06, (COUNT, 2))
    hips_m[:, 1] = hips_height_m(BODY, hips_m, rotations[:, 0])
    set_legs(BODY, rotations, hips_m)
    places_m, turned = forward(BODY, rotations, hips_m)
    for side, foot in zip(("left", "right"), standing(BODY), strict=True):
        sole = BODY.index[f"{side}Foot"]
        assert np.allclose(places_m[:, sole], foot.ankle_m, atol=1e-9)
        assert np.allclose(to_rotation_vector(turned[:, sole]), [0, foot.yaw, 0], atol=1e-9)
        knee = places_m[:, BODY.index[f"{side}LowerLeg"]]
        assert np.all(knee[:, 2] > places_m[:, sole, 2])


@pytest.mark.parametrize(("across_m", "bearing"), [(0.05, "left"), (-0.05, "right")])
def test_the_leg_under_the_hips_is_the_straighter_one_and_never_locked(across_m: float, bearing: str) -> None:
    hips_m = np.array([[across_m, 0.0, 0.0]])
    rotations = np.tile(IDENTITY, (1, len(BODY.names), 1))
    rotations[:, 0] = from_pitch_yaw_roll(*np.radians([[0.0], [0.0], [np.sign(across_m) * 4.0]]))
    hips_m[:, 1] = hips_height_m(BODY, hips_m, rotations[:, 0])
    set_legs(BODY, rotations, hips_m)
    bent = {
        side: np.degrees(to_rotation_vector(rotations[0, BODY.index[f"{side}LowerLeg"]])[0])
        for side in ("left", "right")
    }
    other = "left" if bearing == "right" else "right"
    assert 3 < bent[bearing] < bent[other] < 60
