"""Trains a fuzzy-input fuzzy-output support vector machine (F²SVM), one level against the others.

Thiel, Scherer & Schwenker (2007), "Fuzzy-input fuzzy-output one-against-all support vector machines": every sample
stands on both sides of each machine, and its slack there costs as much as it belongs to that side. The decision values
become memberships through a logistic function, fitted on speakers the machines have not heard.

Samples are weighted so that the levels of a corpus count the same, however many recordings each has, and that a
recording heard under several conditions counts as one. What `training/agitation/choosing.py` chooses is a `Recipe`.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.special import log_softmax
from sklearn.svm import SVC

from training.agitation.corpus import Samples
from understudy.acoustic.agitation.agitation import AgitationModel, FuzzySvm, squared_distances
from understudy.acoustic.agitation.speaker import TypicalSpeaker
from understudy.model import FloatArray
from understudy.model.voice.speaker_reference import SpeakerReference

CALIBRATION_FOLDS = 4

CONDITION_SHARES = {"clean": 0.4, "degraded": 0.2, "deeper": 0.2, "higher": 0.2}
"""What a recording counts as heard under each condition."""


@dataclass(frozen=True, slots=True)
class Recipe:
    """What is chosen.

    features: so many of the feature set, from the first, have a say.
    reach: of the kernel, exp(-reach · mean squared difference of the standardised features).
    cost: price of a unit of slack.
    corpus_shares: what each corpus counts, all its recordings together.
    """

    features: int
    reach: float
    cost: float
    corpus_shares: Mapping[str, float]

    @property
    def gamma(self) -> float:
        """Of the kernel, exp(-gamma · squared distance)."""
        return self.reach / self.features


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """A level's decision surface among the training points: coefficient of each (rows,), 0 where it has no say."""

    coefficients: FloatArray
    intercept: float


def train(samples: Samples, feature_set: str, recipe: Recipe) -> AgitationModel:
    """The model that `samples` teach by the recipe."""
    weights = balanced_weights(samples, recipe.corpus_shares)
    typical = typical_speaker(samples)
    samples = replace(samples, features=typical.completed(samples.features))
    relative = replace(samples, features=relative_features(samples, typical, feature_set))
    unknown, known = (train_svm(seen, weights, recipe) for seen in (samples, relative))
    return AgitationModel(feature_set, typical, unknown_speaker=unknown, known_speaker=known)


def typical_speaker(samples: Samples) -> TypicalSpeaker:
    """The mean over recordings, and the deviation within a speaker's under one condition."""
    variances = [np.nanvar(samples.features[rows], axis=0) for rows in samples.occasions()]
    return TypicalSpeaker(np.nanmean(samples.features, axis=0), np.sqrt(np.nanmean(variances, axis=0)))


def relative_features(samples: Samples, typical: TypicalSpeaker, feature_set: str) -> FloatArray:
    """Each recording against all others of its speaker under the same condition; shape as the features."""
    relative = np.empty_like(samples.features)
    for rows in samples.occasions():
        for row in rows:
            reference = SpeakerReference.of(feature_set, samples.features[rows[rows != row]])
            relative[row] = typical.relative(samples.features[row], reference)
    return relative


def train_svm(samples: Samples, weights: FloatArray, recipe: Recipe) -> FuzzySvm:
    """The F²SVM that samples with these `weights` (rows, classes) teach."""
    mean, scale = standards(samples.features, recipe)
    points = (samples.features - mean) / scale
    kernel = np.exp(-recipe.gamma * squared_distances(points, points))
    slopes, offsets = joint_logistic(held_out_values(kernel, weights, samples.speakers, recipe.cost), weights)
    surfaces = [fit_fuzzy(kernel, *_sides(weights, index), recipe.cost) for index in range(weights.shape[1])]
    coefficients = np.stack([surface.coefficients for surface in surfaces], axis=1)
    supporting = coefficients.any(axis=1)
    return FuzzySvm(
        mean=mean,
        scale=scale,
        gamma=recipe.gamma,
        support_vectors=points[supporting],
        coefficients=coefficients[supporting],
        intercepts=np.array([surface.intercept for surface in surfaces]),
        slopes=slopes,
        offsets=offsets,
    )


def standards(features: FloatArray, recipe: Recipe) -> tuple[FloatArray, FloatArray]:
    """Mean and scale of each feature; the scale of those that have no say is infinite."""
    scale = np.where(np.arange(features.shape[1]) < recipe.features, features.std(axis=0), np.inf)
    return features.mean(axis=0), scale


def balanced_weights(samples: Samples, corpus_shares: Mapping[str, float]) -> FloatArray:
    """Memberships (rows, classes) scaled so that the classes of a corpus have the same sum, and corpora their share.

    They are 1 on average over recordings, whose conditions share that as `CONDITION_SHARES` has it.
    """
    conditions, counts = np.unique(samples.conditions, return_counts=True)
    shares = {str(condition): CONDITION_SHARES[str(condition)] for condition in conditions}
    shared = np.array([shares[condition] for condition in samples.conditions.tolist()]) / sum(shares.values())
    weights = samples.memberships * shared[:, None]
    for corpus in np.unique(samples.corpora):
        rows = samples.corpora == corpus
        weights[rows] *= corpus_shares[str(corpus)] / weights[rows].sum(axis=0)
    weights *= counts.max() / weights.sum()
    return weights


def speaker_folds(speakers: NDArray[np.str_], count: int) -> Iterator[NDArray[np.bool_]]:
    """Masks of the rows held out, `count` folds or fewer, each speaker in exactly one."""
    names = np.unique(speakers)
    for start in range(min(count, len(names))):
        yield np.isin(speakers, names[start::count])


def held_out_values(kernel: FloatArray, weights: FloatArray, speakers: NDArray[np.str_], cost: float) -> FloatArray:
    """Decision values of each sample by machines that have not heard its speaker; shape (rows, classes).

    `kernel` (rows, rows) tells how alike the samples are.
    """
    values = np.zeros(weights.shape)
    for held_out in speaker_folds(speakers, CALIBRATION_FOLDS):
        among, towards = kernel[np.ix_(~held_out, ~held_out)], kernel[np.ix_(held_out, ~held_out)]
        for index in range(weights.shape[1]):
            surface = fit_fuzzy(among, *_sides(weights[~held_out], index), cost)
            values[held_out, index] = towards @ surface.coefficients + surface.intercept
    return values


def joint_logistic(values: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Slope and offset of each machine's decision value that make softmax likeliest to give the memberships."""

    def surprise(slopes_and_offsets: FloatArray) -> tuple[float, FloatArray]:
        slopes, offsets = np.split(slopes_and_offsets, 2)
        log_memberships = log_softmax(values * slopes + offsets, axis=1)
        errors = (np.exp(log_memberships) * weights.sum(axis=1, keepdims=True) - weights) / weights.sum()
        gradient = np.concatenate([np.sum(errors * values, axis=0), errors.sum(axis=0)])
        return -float(np.sum(weights * log_memberships) / weights.sum()), gradient

    slopes, offsets = np.split(minimize(surprise, np.repeat([1.0, 0.0], weights.shape[1]), jac=True).x, 2)
    return slopes, offsets


def fit_fuzzy(kernel: FloatArray, inside: FloatArray, outside: FloatArray, cost: float) -> Surface:
    """The surface whose slacks on either side cost `inside` and `outside` times `cost`, sample by sample."""
    (belongs,), (differs,) = np.nonzero(inside), np.nonzero(outside)
    rows = np.concatenate([belongs, differs])
    sides = np.repeat([1.0, -1.0], [len(belongs), len(differs)])
    slack_weights = np.concatenate([inside[belongs], outside[differs]])
    svm = SVC(C=cost, kernel="precomputed").fit(kernel[np.ix_(rows, rows)], sides, slack_weights)
    coefficients = np.zeros(len(kernel))
    np.add.at(coefficients, rows[svm.support_], svm.dual_coef_[0])
    return Surface(coefficients, float(svm.intercept_[0]))


def _sides(weights: FloatArray, index: int) -> tuple[FloatArray, FloatArray]:
    """How much each sample weighs on the level's side and on the other."""
    return weights[:, index], weights.sum(axis=1) - weights[:, index]
