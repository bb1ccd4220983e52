"""The clock of arms and trunk."""

import numpy as np
import pytest

from understudy.realizer.dynamics.take_ends import eased_at_the_ends

RATE_HZ = 60


def test_the_clock_of_the_arms_stands_at_the_ends_and_is_right_between() -> None:
    times_s = np.arange(0.0, 4.0, 1 / RATE_HZ)
    eased_s = eased_at_the_ends(times_s, 0.25)
    inner = (times_s > 0.26) & (times_s < times_s[-1] - 0.26)
    assert np.allclose(eased_s[inner], times_s[inner])
    assert eased_s[[0, -1]] == pytest.approx(times_s[[0, -1]])
    steps = np.diff(eased_s) * RATE_HZ
    assert steps[[0, -1]].max() < 0.2
    assert 0 <= steps.min() <= steps.max() < 1.65
