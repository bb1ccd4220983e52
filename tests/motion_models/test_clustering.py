"""Phrases out of streams."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.motion_models.clustering import STATES, cluster_correlation, fewest_clusters, learn_branches
from understudy.prosody_gestures.semi_markov import states_by_frame


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
