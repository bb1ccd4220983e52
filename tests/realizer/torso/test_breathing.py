"""Breath comes 15 times a minute at rest, and in the pauses of speech."""

import numpy as np
import pytest

from understudy.model import Interval
from understudy.realizer.torso.idle import lung_volume

TIMES_S = np.arange(0, 120 * 30) / 30


@pytest.mark.parametrize(("cycle_s", "expected"), [(4.0, 30), (3.0, 40)])
def test_who_is_silent_breathes_as_often_as_asked(cycle_s: float, expected: int) -> None:
    volume = lung_volume(TIMES_S, (), np.random.default_rng(1), cycle_s=cycle_s)
    breaths = np.sum((volume[1:-1] > volume[:-2]) & (volume[1:-1] >= volume[2:]))
    assert breaths == pytest.approx(expected, rel=0.1)
    assert volume.min() >= 0
    assert volume.max() < 0.7


def test_who_speaks_breathes_in_deeper_in_the_pauses_and_only_there() -> None:
    phrases = tuple(Interval(start_s, start_s + 2.5) for start_s in (1.0, 4.0, 7.0))
    volume = lung_volume(TIMES_S, phrases, np.random.default_rng(1))
    rises = np.diff(volume) > 1e-4
    speaking = np.any([(TIMES_S[:-1] >= p.start_s) & (TIMES_S[1:] <= p.end_s) for p in phrases], axis=0)
    between = (TIMES_S[:-1] >= 3.5) & (TIMES_S[1:] <= 4.0)
    assert not np.any(rises & speaking)
    assert np.any(rises & between)
    assert volume[(TIMES_S > 1) & (TIMES_S < 9.5)].max() > 0.8


def test_no_breath_is_a_jerk_however_the_pauses_fall() -> None:
    for seed in range(20):
        generator = np.random.default_rng(seed)
        ends_s = np.cumsum(generator.uniform(0.3, 3.0, 40))
        phrases = [Interval(float(end_s - 0.25), float(end_s)) for end_s in ends_s]
        assert np.abs(np.diff(lung_volume(TIMES_S, phrases, generator))).max() * 30 < 1.875 / 0.35
