"""Phrases out of streams."""

import numpy as np
import pytest
from sklearn.cross_decomposition import CCA

from understudy.model import FloatArray
from understudy.motion_models.clustering import (
    STATES,
    canonical_correlation,
    cluster_correlation,
    energy_difference,
    fewest_clusters,
    kinetic_energy,
    learn_branches,
    symmetric_divergence,
)
from understudy.prosody_gestures.semi_markov import states_by_frame
from understudy.realizer.geometry.rotations import from_rotation_vector


def waves(seed: int, phrases: int) -> tuple[FloatArray, list[int]]:
    """A stream of rises, falls and bows, some second each, and which each frame is of."""
    generator, parts, kinds = np.random.default_rng(seed), [], list[int]()
    for _ in range(phrases):
        kind, frames = int(generator.integers(3)), int(generator.integers(24, 36))
        along = np.linspace(0, 1, frames)
        shape = (2 * along - 1, 1 - 2 * along, np.sin(np.pi * along) * 2)[kind]
        parts.append(np.stack([shape, np.gradient(shape) * 10], axis=1))
        kinds += [kind] * frames
    stream = np.concatenate(parts)
    return stream + generator.normal(0, 0.1, stream.shape), kinds


def test_recurring_movements_are_found() -> None:
    """Each branch stands for one kind of movement in nearly all of its frames."""
    streams = [waves(seed, 20) for seed in range(6)]
    branches = learn_branches([stream for stream, _ in streams], 6)
    found = np.concatenate([states_by_frame(branches.segment(stream)) for stream, _ in streams])
    truth = np.concatenate([kinds for _, kinds in streams])
    pure = sum(np.bincount(truth[found == branch]).max() for branch in np.unique(found))
    assert pure / len(truth) > 0.85


def test_no_phrase_is_shorter_than_a_branch() -> None:
    stream, _ = waves(9, 20)
    segments = learn_branches([stream], 4).segment(stream)
    assert sum(segment.frames for segment in segments) == len(stream)
    assert all(segment.frames >= STATES for segment in segments[1:-1])


def test_clusters_keep_what_goes_together() -> None:
    """Within each half affect follows the first angle, in opposite directions: one cluster hides it, two do not."""
    generator = np.random.default_rng(0)
    angles, labels = generator.normal(size=(400, 3)), np.repeat([0, 1], 200)
    affect = np.where(labels == 0, angles[:, 0], -angles[:, 0])[:, None]
    whole = cluster_correlation(angles, affect, np.zeros(400, dtype=np.intp))
    halves = cluster_correlation(angles, affect, labels)
    assert halves == pytest.approx([1.0])
    assert whole[0] < 0.3
    assert fewest_clusters({1: whole, 2: halves, 3: halves}, np.array([0.9])) == 2
    assert fewest_clusters({1: whole, 2: halves / 2}, np.array([0.9])) == 2


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
