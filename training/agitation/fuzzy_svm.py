"""Trains a fuzzy-input fuzzy-output support vector machine (F²SVM), one level against the others.

Thiel, Scherer & Schwenker (2007), "Fuzzy-input fuzzy-output one-against-all support vector machines": every sample
stands on both sides of each machine, and its slack there costs as much as it belongs to that side. The decision values
become memberships through a logistic function, fitted on speakers the machines have not heard.

Samples are weighted so that the levels of a corpus count the same, however many recordings each has.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.special import log_softmax
from sklearn.svm import SVC

from app.acoustic.agitation import AgitationModel, FuzzySvm, Machine
from app.acoustic.speaker import SpeakerReference, TypicalSpeaker
from app.model import FloatArray, Level
from training.agitation.corpus import Samples

COST = 1.0
"""Price of a unit of slack, chosen with `GAMMA` on RAVDESS and EmoDB by speaker-disjoint cross-validation; 3 does
alike."""

GAMMA = {"paper": 0.02, "full": 0.005}
"""Of the kernel, by feature set; half and twice do alike."""

CALIBRATION_FOLDS = 4


def train(samples: Samples, feature_set: str, corpus_weights: Mapping[str, float]) -> AgitationModel:
    """The model that `samples` teach; `corpus_weights` tells what a recording of each corpus counts."""
    weights = balanced_weights(samples, corpus_weights)
    typical = typical_speaker(samples)
    samples = replace(samples, features=typical.completed(samples.features))
    relative = replace(samples, features=relative_features(samples, typical, feature_set))
    unknown, known = (train_svm(seen, weights, GAMMA[feature_set]) for seen in (samples, relative))
    return AgitationModel(feature_set, typical, unknown_speaker=unknown, known_speaker=known)


def typical_speaker(samples: Samples) -> TypicalSpeaker:
    """The mean over recordings, and the deviation within speakers."""
    variances = [
        np.nanvar(samples.features[samples.speakers == speaker], axis=0) for speaker in np.unique(samples.speakers)
    ]
    return TypicalSpeaker(np.nanmean(samples.features, axis=0), np.sqrt(np.nanmean(variances, axis=0)))


def relative_features(samples: Samples, typical: TypicalSpeaker, feature_set: str) -> FloatArray:
    """Each recording against all others of its speaker; shape as the features."""
    relative = np.empty_like(samples.features)
    for speaker in np.unique(samples.speakers):
        (rows,) = np.nonzero(samples.speakers == speaker)
        for row in rows:
            reference = SpeakerReference.of(feature_set, samples.features[rows[rows != row]])
            relative[row] = typical.relative(samples.features[row], reference)
    return relative


def train_svm(samples: Samples, weights: FloatArray, gamma: float) -> FuzzySvm:
    """The F²SVM that samples with these `weights` (rows, 3) teach."""
    mean, scale = samples.features.mean(axis=0), samples.features.std(axis=0)
    points = (samples.features - mean) / scale
    slopes, offsets = joint_logistic(held_out_values(points, weights, samples.speakers, gamma), weights)
    machines = []
    for index in range(len(Level)):
        svm = fit_fuzzy(points, *_sides(weights, index), gamma)
        machines.append(to_machine(svm, float(slopes[index]), float(offsets[index])))
    return FuzzySvm(mean, scale, gamma, tuple(machines))


def balanced_weights(samples: Samples, corpus_weights: Mapping[str, float]) -> FloatArray:
    """Memberships scaled so that the levels of a corpus have the same sum; 1 on average over rows; shape (rows, 3)."""
    weights: FloatArray = np.zeros_like(samples.memberships)
    for corpus in np.unique(samples.corpora):
        rows = samples.corpora == corpus
        share = corpus_weights[str(corpus)] * rows.sum()
        weights[rows] = share * samples.memberships[rows] / samples.memberships[rows].sum(axis=0)
    weights *= len(weights) / weights.sum()
    return weights


def speaker_folds(speakers: NDArray[np.str_], count: int) -> Iterator[NDArray[np.bool_]]:
    """Masks of the rows held out, `count` folds or fewer, each speaker in exactly one."""
    names = np.unique(speakers)
    for start in range(min(count, len(names))):
        yield np.isin(speakers, names[start::count])


def held_out_values(points: FloatArray, weights: FloatArray, speakers: NDArray[np.str_], gamma: float) -> FloatArray:
    """Decision values of each sample by machines that have not heard its speaker; shape (rows, 3)."""
    values = np.zeros(weights.shape)
    for held_out in speaker_folds(speakers, CALIBRATION_FOLDS):
        for index in range(len(Level)):
            svm = fit_fuzzy(points[~held_out], *_sides(weights[~held_out], index), gamma)
            values[held_out, index] = svm.decision_function(points[held_out])
    return values


def joint_logistic(values: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Slope and offset of each machine's decision value that make softmax likeliest to give the memberships."""

    def surprise(slopes_and_offsets: FloatArray) -> tuple[float, FloatArray]:
        slopes, offsets = np.split(slopes_and_offsets, 2)
        log_memberships = log_softmax(values * slopes + offsets, axis=1)
        errors = (np.exp(log_memberships) * weights.sum(axis=1, keepdims=True) - weights) / weights.sum()
        gradient = np.concatenate([np.sum(errors * values, axis=0), errors.sum(axis=0)])
        return -float(np.sum(weights * log_memberships) / weights.sum()), gradient

    slopes, offsets = np.split(minimize(surprise, np.repeat([1.0, 0.0], len(Level)), jac=True).x, 2)
    return slopes, offsets


def fit_fuzzy(points: FloatArray, inside: FloatArray, outside: FloatArray, gamma: float) -> SVC:
    """The machine whose slacks on either side cost `inside` and `outside` times `COST`, sample by sample."""
    belongs, differs = inside > 0, outside > 0
    both = np.concatenate([points[belongs], points[differs]])
    sides = np.concatenate([np.ones(belongs.sum()), -np.ones(differs.sum())])
    return SVC(C=COST, gamma=gamma).fit(both, sides, np.concatenate([inside[belongs], outside[differs]]))


def to_machine(svm: SVC, slope: float, offset: float) -> Machine:
    """The fitted machine as the program keeps it."""
    coefficients: FloatArray = svm.dual_coef_[0]
    return Machine(svm.support_vectors_, coefficients, float(svm.intercept_[0]), slope, offset)


def _sides(weights: FloatArray, index: int) -> tuple[FloatArray, FloatArray]:
    """How much each sample weighs on the level's side and on the other."""
    return weights[:, index], weights.sum(axis=1) - weights[:, index]
