"""The measures."""

import numpy as np
import pytest
from sklearn.cross_decomposition import CCA

from understudy.motion_models.correlation import (
    canonical_correlation,
    energy_difference,
    kinetic_energy,
    symmetric_divergence,
)
from understudy.realizer.geometry.rotations import from_rotation_vector


def test_canonical_correlation_is_scikit_learns() -> None:
    generator = np.random.default_rng(0)
    one = generator.normal(size=(300, 4))
    other = one[:, :2] @ generator.normal(size=(2, 3)) + generator.normal(size=(300, 3))
    left, right = CCA(n_components=1, tol=1e-12, max_iter=5000).fit_transform(one, other)
    assert canonical_correlation(one, other) == pytest.approx(np.corrcoef(left[:, 0], right[:, 0])[0, 1], abs=1e-6)


def test_what_never_changes_correlates_with_nothing() -> None:
    assert canonical_correlation(np.ones((20, 2)), np.random.default_rng(0).normal(size=(20, 3))) == 0.0


def test_sums_of_the_other_correlate_wholly() -> None:
    stream = np.random.default_rng(1).normal(size=(50, 3))
    assert canonical_correlation(stream, stream @ np.array([[1.0], [2.0], [-1.0]])) == pytest.approx(1.0)


def test_divergence_is_symmetric_and_none_of_the_same() -> None:
    one, other = np.array([0.5, 0.25, 0.25]), np.array([0.25, 0.25, 0.5])
    assert symmetric_divergence(one, one) == 0.0
    assert symmetric_divergence(one, other) == symmetric_divergence(other, one)
    assert symmetric_divergence(one, other) == pytest.approx(0.5 * np.log(2), rel=1e-3)


def test_kinetic_energy_of_a_steady_turn() -> None:
    """Two joints that turn by .3 and .4 rad a frame of half a second: (.6² + .8²) rad²/s² all the time."""
    axes = np.zeros((5, 2, 3))
    axes[:, 0, 0], axes[:, 1, 2] = 0.3 * np.arange(5), 0.4 * np.arange(5)
    turning, still = from_rotation_vector(axes), from_rotation_vector(0 * axes)
    assert kinetic_energy(turning, 0.5) == pytest.approx([1.0] * 4)
    assert energy_difference(turning, still, 0.5) == pytest.approx(1.0)
