"""A speaker's reference: mean and deviation of the features over other recordings, to normalize an utterance by.

Statistics of few recordings are unreliable, so they are shrunk towards those of a typical speaker, with a prior weight
of `MEAN_PRIOR` recordings (`DEVIATION_PRIOR` for the deviation). `MEAN_PRIOR` is the median over features of the
variance within speakers divided by that between speakers.
"""

from dataclasses import dataclass

import numpy as np

from ...model import FloatArray
from ...model.voice.signal import SpeakerReference

MEAN_PRIOR = 3
DEVIATION_PRIOR = 8


@dataclass(frozen=True, slots=True, eq=False)
class TypicalSpeaker:
    """The features' mean over speakers, and their deviation within speakers."""

    mean: FloatArray
    deviation: FloatArray

    def completed(self, features: FloatArray) -> FloatArray:
        """The features, with unknown ones (NaN) replaced by the average."""
        return np.where(np.isnan(features), self.mean, features)

    def relative(self, features: FloatArray, reference: SpeakerReference) -> FloatArray:
        """The difference of the features from the speaker's mean, in units of the speaker's deviations."""
        count = reference.recordings
        mean = (count * reference.mean + MEAN_PRIOR * self.mean) / (count + MEAN_PRIOR)
        variances = count * reference.deviation**2 + DEVIATION_PRIOR * self.deviation**2
        distance: FloatArray = (features - mean) / np.sqrt(variances / (count + DEVIATION_PRIOR))
        return distance
