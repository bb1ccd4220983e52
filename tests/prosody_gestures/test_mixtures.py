"""Gaussian mixtures of frames."""

import numpy as np
import pytest
from hmmlearn.hmm import GMMHMM

from understudy.prosody_gestures.mixtures import MixtureOptions, fit_mixtures


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
