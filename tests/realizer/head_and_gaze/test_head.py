"""The courses of head movements, before anything carries them."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.movements import BODY, TIMES_S, behavior, faced, schedule, seen_by
from understudy.model import Behavior, Channel, FloatArray, Schedule
from understudy.realizer.body.limits import violations
from understudy.realizer.geometry.rotations import angle_between, to_pitch_yaw_roll
from understudy.realizer.head_and_gaze.gaze import EYES, apply_gaze
from understudy.realizer.head_and_gaze.head import (
    FASTEST_EYE_RAD_S,
    FASTEST_WAVE_RAD_S,
    MOVEMENTS,
    MovementTimes,
    apply_head_movements,
    course_of,
    cycle_count,
    limited_speed,
    movement_angles,
    realized_heads,
)
from understudy.realizer.torso.idle import idle_motion

DURING_S = np.linspace(1.0, 2.0, 1001)


@pytest.mark.parametrize(("asked", "end_s", "goes"), [(None, 2.0, 1), (3, 2.0, 3), (9, 2.0, 5), (2, 1.1, 1)])
def test_a_nod_goes_as_often_as_asked_and_there_is_time_for(asked: int | None, end_s: float, goes: int) -> None:
    assert cycle_count(behavior(Channel.HEAD, "NOD", 1.0, end_s, repetitions=asked)) == goes


@pytest.mark.parametrize("stroke_s", [1.2, 1.35, 1.5, 1.7])
@pytest.mark.parametrize("lexeme", ["NOD", "SHAKE", "SWAY", "TOSS"])
def test_waves_have_an_extreme_at_the_stroke_wherever_it_is(lexeme: str, stroke_s: float) -> None:
    wave = behavior(Channel.HEAD, lexeme, 1.0, 1.1, 1.1, stroke_s, 1.8, 1.8, 2.0, amount=1.0, repetitions=2)
    both = movement_angles(DURING_S, wave, ahead=np.array([0.5, -0.5])).sum(axis=1)
    axis = int(np.argmax(np.ptp(both, axis=0)))
    size = np.abs(both[:, axis])
    near = np.abs(DURING_S - stroke_s) < 0.04
    assert abs(DURING_S[near][np.argmax(size[near])] - stroke_s) < 0.005


def test_a_movement_without_the_time_for_it_begins_earlier_or_ends_later() -> None:
    usual = behavior(Channel.HEAD, "TILT_LEFT", 1.0, 1.2, 1.2, 1.4, 1.6, 2.4, 2.8)
    assert course_of(usual) == MovementTimes(1.0, 1.4, 2.4, 2.8)
    cut = course_of(behavior(Channel.HEAD, "TILT_LEFT", 1.0, 1.0, 1.0, 1.0, 1.0, 2.4, 2.4))
    assert (cut.stroke_s, cut.relax_s) == (1.0, 2.4)
    assert cut.start_s == pytest.approx(0.74)
    assert cut.end_s == pytest.approx(2.66)


def test_what_is_told_of_a_movement_is_when_it_was_made() -> None:
    cut = behavior(Channel.HEAD, "TILT_LEFT", 1.0, 1.0, 1.0, 1.4, 1.6, 2.4, 2.4)
    unknown, lost = replace(cut, lexeme="WAG", id="unknown"), replace(cut, kept=False, id="lost")
    assert realized_heads([cut, unknown, lost]) == {cut.id: replace(cut.sync, end=course_of(cut).end_s)}


@pytest.mark.parametrize("lexeme", sorted(MOVEMENTS))
def test_every_movement_starts_and_ends_at_rest(lexeme: str) -> None:
    course = movement_angles(DURING_S, behavior(Channel.HEAD, lexeme, 1.0, 2.0, amount=1.0), ahead=np.zeros(1))
    assert np.abs(course[[0, -1]]).max() < 1e-6
    assert np.abs(np.diff(course, axis=0))[[0, -1]].max() < 1e-4


def test_what_is_too_fast_keeps_its_shape_and_gets_smaller() -> None:
    course = np.sin(np.linspace(0, np.pi, 31))[:, None, None] * [1.0, 0.0, 0.0]
    slower = limited_speed(course, 1 / 60)
    assert np.abs(np.diff(slower, axis=0)).max() * 60 == pytest.approx(FASTEST_WAVE_RAD_S, rel=0.01)
    assert np.allclose(slower / slower.max(), course / course.max())
    assert np.array_equal(limited_speed(course / 10, 1 / 60), course / 10)


FRAME_S = 1 / 60
CALM = apply_gaze(BODY, idle_motion(BODY, TIMES_S, schedule(), seed=2), schedule())[0]


def movement(lexeme: str, *times_s: float, **changes: object) -> Behavior:
    return behavior(Channel.HEAD, lexeme, *times_s, **changes)


def added(*behaviors: Behavior) -> FloatArray:
    """Degrees of pitch, yaw and roll (T, 3) that the movements add to the head's in the world, and take from what it
    does by itself."""
    with_them, without = (
        apply_head_movements(BODY, CALM.copy(), schedule(*these), seed=3) for these in (behaviors, ())
    )
    courses = [np.array(to_pitch_yaw_roll(faced(body).orientation)) for body in (with_them, without)]
    return np.degrees(courses[0] - courses[1]).T


NOD = movement("NOD", 1.0, 1.15, 1.15, 1.35, 1.45, 1.45, 1.65, amount=0.9, repetitions=1)


def test_a_nod_goes_down_first_is_lowest_at_its_stroke_and_comes_back() -> None:
    pitch = added(NOD)[:, 0]
    assert pitch.max() == pytest.approx(18, abs=0.8)
    assert abs(TIMES_S[np.argmax(pitch)] - 1.35) <= FRAME_S
    assert pitch.min() > -0.3
    assert np.abs(pitch[(TIMES_S <= 1.0) | (TIMES_S >= 1.65)]).max() < 1e-9


def test_nods_repeat_and_get_smaller() -> None:
    pitch = added(movement("NOD", 1.0, 1.1, 1.1, 1.4, 1.9, 1.9, 2.4, amount=0.6, repetitions=3))[:, 0]
    peaks = 1 + np.flatnonzero((pitch[1:-1] > pitch[:-2]) & (pitch[1:-1] >= pitch[2:]) & (pitch[1:-1] > 1))
    assert len(peaks) == 3
    assert abs(TIMES_S[peaks] - 1.4).min() <= FRAME_S
    assert np.all(np.diff(pitch[peaks]) < -1)


def test_a_shake_goes_to_both_sides_as_often_as_asked_with_an_extreme_at_the_stroke() -> None:
    yaw = added(movement("SHAKE", 1.0, 1.15, 1.15, 1.56, 1.8, 1.8, 2.1, amount=0.7, repetitions=2))[:, 1]
    signs = np.sign(yaw[np.abs(yaw) > 3])
    assert np.count_nonzero(np.diff(signs)) == 3
    near = np.abs(TIMES_S - 1.56) <= 0.1
    assert abs(TIMES_S[near][np.argmax(np.abs(yaw[near]))] - 1.56) <= FRAME_S
    assert np.ptp(yaw) == pytest.approx(2 * 15.4, abs=6)


@pytest.mark.parametrize("lexeme", sorted(MOVEMENTS))
def test_every_movement_starts_and_ends_at_nothing_without_a_jump(lexeme: str) -> None:
    course = added(movement(lexeme, 1.0, 1.2, 1.2, 1.5, 1.7, 2.5, 2.8, amount=1.0, repetitions=2))
    assert np.abs(course[(TIMES_S <= 1.0) | (TIMES_S >= 2.8)]).max() < 1e-9
    assert np.abs(course).max() > 10
    assert np.abs(np.diff(course, axis=0)).max() < np.degrees(20 / 60) / 2


@pytest.mark.parametrize(
    "hurried",
    [
        movement("NOD", 1.0, 1.01, amount=1.0),
        movement("SHAKE", 1.0, 1.3, amount=1.0, repetitions=40),
        movement("TILT_LEFT", 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, amount=1.0),
    ],
    ids=["a nod of no time", "many shakes in little time", "a tilt of no time at all"],
)
def test_what_is_asked_for_too_fast_is_smaller(hurried: Behavior) -> None:
    body = apply_head_movements(BODY, CALM.copy(), schedule(hurried), seed=3)
    neck = BODY.chain("neck", "head")
    assert angle_between(body.rotations[1:, neck], body.rotations[:-1, neck]).max() * 60 < 4


@pytest.mark.parametrize(
    ("lexeme", "axis", "sign"),
    [("TILT_LEFT", 2, -1), ("TILT_RIGHT", 2, 1), ("TURN_LEFT", 1, 1), ("TURN_RIGHT", 1, -1), ("RAISE", 0, -1)],
)
def test_tilts_turns_and_raising_are_reached_at_the_stroke_and_held(lexeme: str, axis: int, sign: int) -> None:
    course = sign * added(movement(lexeme, 1.0, 1.2, 1.2, 1.5, 1.7, 2.5, 2.8, amount=0.5))[:, axis]
    held = course[(TIMES_S >= 1.5) & (TIMES_S <= 2.5)]
    assert np.all(held > 8)
    assert np.ptp(held) < 0.5


def test_a_nod_and_a_look_aside_are_both_seen() -> None:
    aside = behavior(Channel.GAZE, "LOOK", 0.5, 0.75, 3.0, 3.25, direction="LEFT", amount=0.5)
    nod = replace(NOD, sync=NOD.sync.shifted(0.5))
    planned = schedule(aside, nod)
    turned = apply_head_movements(BODY, apply_gaze(BODY, CALM.copy(), planned)[0], planned, seed=3)
    pitch, yaw, _roll = np.degrees(to_pitch_yaw_roll(faced(turned).orientation))
    at_stroke = np.searchsorted(TIMES_S, 1.85)
    assert pitch[at_stroke] > 15
    assert yaw[at_stroke] > 15


def test_the_neck_keeps_its_limits_however_much_is_added_up() -> None:
    aside = behavior(Channel.GAZE, "LOOK", 0.2, 0.5, 3.0, 3.3, direction="DOWN", amount=1.0)
    planned = schedule(aside, NOD, movement("LOWER", 1.0, 1.2, 1.2, 1.5, 1.7, 2.5, 2.8, amount=1.0))
    body = apply_head_movements(BODY, apply_gaze(BODY, CALM.copy(), planned)[0], planned, seed=3)
    assert violations(BODY, body.rotations).max() == 0
    assert angle_between(body.rotations[1:], body.rotations[:-1]).max() * 60 < 20


def test_the_eyes_stay_on_their_target_while_the_head_nods_and_shakes() -> None:
    shake = movement("SHAKE", 3.0, 3.15, 3.15, 3.5, 3.8, 3.8, 4.1, amount=0.7, repetitions=2)
    moved = apply_head_movements(BODY, CALM.copy(), schedule(NOD, shake), seed=3)
    middle = faced(CALM).eyes_m.mean(axis=1)
    distance_m = np.linalg.norm(seen_by(CALM) - middle, axis=-1)
    assert (np.linalg.norm(seen_by(moved) - seen_by(CALM), axis=-1) / distance_m).max() < np.radians(0.5)


def test_the_neck_is_ahead_of_the_head() -> None:
    moved, still = (
        apply_head_movements(BODY, CALM.copy(), schedule(*these), seed=3).rotations for these in ((NOD,), ())
    )
    lowest = [np.argmax(angle_between(moved[:, joint], still[:, joint])) for joint in BODY.chain("neck", "head")]
    assert lowest[0] < lowest[1]


def test_the_head_is_never_still_and_stress_shows_in_it() -> None:
    plain = apply_head_movements(BODY, CALM.copy(), schedule(), seed=3)
    stressed = apply_head_movements(BODY, CALM.copy(), Schedule((), 6.0, emphases_s=(2.0,)), seed=3)
    joint = BODY.index["head"]
    assert angle_between(plain.rotations[1:, joint], plain.rotations[:-1, joint]).min() > 1e-6
    pitch = [to_pitch_yaw_roll(faced(body).orientation)[0] for body in (plain, stressed)]
    dip = np.degrees(pitch[1] - pitch[0])
    assert abs(TIMES_S[np.argmax(dip)] - 2.0) <= FRAME_S
    assert 2 < dip.max() < 6


def test_what_lost_moves_nothing_and_the_same_seed_moves_alike() -> None:
    one, same = (
        apply_head_movements(BODY, CALM.copy(), schedule(), seed=3),
        apply_head_movements(BODY, CALM.copy(), schedule(replace(NOD, kept=False)), seed=3),
    )
    assert np.array_equal(one.rotations, same.rotations)
    assert not np.array_equal(one.rotations, apply_head_movements(BODY, CALM.copy(), schedule(), seed=4).rotations)


def test_a_movement_moves_neck_and_head_alone_and_what_the_head_does_by_itself_the_trunk_as_well() -> None:
    nodding, idle = (
        apply_head_movements(BODY, CALM.copy(), schedule(*these), seed=3).rotations for these in ((NOD,), ())
    )
    touched, trunk = BODY.chain("neck", "head", "leftEye", "rightEye"), BODY.chain("spine", "chest", "upperChest")
    without = [joint for joint in range(len(BODY.names)) if joint not in touched]
    assert np.array_equal(nodding[:, without], idle[:, without])
    untouched = [joint for joint in without if joint not in trunk]
    assert np.array_equal(idle[:, untouched], CALM.rotations[:, untouched])
    assert 0 < angle_between(idle[:, trunk], CALM.rotations[:, trunk]).max() < np.radians(3)


@pytest.mark.parametrize("lexeme", sorted(MOVEMENTS))
@pytest.mark.parametrize("end_s", [1.5, 2.5])
def test_a_movement_that_is_cut_off_returns_without_a_step(lexeme: str, end_s: float) -> None:
    """`relax` at the `end`, as where another movement begins: the head had jumped 5° in one frame."""
    moved = added(movement(lexeme, 1.0, 1.2, 1.2, 1.5, end_s, end_s, end_s, amount=0.5))
    assert np.linalg.norm(np.diff(moved, axis=0), axis=1).max() * 60 < 160
    assert np.abs(moved[np.searchsorted(TIMES_S, 1.5)]).max() > 5
    assert np.abs(moved[end_s + 0.4 < TIMES_S]).max() < 1e-9


def test_the_head_keeps_its_greatest_speed_whatever_is_asked_for_at_once() -> None:
    lexemes = ("TURN_LEFT", "BOW", "TILT_LEFT", "SHAKE", "NOD", "TURN_RIGHT")
    asked = [
        movement(lexeme, 1.0, 1.0, 1.0, 1.0 + late_s, 1.1, 1.1, 1.1, amount=1.0)
        for late_s in (0.0, 0.1)
        for lexeme in lexemes
    ]
    planned = schedule(*asked, behavior(Channel.GAZE, "LOOK", 1.0, 1.0, 1.2, 1.2, direction="LEFT", amount=1.0))
    body = apply_head_movements(BODY, apply_gaze(BODY, CALM.copy(), planned)[0], planned, seed=3)
    turned = faced(body).orientation
    assert np.degrees(angle_between(turned[1:], turned[:-1]).max() * 60) < 250
    eyes = BODY.chain(*EYES)
    speed = angle_between(body.rotations[1:, eyes], body.rotations[:-1, eyes]).max() * 60
    assert speed <= FASTEST_EYE_RAD_S + 1e-6
