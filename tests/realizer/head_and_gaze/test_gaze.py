"""Eyes look at points, and the points that eyes look at are found again."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.movements import BODY, TIMES_S, behavior, faced, schedule, seen_by
from understudy.model import Behavior, Channel, FloatArray, Schedule
from understudy.realizer.body.limits import violations
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import (
    IDENTITY,
    angle_between,
    from_pitch_yaw_roll,
    pitch_and_yaw,
    rotate,
    shortest_rotation,
    to_pitch_yaw_roll,
)
from understudy.realizer.gestures.gesture_plan import Position
from understudy.realizer.head_and_gaze.gaze import (
    EYES,
    SIDEWAYS_LIMIT,
    UPRIGHT_LIMIT,
    Face,
    apply_gaze,
    chest,
    eye_rotations,
    face,
    fixation_point_m,
    looking,
)
from understudy.realizer.head_and_gaze.gaze_targets import LISTENER_M
from understudy.realizer.torso.idle import idle_motion

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


TWO_DEGREES = np.radians(2.0)


def look(lexeme: str, *times_s: float, **changes: object) -> Behavior:
    return behavior(Channel.GAZE, lexeme, *times_s, **{"target": "listener", **changes})


def gazing(planned: Schedule, targets_m: dict[str, Position] | None = None) -> BodyMotion:
    return apply_gaze(BODY, idle_motion(BODY, TIMES_S, planned, seed=2), planned, targets_m=targets_m or {})[0]


def missed(body: BodyMotion, at_m: Position = LISTENER_M) -> FloatArray:
    """The greater angle (T,) of both eyes' lines of sight with the way to the point."""
    places_m, turned = forward(BODY, body.rotations, body.hips_m)
    eyes = BODY.chain(*EYES)
    lines, ways = rotate(turned[:, eyes], np.array([0.0, 0.0, 1.0])), np.array(at_m) - places_m[:, eyes]
    return np.asarray(angle_between(shortest_rotation(lines, ways), IDENTITY).max(axis=1))


def head_yaw(body: BodyMotion) -> FloatArray:
    return np.degrees(to_pitch_yaw_roll(faced(body).orientation)[1])


def sight_yaw(body: BodyMotion) -> FloatArray:
    """Where the line of sight goes, from between the eyes."""
    return np.degrees(pitch_and_yaw(seen_by(body) - faced(body).eyes_m.mean(axis=1))[1])


def test_both_eyes_are_on_the_listener_while_nothing_is_asked_for_and_while_the_body_leans() -> None:
    lean = behavior(Channel.POSTURE, "LEAN_FORWARD", 2.0, 2.6)
    assert missed(gazing(schedule(lean))).max() < TWO_DEGREES


@pytest.mark.parametrize(("direction", "sign"), [("LEFT", 1), ("RIGHT", -1)])
def test_a_look_takes_eyes_and_head_aside_and_back(direction: str, sign: int) -> None:
    body = gazing(schedule(look("LOOK", 1.0, 1.25, 3.0, 3.25, direction=direction, amount=0.5)))
    there, before, after = TIMES_S == 2.0, TIMES_S < 1.0, TIMES_S > 4.0
    assert sign * sight_yaw(body)[there] == pytest.approx(30, abs=3)
    assert sign * head_yaw(body)[there] == pytest.approx(21, abs=2)
    assert missed(body)[before | after].max() < TWO_DEGREES


def test_eyes_lead_and_the_head_is_slower() -> None:
    body = gazing(schedule(look("LOOK", 1.0, 1.25, 5.0, 5.25, direction="LEFT", amount=0.5)))
    eyes, head = sight_yaw(body), head_yaw(body)
    half_way = [TIMES_S[np.argmax(course > course[TIMES_S == 2.0] / 2)] for course in (eyes, head)]
    assert half_way[0] < 1.1 < half_way[1] < 1.4
    assert np.diff(head).max() < np.diff(eyes).max() / 3


def test_a_saccade_takes_the_time_of_the_main_sequence() -> None:
    body = gazing(schedule(look("GLANCE", 1.0, 1.06, 2.0, 2.06, direction="RIGHT", amount=1 / 3)))
    eyes = sight_yaw(body)
    moving = TIMES_S[1:][(np.abs(np.diff(eyes)) > 1.5) & (TIMES_S[1:] < 1.5)]
    assert moving[-1] - moving[0] == pytest.approx(0.021 + 20 * 0.0022, abs=2 / 60)
    assert np.abs(np.diff(eyes)).max() * 60 < 600


def test_a_glance_is_the_eyes_alone_and_is_added_to_a_look() -> None:
    aside = look("LOOK", 1.0, 1.25, 5.0, 5.25, direction="LEFT", amount=0.5)
    glance = look("GLANCE", 2.0, 2.06, 3.0, 3.06, direction="UP", amount=0.1)
    alone, both = gazing(schedule(aside)), gazing(schedule(aside, glance))
    there = TIMES_S == 2.5
    neck = BODY.chain("neck", "head")
    assert angle_between(both.rotations[there][:, neck], alone.rotations[there][:, neck]).max() < np.radians(0.5)
    eye = BODY.index["leftEye"]
    difference = angle_between(both.rotations[there, eye], alone.rotations[there, eye])
    assert np.degrees(difference) == pytest.approx(6, abs=0.5)


def test_a_glance_without_direction_looks_at_its_target_out_of_a_look_aside() -> None:
    aside = look("LOOK", 1.0, 1.25, 5.0, 5.25, direction="LEFT", amount=0.5)
    body = gazing(schedule(aside, look("GLANCE", 2.5, 2.56, 3.5, 3.56)))
    assert missed(body)[TIMES_S == 3.0] < TWO_DEGREES
    assert head_yaw(body)[TIMES_S == 3.0] > 15
    assert missed(body)[TIMES_S == 4.0] > np.radians(20)


def test_a_shift_stays_and_a_look_returns_to_it() -> None:
    door: Position = (1.0, 1.3, 1.0)
    shift, aside = look("SHIFT", 0.5, 0.8, target="door"), look("LOOK", 2.0, 2.25, 3.0, 3.25)
    body = gazing(schedule(shift, aside), {"door": door})
    assert missed(body)[TIMES_S == 2.75] < TWO_DEGREES
    assert missed(body, door)[(TIMES_S > 1.5) & (TIMES_S < 2) | (TIMES_S > 4)].max() < TWO_DEGREES
    assert head_yaw(body)[-1] > 35


def test_nothing_turns_farther_than_it_can_nor_too_fast() -> None:
    asides = [
        look("LOOK", start_s, start_s + 0.1, start_s + 0.3, start_s + 0.4, direction=direction, amount=1.0)
        for start_s, direction in zip((0.5, 1.0, 1.5, 2.0), ("LEFT", "RIGHT", "UP", "DOWN"), strict=True)
    ]
    behind: Position = (0.4, 1.6, -1.0)
    body = gazing(schedule(*asides, look("SHIFT", 3.0, 3.1, target="behind")), {"behind": behind})
    pitch, yaw, roll = to_pitch_yaw_roll(body.rotations[:, BODY.chain(*EYES)])
    assert np.abs(pitch).max() <= UPRIGHT_LIMIT + 1e-9
    assert np.abs(yaw).max() <= SIDEWAYS_LIMIT + 1e-9
    assert np.abs(roll).max() < 1e-9
    assert violations(BODY, body.rotations).max() == 0
    assert angle_between(body.rotations[1:], body.rotations[:-1]).max() * 60 < 20


def test_the_gaze_takes_the_place_of_what_the_head_did_before_and_leaves_the_body() -> None:
    calm = idle_motion(BODY, TIMES_S, schedule(), seed=2)
    rotations = calm.rotations.copy()
    rotations[:, BODY.chain("neck", "head")] = rotations[:, BODY.index["leftUpperArm"], None]
    shaken = BodyMotion(TIMES_S, rotations, calm.hips_m)
    assert np.allclose(
        apply_gaze(BODY, shaken.copy(), schedule())[0].rotations, apply_gaze(BODY, calm.copy(), schedule())[0].rotations
    )
    others = [joint for joint in range(len(BODY.names)) if joint not in BODY.chain("neck", "head", *EYES)]
    assert np.allclose(
        apply_gaze(BODY, calm.copy(), schedule())[0].rotations[:, others], calm.rotations[:, others], atol=1e-9
    )


def test_a_line_that_opens_with_a_turn_begins_beside_the_listener_and_looks_at_him() -> None:
    body = gazing(schedule(look("SHIFT", 0.0, 0.1)))
    assert missed(body)[0] > np.radians(6)
    assert missed(body)[(TIMES_S > 0.3)].max() < TWO_DEGREES
    assert abs(head_yaw(body)[0] - head_yaw(body)[-1]) > 4
    still = gazing(replace(schedule(look("SHIFT", 0.0, 0.1)), stillness=1.0))
    assert missed(still).max() < TWO_DEGREES


@pytest.mark.parametrize("first", [look("LOOK", 0.0, 0.1, 0.4, 0.5), look("SHIFT", 2.0, 2.1)], ids=["a look", "later"])
def test_any_other_line_begins_with_the_listener(first: Behavior) -> None:
    assert missed(gazing(schedule(first))).max() < TWO_DEGREES


def test_neck_head_and_chest_have_their_shares_of_a_look() -> None:
    body = gazing(schedule(look("LOOK", 1.0, 1.25, 5.0, 5.25, direction="LEFT", amount=0.6)))
    there, before = (np.searchsorted(TIMES_S, at_s) for at_s in (3.0, 0.9))
    yaws = {
        name: float(np.degrees(to_pitch_yaw_roll(body.rotations[[before, there], BODY.index[name]])[1][1]))
        for name in ("chest", "neck", "head")
    }
    assert 1 < yaws["chest"] < yaws["neck"] < yaws["head"]
    assert head_yaw(body)[there] > 20
