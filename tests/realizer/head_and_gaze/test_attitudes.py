"""What heads do by themselves: never still, otherwise with every phrase, forward on stress, and nothing at a stillness
of 1."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.movements import TIMES_S, schedule
from understudy.model import FloatArray, Interval, Schedule, Word
from understudy.realizer.head_and_gaze.attitudes import (
    FORWARD_DEGREES,
    HeadAttitude,
    head_attitude,
    waiting_for_words,
)

PLAIN = schedule()
FORWARD = np.radians(FORWARD_DEGREES)


def angles(attitude: HeadAttitude) -> FloatArray:
    """All angles (T, 13)."""
    return np.column_stack([attitude.trunk, attitude.held, attitude.neck, attitude.head, attitude.forward])


def test_the_same_seed_moves_alike_and_another_otherwise() -> None:
    one, same, other = (angles(head_attitude(TIMES_S, PLAIN, seed=seed)) for seed in (1, 1, 2))
    assert np.array_equal(one, same)
    assert not np.allclose(one, other, atol=0.01)


def test_at_a_stillness_of_one_nothing_moves() -> None:
    still = angles(head_attitude(TIMES_S, Schedule((), 6.0, emphases_s=(2.0,), stillness=1.0), seed=1))
    assert np.array_equal(still[:, :-1], np.zeros_like(still[:, :-1]))
    assert still[:, -1] == pytest.approx(FORWARD)


@pytest.mark.parametrize("seed", range(4))
def test_the_attitude_changes_as_a_phrase_begins_and_nothing_jumps(seed: int) -> None:
    begins_s = 0.6
    phrased = replace(PLAIN, phrases=(Interval(begins_s, 5.0),))
    course = head_attitude(TIMES_S, phrased, seed=seed).trunk
    moving = np.linalg.norm(np.diff(course, axis=0), axis=1) > 1e-9
    assert moving[np.searchsorted(TIMES_S, begins_s + 0.1)]
    assert np.degrees(np.abs(np.diff(angles(head_attitude(TIMES_S, phrased, seed=seed)), axis=0))).max() * 60 < 90


def test_stress_thrusts_the_head_forward_and_down_and_it_comes_back() -> None:
    plain, stressed = (
        angles(head_attitude(TIMES_S, each, seed=1)) for each in (PLAIN, replace(PLAIN, emphases_s=(2.0,)))
    )
    thrust = np.degrees(stressed - plain)
    assert 3 < thrust[:, -1].max() < 7
    assert abs(TIMES_S[np.argmax(thrust[:, -1])] - 2.0) <= 1 / 60
    assert np.abs(thrust[(TIMES_S < 1.8) | (TIMES_S > 2.4)]).max() < 1e-6


def test_a_head_is_somewhere_else_every_few_seconds() -> None:
    course = head_attitude(np.arange(0, 60, 1 / 30), Schedule((), 60.0), seed=3)
    yaw = np.degrees(course.held + course.neck + course.head)[:, 1]
    sweeps = [np.ptp(yaw[first : first + 210]) for first in range(0, len(yaw) - 210, 105)]
    assert 20 < np.median(sweeps) < 40
    assert np.abs(yaw).max() < 20
    assert np.abs(np.degrees(course.trunk)).max() < 5


def test_a_head_turns_to_the_other_side_with_each_attitude_and_slowly() -> None:
    """Power below .95 Hz against above (deg/s)²: people's heads have more of the former."""
    course = head_attitude(np.arange(0, 60, 1 / 30), Schedule((), 60.0), seed=3)
    yaw = np.degrees(course.held + course.neck + course.head)[:, 1]
    power = np.abs(np.fft.rfft(np.diff(yaw) * 30)) ** 2
    slow = np.fft.rfftfreq(len(yaw) - 1, 1 / 30) < 0.95
    assert power[slow].sum() > 2 * power[~slow].sum()


def test_a_head_moves_while_the_voice_is_heard_and_holds_in_the_pauses() -> None:
    phrases = tuple(Interval(start_s, start_s + 2.6) for start_s in np.arange(0.0, 58.0, 3.2))
    words = tuple(Word(number, "word", phrase) for number, phrase in enumerate(phrases))
    times_s = np.arange(0, 58, 1 / 30)
    course = head_attitude(times_s, Schedule((), 58.0, phrases=phrases, words=words), seed=3)
    speed = np.linalg.norm(np.diff(np.degrees(course.held + course.neck + course.head), axis=0), axis=1) * 30
    pausing = (times_s[1:] % 3.2) > 2.65
    assert speed[~pausing].mean() > 2 * speed[pausing].mean()


def test_heads_wait_in_pauses_and_make_up_for_it_with_the_next_words() -> None:
    """A pause from 1 to 2 s; the clock never runs back, and is on time before, and half a second after it."""
    words = [Word(0, "a", Interval(0.2, 1.0)), Word(1, "b", Interval(2.0, 3.0))]
    behind_s = TIMES_S - waiting_for_words(TIMES_S, words)
    assert behind_s[np.searchsorted(TIMES_S, 0.99)] == 0
    assert 0.2 < behind_s.max() == pytest.approx(behind_s[np.searchsorted(TIMES_S, 1.9)])
    assert behind_s[TIMES_S > 2.7].max() == 0
    assert np.diff(TIMES_S - behind_s).min() > 0
