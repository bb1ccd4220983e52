"""Directions in which states differ."""

import numpy as np
import pytest
from sklearn.discriminant_analysis import LinearDiscriminantAnalysis

from understudy.prosody_gestures.discriminants import fit_discriminants


def test_directions_are_scikit_learns() -> None:
    """Up to sign, with next to no ridge beside the spread of the data."""
    generator = np.random.default_rng(0)
    states = generator.integers(0, 3, 600)
    rows = generator.normal(size=(600, 5)) @ generator.normal(size=(5, 5))
    rows[:, :2] += np.array([[0, 0], [3, 1], [0, 4]])[states]
    ours = fit_discriminants(rows, states).project(rows)
    oracle = LinearDiscriminantAnalysis(solver="eigen").fit(rows, states).transform(rows)
    alike = [abs(np.corrcoef(ours[:, place], oracle[:, place])[0, 1]) for place in range(2)]
    assert alike == pytest.approx([1, 1], abs=1e-3)


def test_one_state_has_a_direction_too() -> None:
    assert fit_discriminants(
        np.random.default_rng(0).normal(size=(9, 4)), np.zeros(9, dtype=np.intp)
    ).weights.shape == (4, 1)


def test_a_constant_feature_does_no_harm() -> None:
    rows = np.random.default_rng(0).normal(size=(60, 3))
    rows[:, 1] = 7.0
    assert np.isfinite(fit_discriminants(rows, np.repeat([0, 1], 30)).project(rows)).all()
