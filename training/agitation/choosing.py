"""Chooses how a model is trained, by a small grid search on the training speakers alone, some of them held out.

Selects the hyper-parameters with the lowest held-out cross-entropy: the mean negative log of the membership that the
held-out recordings have, with their levels alike, as they were recorded; half of it English, since that is what we
hear. The kernel of the choice is for a speaker unknown; the machine for a known one is trained by the same recipe.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

import numpy as np
from scipy.special import log_softmax

from training.agitation.corpus import Samples
from training.agitation.fuzzy_svm import (
    Recipe,
    balanced_weights,
    held_out_values,
    joint_logistic,
    standards,
    typical_speaker,
)
from understudy.acoustic.agitation.classifier import likeness_at, squared_distances
from understudy.model import FloatArray

FEATURES: Mapping[str, tuple[int, ...]] = {"paper": (12,), "full": (115, 149)}
"""So many from the first; the last 34 of `full` tell how the voice moves."""

REACHES = (0.06, 0.12, 0.25)
COSTS = (1.0, 3.0)
JUDGED_SHARES: Mapping[str, float] = {"ravdess": 0.5, "emodb": 0.25, "nemo": 0.25}
"""What each corpus counts in the surprise."""

CORPUS_SHARES: tuple[Mapping[str, float], ...] = (
    JUDGED_SHARES,
    {"ravdess": 0.6, "emodb": 0.2, "nemo": 0.2},
    {"ravdess": 0.7, "emodb": 0.15, "nemo": 0.15},
)
"""What each corpus counts in training: as it is judged, or English leads further."""


def choose(samples: Samples, feature_set: str) -> Recipe:
    """The recipe of the grid that surprises least on speakers held out in fours."""
    clean = samples.where(samples.conditions == "clean")
    corpora = [str(corpus) for corpus in np.unique(samples.corpora)]
    return min(_grid(feature_set, corpora), key=lambda recipe: surprise(clean, recipe))


def surprise(samples: Samples, recipe: Recipe) -> float:
    """Mean negative log of the membership given to each recording's level by machines that have not heard its speaker.

    Corpora count as in `JUDGED_SHARES`, as far as they are among the samples.
    """
    features = typical_speaker(samples).completed(samples.features)
    mean, scale = standards(features, recipe.features)
    points = (features - mean) / scale
    alike = likeness_at(squared_distances(points, points), recipe.gamma)
    weights = balanced_weights(samples, recipe.corpus_shares)
    values = held_out_values(alike, weights, samples.speakers, recipe.cost)
    slopes, offsets = joint_logistic(values, weights)
    surprises = -np.sum(weights * log_softmax(values * slopes + offsets, axis=1), axis=1)
    return _over_corpora(surprises, weights, samples)


def _over_corpora(surprises: FloatArray, weights: FloatArray, samples: Samples) -> float:
    means, shares = [], []
    for corpus in np.unique(samples.corpora):
        rows = samples.corpora == corpus
        means.append(surprises[rows].sum() / weights[rows].sum())
        shares.append(JUDGED_SHARES[str(corpus)])
    return float(np.average(means, weights=shares))


def _grid(feature_set: str, corpora: Sequence[str]) -> Iterator[Recipe]:
    corpus_shares = CORPUS_SHARES if len(corpora) > 1 else ({corpora[0]: 1.0},)
    for features, reach, cost, shares in product(FEATURES[feature_set], REACHES, COSTS, corpus_shares):
        yield Recipe(features=features, reach=reach, cost=cost, corpus_shares=shares)
