"""Trains the experts of the model of affect, one a corpus, and the gate between them.

An expert's machines between tones are those of agitation (`training/agitation/fuzzy_svm.py`): fuzzy support vector
machines, whose decision values become shares by a softmax that is fitted on speakers the machines have not heard. That
is what makes the shares neutral where nothing is certain. The dimensions are a ridge regression on the same kernel
values. The gate is a logistic regression between the corpora.
"""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from sklearn.linear_model import LogisticRegression

from training.affect.corpus import SYNTHETIC, Taught
from training.agitation.fuzzy_svm import Recipe, balanced_weights, relative_features, train_svm, typical_speaker
from understudy.acoustic.affect.affect_model import FEATURE_SET, AffectModel, Expert, Gate, KernelMachines
from understudy.acoustic.agitation.classifier import FuzzySvm, likeness_at, squared_distances
from understudy.model import FloatArray, Tone

RIDGE = 3.0
"""Of the dimensions, on kernel values."""

SELDOM: Mapping[Tone, float] = MappingProxyType({Tone.DISGUSTED: 0.4, Tone.SURPRISED: 0.4})
"""What tones count that are acted more than they are meant; the others count 1."""

MEANT_PLAINLY = 3.0
"""What neutral recordings of synthetic voices count: most of what such voices say is meant without a feeling."""

SCALES: Mapping[str, tuple[float, ...]] = MappingProxyType({"emodb": (0.3, 1.0, 3.5)})
"""The scales of the kernel (`Recipe`) where there are several: EmoDB, the smallest corpus, gains by them (.765 to .782
with its expert alone, whichever scales), RAVDESS loses (.658 to .623)."""

GATE_PENALTY = 0.01
FAMILIAR_PERCENT = 99.0
"""So many of the recordings are familiar."""


@dataclass(frozen=True, slots=True)
class AffectRecipe:
    """`reach` of the kernel and `cost` of slack, as in `Recipe`."""

    reach: float = 0.35
    cost: float = 3.0

    def of(self, corpus: str, features: int) -> Recipe:
        return Recipe(features, self.reach, self.cost, {corpus: 1.0}, SCALES.get(corpus, (1.0,)))


def train_affect(material: Taught, corpora: Collection[str], recipe: AffectRecipe) -> AffectModel:
    """The model that the recordings of `corpora` teach; how a speaker usually sounds is people's to tell."""
    material = material.where(np.isin(material.samples.corpora, list(corpora)))
    people = material.where(material.samples.corpora != SYNTHETIC)
    typical = typical_speaker((people if len(people.dimensions) else material).samples)
    material = material.with_features(typical.completed(material.samples.features))
    relative = material.with_features(relative_features(material.samples, typical, FEATURE_SET))
    gate = train_gate(material, list(corpora))
    distances = np.mean(((material.samples.features - gate.mean) / gate.scale) ** 2, axis=1)
    experts = []
    for corpus in corpora:
        own = material.samples.corpora == corpus
        tones, unknown = train_machines(material.where(own), recipe)
        experts.append(Expert(corpus, tones, unknown, train_machines(relative.where(own), recipe)[1]))
    return AffectModel(typical, gate, tuple(experts), float(np.percentile(distances, FAMILIAR_PERCENT)))


def train_machines(material: Taught, recipe: AffectRecipe) -> tuple[tuple[Tone, ...], KernelMachines]:
    """The tones of one corpus, and the machines that it teaches."""
    toned = material.where(np.atleast_1d(material.samples.memberships.any(axis=1)))
    present = np.flatnonzero(toned.samples.memberships.sum(axis=0))
    samples = replace(toned.samples, memberships=toned.samples.memberships[:, present])
    told = recipe.of(str(samples.corpora[0]), samples.features.shape[1])
    tones = tuple(list(Tone)[place] for place in present)
    counts = dict(SELDOM) | ({Tone.NEUTRAL: MEANT_PLAINLY} if SYNTHETIC in samples.corpora else {})
    weights = balanced_weights(samples, told.corpus_shares) * [counts.get(tone, 1.0) for tone in tones]
    svm = train_svm(samples, weights, told)
    return tones, KernelMachines(svm, *fit_dimensions(svm, material))


def fit_dimensions(svm: FuzzySvm, material: Taught) -> tuple[FloatArray, FloatArray]:
    """Coefficients (n, 3) of the kernel values and intercepts (3,) that give the dimensions."""
    points = (material.samples.features - svm.mean) / svm.scale
    alike = likeness_at(squared_distances(points, svm.support_vectors), svm.gamma)
    origin, middle = material.dimensions.mean(axis=0), alike.mean(axis=0)
    centred = alike - middle
    within = centred.T @ centred + RIDGE * np.eye(len(middle))
    coefficients = np.linalg.solve(within, centred.T @ (material.dimensions - origin))
    return coefficients, origin - middle @ coefficients


def train_gate(material: Taught, corpora: list[str]) -> Gate:
    """The gate between the corpora, in this order; they count the same."""
    features = material.samples.features
    mean, scale = features.mean(axis=0), features.std(axis=0)
    if len(corpora) == 1:
        return Gate(mean, scale, np.zeros((features.shape[1], 1)), np.zeros(1))
    numbers = [corpora.index(corpus) for corpus in material.samples.corpora.tolist()]
    regression = LogisticRegression(C=GATE_PENALTY, class_weight="balanced", max_iter=500)
    regression.fit((features - mean) / scale, numbers)
    weights, bias = regression.coef_.T, regression.intercept_
    if len(corpora) == 2:
        weights, bias = np.column_stack([-weights, weights]) / 2, np.append(-bias, bias) / 2
    return Gate(mean, scale, weights, bias)
