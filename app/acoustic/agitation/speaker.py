"""How a speaker usually sounds, to judge a recording against: mean and spread of the features over other recordings.

A few recordings tell little, so the statistics are drawn towards those of a typical speaker, as much as if he had
spoken `MEAN_PRIOR` recordings more (for the spread, `DEVIATION_PRIOR`). The mean's number is the median over features
of the variance within speakers over that between speakers.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...model import FloatArray

MEAN_PRIOR = 3
DEVIATION_PRIOR = 8


@dataclass(frozen=True, slots=True, eq=False)
class SpeakerReference:
    """A speaker's statistics over `recordings` recordings; `mean` and `deviation` have shape (features,)."""

    feature_set: str
    recordings: int
    mean: FloatArray
    deviation: FloatArray

    @classmethod
    def of(cls, feature_set: str, rows: Sequence[FloatArray] | FloatArray) -> "SpeakerReference":
        """The statistics of `rows`, at least one, the features of a recording each."""
        return cls(feature_set, len(rows), np.mean(rows, axis=0), np.std(rows, axis=0))


@dataclass(frozen=True, slots=True, eq=False)
class TypicalSpeaker:
    """The features' mean over speakers, and their deviation within a speaker."""

    mean: FloatArray
    deviation: FloatArray

    def completed(self, features: FloatArray) -> FloatArray:
        """The features, unknown ones (NaN) taken to be average."""
        return np.where(np.isnan(features), self.mean, features)

    def relative(self, features: FloatArray, reference: SpeakerReference) -> FloatArray:
        """How far the features are from the speaker's mean, in his deviations."""
        count = reference.recordings
        mean = (count * reference.mean + MEAN_PRIOR * self.mean) / (count + MEAN_PRIOR)
        variances = count * reference.deviation**2 + DEVIATION_PRIOR * self.deviation**2
        distance: FloatArray = (features - mean) / np.sqrt(variances / (count + DEVIATION_PRIOR))
        return distance
