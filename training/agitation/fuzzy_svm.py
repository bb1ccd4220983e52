"""Trains a fuzzy-input fuzzy-output support vector machine (F²SVM), one level against the others.

Thiel, Scherer & Schwenker (2007), "Fuzzy-input fuzzy-output one-against-all support vector machines": every sample
stands on both sides of each machine, and its slack there costs as much as it belongs to that side. The decision values
become memberships through logistic functions, fitted on speakers the machine has not heard.

Samples are weighted so that the levels of a corpus count the same, however many recordings each has.
"""

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray
from sklearn.linear_model import LogisticRegression
from sklearn.svm import SVC

from app.acoustic.agitation import AgitationModel, Machine
from app.model import FloatArray, Level
from training.agitation.corpus import Samples

COST = 1.0
"""Price of a unit of slack, chosen with `GAMMA` on RAVDESS by speaker-disjoint cross-validation; .3 to 3 do alike."""

GAMMA = 0.02
CALIBRATION_FOLDS = 4
LOGISTIC_COST = 1e3


def train(samples: Samples, corpus_weights: Mapping[str, float]) -> AgitationModel:
    """The model that `samples` teach; `corpus_weights` tells what a recording of each corpus counts."""
    mean, scale = samples.features.mean(axis=0), samples.features.std(axis=0)
    points = (samples.features - mean) / scale
    weights = balanced_weights(samples, corpus_weights)
    folds = list(speaker_folds(samples.speakers, CALIBRATION_FOLDS))
    machines = []
    for index in range(len(Level)):
        inside = weights[:, index]
        machines.append(_machine(points, inside, weights.sum(axis=1) - inside, folds))
    return AgitationModel(mean, scale, GAMMA, tuple(machines))


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


def fit_fuzzy(points: FloatArray, inside: FloatArray, outside: FloatArray) -> SVC:
    """The machine whose slacks on either side cost `inside` and `outside` times `COST`, sample by sample."""
    both, sides, weights = _both_sides(points, inside, outside)
    return SVC(C=COST, gamma=GAMMA).fit(both, sides, sample_weight=weights)


def to_machine(svm: SVC, slope: float, offset: float) -> Machine:
    """The fitted machine as the program keeps it."""
    coefficients: FloatArray = svm.dual_coef_[0]
    return Machine(svm.support_vectors_, coefficients, float(svm.intercept_[0]), slope, offset)


def _machine(points: FloatArray, inside: FloatArray, outside: FloatArray, folds: list[NDArray[np.bool_]]) -> Machine:
    values = np.zeros(len(points))
    for held_out in folds:
        known = ~held_out
        values[held_out] = fit_fuzzy(points[known], inside[known], outside[known]).decision_function(points[held_out])
    column, sides, weights = _both_sides(values[:, np.newaxis], inside, outside)
    logistic = LogisticRegression(C=LOGISTIC_COST).fit(column, sides, sample_weight=weights)
    return to_machine(fit_fuzzy(points, inside, outside), float(logistic.coef_[0, 0]), float(logistic.intercept_[0]))


def _both_sides(
    points: FloatArray, inside: FloatArray, outside: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Each sample once for either side it belongs to at all: points, sides (1 or -1) and weights."""
    belongs, differs = inside > 0, outside > 0
    return (
        np.concatenate([points[belongs], points[differs]]),
        np.concatenate([np.ones(belongs.sum()), -np.ones(differs.sum())]),
        np.concatenate([inside[belongs], outside[differs]]),
    )
