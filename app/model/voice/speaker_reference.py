"""How a speaker usually sounds: the statistics of other recordings, by which an utterance is normalized."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .signal import FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class SpeakerReference:
    """A speaker's statistics over `recordings` recordings; `mean` and `deviation` have shape (features,)."""

    feature_set: str
    recordings: int
    mean: FloatArray
    deviation: FloatArray

    @classmethod
    def of(cls, feature_set: str, rows: Sequence[FloatArray] | FloatArray) -> "SpeakerReference":
        """The statistics of `rows`, the features of at least one recording each."""
        return cls(feature_set, len(rows), np.mean(rows, axis=0), np.std(rows, axis=0))
