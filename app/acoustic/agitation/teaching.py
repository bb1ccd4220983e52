"""Teaches a classifier of agitation on the recordings of one's own actors (paper §3.1.4), and tells how well it does on
speakers that it has not heard.

Levels count alike, however many recordings each has. A recording may belong to two levels: fuzzy input, as in the
paper's reference (Thiel, Scherer & Schwenker 2007). The kernel is chosen by the recordings held out, as for the shipped
model (`training/agitation`), among few: what few recordings can tell apart.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from ...errors import InputError
from ...model import FloatArray, Level
from ...model.voice.signal import SpeakerReference
from .classifier import AgitationModel, likeness_at, squared_distances
from .fuzzy_training import Kernel, held_out_values, joint_logistic, speaker_folds, standards, train_machines
from .utterance_features import TypicalSpeaker

REACHES = (0.06, 0.12, 0.25)
COSTS = (1.0, 3.0)
FEWEST_OF_A_LEVEL = 4
MOST_LEFT_OUT = 12
"""As many groups of speakers are left out in turn; with more speakers, several at a time."""


@dataclass(frozen=True, slots=True, eq=False)
class LabelledRecordings:
    """Recordings with their labels: `features` (recordings, features), NaN where unknown, `memberships` (recordings, 3)
    in the order of `Level`, each summing to 1, and `speakers` (recordings,)."""

    features: FloatArray
    memberships: FloatArray
    speakers: NDArray[np.str_]

    def where(self, chosen: NDArray[np.bool_]) -> "LabelledRecordings":
        """The chosen recordings."""
        return LabelledRecordings(self.features[chosen], self.memberships[chosen], self.speakers[chosen])

    @property
    def groups(self) -> NDArray[np.str_]:
        """Who is left out together: speakers, where all levels are left to learn from, else single recordings."""
        if _teaches_without(self, self.speakers):
            return self.speakers
        return np.array([f"{index:06}" for index in range(len(self.speakers))])


@dataclass(frozen=True, slots=True)
class LeftOut:
    """How often recordings that were left out in turn were given their level: by level, and the mean of these. `by`
    says what was left out, "speaker" or "recording"; chance is one in three."""

    by: str
    recordings: int
    speakers: int
    by_level: tuple[float, ...]

    @property
    def balanced(self) -> float:
        """The mean over levels."""
        return sum(self.by_level) / len(self.by_level)


def teach(taught: LabelledRecordings, feature_set: str) -> AgitationModel:
    """The model; raises InputError `labels_wrong` for too few recordings of a level."""
    _require_enough(taught)
    return _trained(taught, feature_set, _chosen(taught))


def left_out(taught: LabelledRecordings, feature_set: str) -> LeftOut:
    """The accuracy on each recording of models that have not heard its speaker; raises as `teach` does."""
    _require_enough(taught)
    groups, right = taught.groups, np.zeros(len(taught.speakers), dtype=bool)
    levels = taught.memberships.argmax(axis=1)
    for held_out in speaker_folds(groups, MOST_LEFT_OUT):
        rest = taught.where(~held_out)
        model = _trained(rest, feature_set, _chosen(rest))
        for row in np.flatnonzero(held_out):
            memberships = model.unknown_speaker.memberships(model.typical.completed(taught.features[row]))
            right[row] = int(memberships.argmax()) == levels[row]
    by_level = tuple(float(right[levels == index].mean()) for index in range(len(Level)))
    by = "speaker" if groups is taught.speakers or bool((groups == taught.speakers).all()) else "recording"
    return LeftOut(by, len(levels), len(set(taught.speakers.tolist())), by_level)


def _trained(taught: LabelledRecordings, feature_set: str, kernel: Kernel) -> AgitationModel:
    typical, weights = _typical(taught), _weights(taught)
    features = typical.completed(taught.features)
    relative = np.array(
        [_relative(typical, features, taught.speakers, row, feature_set) for row in range(len(weights))]
    )
    unknown, known = (train_machines(seen, weights, taught.groups, kernel) for seen in (features, relative))
    return AgitationModel(feature_set, typical, unknown_speaker=unknown, known_speaker=known)


def _typical(taught: LabelledRecordings) -> TypicalSpeaker:
    """The mean over recordings, and the deviation within a speaker's; over all recordings where each speaker has but
    one."""
    names = sorted(set(taught.speakers.tolist()))
    spoken = [taught.features[taught.speakers == name] for name in names]
    variances = [np.nanvar(rows, axis=0) for rows in spoken if len(rows) > 1] or [np.nanvar(taught.features, axis=0)]
    deviation = np.sqrt(np.nanmean(variances, axis=0))
    mean = np.nanmean(taught.features, axis=0)
    return TypicalSpeaker(np.nan_to_num(mean), np.where(np.nan_to_num(deviation) > 0, deviation, 1.0))


def _relative(
    typical: TypicalSpeaker, features: FloatArray, speakers: NDArray[np.str_], row: int, feature_set: str
) -> FloatArray:
    """A recording against all others of its speaker; against the typical speaker if there is none."""
    others = features[(speakers == speakers[row]) & (np.arange(len(speakers)) != row)]
    nobody = SpeakerReference(feature_set, 0, typical.mean, np.zeros_like(typical.mean))
    return typical.relative(features[row], SpeakerReference.of(feature_set, others) if len(others) else nobody)


def _weights(taught: LabelledRecordings) -> FloatArray:
    """The memberships, scaled so that each level has the same sum, 1 on average over recordings."""
    shares = taught.memberships / taught.memberships.sum(axis=0)
    weights: FloatArray = shares * (len(shares) / shares.sum())
    return weights


def _chosen(taught: LabelledRecordings) -> Kernel:
    """The kernel with the lowest held-out cross-entropy."""
    features, weights = _typical(taught).completed(taught.features), _weights(taught)
    kernels = list(_kernels(features.shape[1]))
    surprises = [_surprise(features, weights, taught.groups, kernel) for kernel in kernels]
    return kernels[int(np.argmin(surprises))]


def _kernels(features: int) -> Iterator[Kernel]:
    for reach, cost in product(REACHES, COSTS):
        yield Kernel(features, reach, cost)


def _surprise(features: FloatArray, weights: FloatArray, groups: NDArray[np.str_], kernel: Kernel) -> float:
    """Mean negative log of the membership in the level of each recording, by machines that have not heard it."""
    from scipy.special import log_softmax

    mean, scale = standards(features, kernel.features)
    points = (features - mean) / scale
    likeness = likeness_at(squared_distances(points, points), kernel.gamma)
    values = held_out_values(likeness, weights, groups, kernel.cost)
    slopes, offsets = joint_logistic(values, weights)
    return -float(np.sum(weights * log_softmax(values * slopes + offsets, axis=1)) / weights.sum())


def _teaches_without(taught: LabelledRecordings, groups: NDArray[np.str_]) -> bool:
    """Whether, whoever is left out and then again of the rest, two recordings of each level are left."""
    folds = list(speaker_folds(groups, 2))
    return len(set(groups.tolist())) > 2 and all(
        bool((np.count_nonzero(taught.memberships[~held_out], axis=0) >= 2).all()) for held_out in folds
    )


def _require_enough(taught: LabelledRecordings) -> None:
    counts = np.count_nonzero(taught.memberships, axis=0).tolist()
    few = [f"{level.value}: {count}" for level, count in zip(Level, counts, strict=True) if count < FEWEST_OF_A_LEVEL]
    if few:
        message = (
            f"too few recordings ({', '.join(few)}); give {FEWEST_OF_A_LEVEL} at least of low, medium and high each"
        )
        raise InputError("labels_wrong", message, field="labels")
