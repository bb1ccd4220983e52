"""Eyes that fixate jump a little about once a second, drift between, and stay near."""

import numpy as np
import pytest

from understudy.realizer.head_and_gaze.gaze import MEAN_S, fixation_offsets, saccade_s

TIMES_S = np.arange(0, 120 * 60) / 60


def test_a_saccade_of_ten_degrees_takes_43_ms() -> None:
    assert saccade_s(np.radians(10.0)) == pytest.approx(0.043)


def test_the_eyes_stay_near_and_are_never_still() -> None:
    aside = np.degrees(fixation_offsets(TIMES_S, seed=3))
    assert np.linalg.norm(aside, axis=1).max() < 2
    assert np.abs(np.diff(aside, axis=0)).max(axis=1).min() > 0


def test_they_jump_about_as_often_as_people_look_elsewhere_in_a_face() -> None:
    speed = np.linalg.norm(np.diff(np.degrees(fixation_offsets(TIMES_S, seed=3)), axis=0), axis=1) * 60
    jumps = np.count_nonzero(np.diff((speed > 10).astype(int)) == 1)
    assert 120 / jumps == pytest.approx(MEAN_S, rel=0.25)


def test_the_same_seed_gives_the_same_whatever_follows() -> None:
    assert np.allclose(fixation_offsets(TIMES_S, seed=1)[:600], fixation_offsets(TIMES_S[:600], seed=1), atol=1e-9)
    assert not np.allclose(fixation_offsets(TIMES_S, seed=1), fixation_offsets(TIMES_S, seed=2), atol=1e-3)
