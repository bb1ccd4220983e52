"""Trains the shipped F²SVM (`understudy.acoustic.agitation.fuzzy_training`) on corpora of acted speech.

Samples are weighted so that the levels of a corpus count the same, however many recordings each has, and that a
recording heard under several conditions counts as one. What `training/agitation/choosing.py` chooses is a `Recipe`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from training.agitation.corpus import Samples
from understudy.acoustic.agitation.classifier import AgitationModel, FuzzySvm
from understudy.acoustic.agitation.fuzzy_training import (
    DecisionSurface,
    Kernel,
    fit_fuzzy,
    held_out_values,
    joint_logistic,
    speaker_folds,
    standards,
    train_machines,
)
from understudy.acoustic.agitation.utterance_features import TypicalSpeaker
from understudy.model import FloatArray
from understudy.model.voice.signal import SpeakerReference

__all__ = [
    "DecisionSurface",
    "Recipe",
    "balanced_weights",
    "fit_fuzzy",
    "held_out_values",
    "joint_logistic",
    "relative_features",
    "speaker_folds",
    "standards",
    "train",
    "train_svm",
    "typical_speaker",
]

CONDITION_SHARES = {"clean": 0.4, "degraded": 0.2, "deeper": 0.2, "higher": 0.2}
"""What a recording counts as heard under each condition."""


@dataclass(frozen=True, slots=True)
class Recipe(Kernel):
    """What is chosen, with what each corpus counts, all its recordings together; the kernel is the mean of those whose
    reach is so many times `reach`."""

    corpus_shares: Mapping[str, float]
    scales: tuple[float, ...] = (1.0,)

    @property
    def gamma(self) -> FloatArray:
        """The widths of the kernel (scales,)."""
        return self.reach / self.features * np.array(self.scales)


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
    return train_machines(samples.features, weights, samples.speakers, recipe)


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
