"""The courses of head movements, before anything carries them."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.movements import behavior
from understudy.model import Channel
from understudy.realizer.head_and_gaze.head_movements import (
    FASTEST_WAVE_RAD_S,
    MOVEMENTS,
    MovementTimes,
    course_of,
    cycle_count,
    limited_speed,
    movement_angles,
    realized_heads,
)

DURING_S = np.linspace(1.0, 2.0, 1001)


@pytest.mark.parametrize(("asked", "end_s", "goes"), [(None, 2.0, 1), (3, 2.0, 3), (9, 2.0, 5), (2, 1.1, 1)])
def test_a_nod_goes_as_often_as_asked_and_there_is_time_for(asked: int | None, end_s: float, goes: int) -> None:
    assert cycle_count(behavior(Channel.HEAD, "NOD", 1.0, end_s, repetitions=asked)) == goes


@pytest.mark.parametrize("stroke_s", [1.2, 1.35, 1.5, 1.7])
@pytest.mark.parametrize("lexeme", ["NOD", "SHAKE", "SWAY", "TOSS"])
def test_waves_have_an_extreme_at_the_stroke_wherever_it_is(lexeme: str, stroke_s: float) -> None:
    wave = behavior(Channel.HEAD, lexeme, 1.0, 1.1, 1.1, stroke_s, 1.8, 1.8, 2.0, amount=1.0, repetitions=2)
    both = movement_angles(DURING_S, wave, ahead=0.5) + movement_angles(DURING_S, wave, ahead=-0.5)
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
    course = movement_angles(DURING_S, behavior(Channel.HEAD, lexeme, 1.0, 2.0, amount=1.0), ahead=0.0)
    assert np.abs(course[[0, -1]]).max() < 1e-6
    assert np.abs(np.diff(course, axis=0))[[0, -1]].max() < 1e-4


def test_what_is_too_fast_keeps_its_shape_and_gets_smaller() -> None:
    course = np.sin(np.linspace(0, np.pi, 31))[:, None] * [1.0, 0.0, 0.0]
    slower = limited_speed(course, 1 / 60)
    assert np.abs(np.diff(slower, axis=0)).max() * 60 == pytest.approx(FASTEST_WAVE_RAD_S, rel=0.01)
    assert np.allclose(slower / slower.max(), course / course.max())
    assert np.array_equal(limited_speed(course / 10, 1 / 60), course / 10)
