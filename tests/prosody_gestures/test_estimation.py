"""Learning by counting."""

import numpy as np
import pytest
from hmmlearn.hmm import GMMHMM

from tests.prosody_gestures.models import drawn_model
from understudy.prosody_gestures.estimation import (
    PLAIN,
    CountSmoothing,
    MixtureOptions,
    count,
    count_labels,
    fit_mixtures,
)
from understudy.prosody_gestures.semi_markov import Segment, SemiMarkovModel, segments_of

PATHS = [
    [Segment(0, 0, 2), Segment(1, 2, 3), Segment(0, 5, 2)],
    [Segment(0, 0, 4), Segment(0, 4, 2)],
    [Segment(1, 0, 9)],
]


def test_shares_are_what_was_counted() -> None:
    """Two of three paths begin in 0, whatever follows (eq. 11); 9 frames count as the longest, 5."""
    counted = count(PATHS, 2, 5, PLAIN)
    assert np.exp(counted.log_initial) == pytest.approx([2 / 3, 1 / 3])
    assert np.exp(counted.log_transition) == pytest.approx(np.array([[1 / 2, 1 / 2], [1, 0]]))
    assert np.exp(counted.log_duration) == pytest.approx(np.array([[0, 3 / 4, 0, 1 / 4, 0], [0, 0, 1 / 2, 0, 1 / 2]]))


def test_smoothing_forbids_nothing_and_keeps_the_order() -> None:
    counted = count(PATHS, 2, 5, CountSmoothing())
    assert np.isfinite(counted.log_duration).all()
    assert np.exp(counted.log_duration).sum(axis=1) == pytest.approx([1, 1])
    assert counted.log_duration[0].argmax() == 1
    assert counted.log_transition[1, 0] > counted.log_transition[1, 1]


def test_labels_are_counted_in_their_states() -> None:
    emissions = count_labels([(PATHS[0], np.array([2, 2, 0, 0, 1, 2, 1]))], 2, 3, added=0.0)
    assert np.exp(emissions.log_probability) == pytest.approx(np.array([[0, 1 / 4, 3 / 4], [2 / 3, 1 / 3, 0]]))


def test_a_model_is_learnt_back_from_its_own_paths() -> None:
    model = drawn_model(4, states=3, longest=6)
    paths = [_path(model, np.random.default_rng(seed)) for seed in range(300)]
    counted = count(paths, 3, 6, CountSmoothing(spread=0.0))
    assert np.exp(counted.log_transition) == pytest.approx(np.exp(model.log_transition), abs=0.05)
    assert np.exp(counted.log_duration) == pytest.approx(np.exp(model.log_duration), abs=0.05)


def test_one_frame_is_a_path() -> None:
    assert count([segments_of([1])], 2, 3, PLAIN).log_initial[1] == 0.0


def _path(model: SemiMarkovModel, generator: np.random.Generator) -> list[Segment]:
    path, chances, start = list[Segment](), model.log_initial, 0
    for _ in range(20):
        state = int(generator.choice(3, p=np.exp(chances)))
        frames = 1 + int(generator.choice(6, p=np.exp(model.log_duration[state])))
        path.append(Segment(state, start, frames))
        start, chances = start + frames, model.log_transition[state]
    return path


def test_two_heaps_are_found() -> None:
    generator = np.random.default_rng(0)
    heaps = np.concatenate([generator.normal(-3, 0.5, (300, 2)), generator.normal(4, 1.5, (700, 2))])
    mixture = fit_mixtures([heaps], MixtureOptions(components=2))
    order = mixture.means[0, :, 0].argsort()
    assert np.exp(mixture.log_weights[0, order]) == pytest.approx([0.3, 0.7], abs=0.01)
    assert mixture.means[0, order] == pytest.approx(np.array([[-3, -3], [4, 4]]), abs=0.15)
    assert mixture.variances[0, order] == pytest.approx(np.array([[0.25, 0.25], [2.25, 2.25]]), rel=0.2)


def test_likelihoods_are_those_of_hmmlearn() -> None:
    """Three states of two components each; the oracle gives the same logarithms."""
    generator = np.random.default_rng(1)
    mixture = fit_mixtures([generator.normal(size=(90, 4)) * scale for scale in (1, 2, 3)], MixtureOptions(2))
    oracle = GMMHMM(n_components=3, n_mix=2, covariance_type="diag")
    oracle.n_features = 4
    oracle.weights_, oracle.means_, oracle.covars_ = np.exp(mixture.log_weights), mixture.means, mixture.variances
    frames = generator.normal(size=(50, 4))
    assert mixture.log_likelihoods(frames) == pytest.approx(oracle._compute_log_likelihood(frames), abs=1e-9)


def test_a_rare_state_has_fewer_components() -> None:
    frames = np.random.default_rng(2).normal(size=(40, 3))
    mixture = fit_mixtures([frames, np.empty((0, 3))], MixtureOptions(components=4, frames_each=30))
    assert (np.exp(mixture.log_weights[0]) > 0.01).sum() == 1
    assert mixture.means[1, 0] == pytest.approx(frames.mean(axis=0)), "a state never seen is like any other"


def test_no_deviation_is_too_small() -> None:
    mixture = fit_mixtures([np.zeros((100, 1))], MixtureOptions(components=2, least_deviation=0.2))
    assert mixture.variances.min() == pytest.approx(0.04)
