"""Eyes look at points, and the points that eyes look at are found again."""

import numpy as np
import pytest

from tests.support.motion.movements import BODY
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.angles import from_pitch_yaw_roll
from understudy.realizer.geometry.rotations import IDENTITY
from understudy.realizer.head_and_gaze.gaze_geometry import (
    SIDEWAYS_LIMIT,
    UPRIGHT_LIMIT,
    Face,
    chest,
    eye_rotations,
    face,
    fixation_point_m,
    looking,
)

COUNT = 100
GENERATOR = np.random.default_rng(8)
TURNED = from_pitch_yaw_roll(*GENERATOR.uniform(-0.2, 0.2, (3, COUNT)))
EYES_M = np.array([[0.032, 1.6, 0.08], [-0.032, 1.6, 0.08]]) + GENERATOR.normal(0, 0.01, (COUNT, 1, 3))
FACE = Face(np.tile(IDENTITY, (COUNT, 1)), EYES_M)


@pytest.mark.parametrize("distance_m", [0.4, 1.2, 5.0])
def test_the_point_that_both_eyes_look_at_is_found_again(distance_m: float) -> None:
    sideways = GENERATOR.uniform(-0.3, 0.3, (COUNT, 2)) * distance_m
    at_m = np.column_stack([sideways[:, 0], 1.6 + sideways[:, 1], np.full(COUNT, distance_m)])
    assert np.allclose(fixation_point_m(FACE, eye_rotations(FACE, at_m)), at_m, atol=1e-6)


def test_eyes_go_no_farther_than_their_limits() -> None:
    at_m = np.tile([[5.0, 5.0, 0.5]], (COUNT, 1))
    assert np.allclose(
        eye_rotations(FACE, at_m),
        from_pitch_yaw_roll(*(np.full((COUNT, 2), x) for x in (-UPRIGHT_LIMIT, SIDEWAYS_LIMIT, 0))),
    )


def test_it_is_known_where_eyes_look_even_if_they_do_not_reach_their_target() -> None:
    """Straight ahead, beyond the limits of both angles and of one, behind, and so far that the eyes are parallel."""
    towards = [[0.1, 1.5, 1.2], [5.0, 5.0, 0.5], [0.5, 0.4, 0.5], [0.2, 1.6, -1.0], [3.0, 1.0, 40.0]]
    at_m = np.repeat(towards, COUNT // len(towards), axis=0)
    eyes, seen_m = looking(FACE, at_m)
    assert np.array_equal(eyes, eye_rotations(FACE, at_m))
    assert np.allclose(seen_m, fixation_point_m(FACE, eyes), atol=1e-6)
    assert np.array_equal(seen_m[:20], at_m[:20])


def test_eyes_that_look_straight_ahead_see_something_far_away() -> None:
    straight = np.tile(IDENTITY, (COUNT, 2, 1))
    assert np.all(fixation_point_m(FACE, straight)[:, 2] > 10)


def test_chest_and_face_are_where_the_whole_body_has_them() -> None:
    rotations = np.tile(IDENTITY, (COUNT, len(BODY.names), 1))
    rotations[:, : BODY.index["head"] + 1] = from_pitch_yaw_roll(
        *GENERATOR.uniform(-0.3, 0.3, (3, COUNT, BODY.index["head"] + 1))
    )
    hips_m = GENERATOR.normal(size=(COUNT, 3))
    places_m, turned = forward(BODY, rotations, hips_m)
    carrying = chest(BODY, rotations, hips_m)
    neck, head = (rotations[:, joint] for joint in BODY.chain("neck", "head"))
    found = face(BODY, carrying, neck, head)
    assert np.allclose(carrying.neck_m, places_m[:, BODY.index["neck"]])
    assert np.allclose(found.orientation, turned[:, BODY.index["head"]])
    assert np.allclose(found.eyes_m, places_m[:, BODY.chain("leftEye", "rightEye")])
