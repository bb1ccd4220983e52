"""Trains a fuzzy-input fuzzy-output support vector machine (F²SVM), one class against the others (paper §3.1.4).

Thiel, Scherer & Schwenker (2007), "Fuzzy-input fuzzy-output one-against-all support vector machines": every sample
stands on both sides of each machine, and its slack there costs as much as it belongs to that side. The decision values
become memberships through a logistic function, fitted on speakers the machines have not heard.

Shapes: N samples, F features, C classes. scikit-learn is imported where machines are fitted, and nowhere else.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .classifier import FuzzySvm, likeness_at, squared_distances

CALIBRATION_FOLDS = 4


@dataclass(frozen=True, slots=True)
class Kernel:
    """What is chosen before machines are trained.

    features: so many of the feature set, from the first, have a say.
    reach: of the kernel, exp(-reach · mean squared difference of the standardized features).
    cost: price of a unit of slack.
    """

    features: int
    reach: float
    cost: float

    @property
    def gamma(self) -> FloatArray:
        """The widths of the kernel, exp(-gamma · squared distance)."""
        return np.array([self.reach / self.features])


@dataclass(frozen=True, slots=True, eq=False)
class DecisionSurface:
    """A class's decision surface among the training points: coefficient of each (N,), 0 where it has no say."""

    coefficients: FloatArray
    intercept: float


def train_machines(features: FloatArray, weights: FloatArray, speakers: NDArray[np.str_], kernel: Kernel) -> FuzzySvm:
    """The F²SVM that samples with these features (N, F) and `weights` (N, C) of `speakers` (N,) teach."""
    mean, scale = standards(features, kernel.features)
    points = (features - mean) / scale
    likeness = likeness_at(squared_distances(points, points), kernel.gamma)
    slopes, offsets = joint_logistic(held_out_values(likeness, weights, speakers, kernel.cost), weights)
    surfaces = [fit_fuzzy(likeness, *_sides(weights, index), kernel.cost) for index in range(weights.shape[1])]
    coefficients = np.stack([surface.coefficients for surface in surfaces], axis=1)
    supporting = coefficients.any(axis=1)
    return FuzzySvm(
        mean=mean,
        scale=scale,
        gamma=kernel.gamma,
        support_vectors=points[supporting],
        coefficients=coefficients[supporting],
        intercepts=np.array([surface.intercept for surface in surfaces]),
        slopes=slopes,
        offsets=offsets,
    )


def standards(features: FloatArray, used: int) -> tuple[FloatArray, FloatArray]:
    """Mean and scale of each feature (F,); the scale of those after the first `used`, and of those that never differ,
    is infinite: they have no say."""
    deviation = features.std(axis=0)
    scale = np.where((np.arange(features.shape[1]) < used) & (deviation > 0), deviation, np.inf)
    return features.mean(axis=0), scale


def speaker_folds(speakers: NDArray[np.str_], count: int) -> Iterator[NDArray[np.bool_]]:
    """Masks of the rows held out, `count` folds or fewer, each speaker in exactly one."""
    names = np.unique(speakers)
    for start in range(min(count, len(names))):
        yield np.isin(speakers, names[start::count])


def held_out_values(likeness: FloatArray, weights: FloatArray, speakers: NDArray[np.str_], cost: float) -> FloatArray:
    """Decision values of each sample (N, C) by machines that have not heard its speaker.

    `likeness` (N, N) tells how alike the samples are.
    """
    values = np.zeros(weights.shape)
    for held_out in speaker_folds(speakers, CALIBRATION_FOLDS):
        among, towards = likeness[np.ix_(~held_out, ~held_out)], likeness[np.ix_(held_out, ~held_out)]
        for index in range(weights.shape[1]):
            surface = fit_fuzzy(among, *_sides(weights[~held_out], index), cost)
            values[held_out, index] = towards @ surface.coefficients + surface.intercept
    return values


def joint_logistic(values: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Slope and offset of each machine's decision value (C,) that make softmax likeliest to give the memberships."""
    from scipy.optimize import minimize
    from scipy.special import log_softmax

    def surprise(slopes_and_offsets: FloatArray) -> tuple[float, FloatArray]:
        slopes, offsets = np.split(slopes_and_offsets, 2)
        log_memberships = log_softmax(values * slopes + offsets, axis=1)
        errors = (np.exp(log_memberships) * weights.sum(axis=1, keepdims=True) - weights) / weights.sum()
        gradient = np.concatenate([np.sum(errors * values, axis=0), errors.sum(axis=0)])
        return -float(np.sum(weights * log_memberships) / weights.sum()), gradient

    slopes, offsets = np.split(minimize(surprise, np.repeat([1.0, 0.0], weights.shape[1]), jac=True).x, 2)
    return slopes, offsets


def fit_fuzzy(likeness: FloatArray, inside: FloatArray, outside: FloatArray, cost: float) -> DecisionSurface:
    """The surface whose slacks on either side cost `inside` and `outside` (N,) times `cost`, sample by sample."""
    from sklearn.svm import SVC

    (belongs,), (differs,) = np.nonzero(inside), np.nonzero(outside)
    rows = np.concatenate([belongs, differs])
    sides = np.repeat([1.0, -1.0], [len(belongs), len(differs)])
    slack_weights = np.concatenate([inside[belongs], outside[differs]])
    svm = SVC(C=cost, kernel="precomputed").fit(likeness[np.ix_(rows, rows)], sides, slack_weights)
    coefficients = np.zeros(len(likeness))
    np.add.at(coefficients, rows[svm.support_], svm.dual_coef_[0])
    return DecisionSurface(coefficients, float(svm.intercept_[0]))


def _sides(weights: FloatArray, index: int) -> tuple[FloatArray, FloatArray]:
    """How much each sample weighs on the class's side and on the other."""
    return weights[:, index], weights.sum(axis=1) - weights[:, index]
