"""The affect of the current phrase, as far as it has been heard. Memory is bounded.

The last seconds of sound are kept and judged on demand, so a stream without words costs nothing.
"""

import numpy as np

from ..acoustic.stage import AcousticModels, hear_sound
from ..model import SAMPLE_RATE_HZ, Affect, Audio, FloatArray

LONGEST_S = 6.0
SHORTEST_S = 0.8
"""A shorter part of a phrase is not judged."""


class RunningFeeling:
    """Takes mono samples in [-1, 1] at `SAMPLE_RATE_HZ`."""

    def __init__(self) -> None:
        self._recent: FloatArray = np.empty(0)
        self._last: Affect | None = None

    def hear(self, samples: FloatArray) -> None:
        """More of the voice."""
        self._recent = np.concatenate([self._recent, samples])[-round(LONGEST_S * SAMPLE_RATE_HZ) :]

    def of_phrase(self, acoustic: AcousticModels, lasting_s: float | None) -> Affect | None:
        """The affect of the current phrase, which has lasted so long; that of the phrase before if the current one is
        too short or there is none; None before the first."""
        if lasting_s is not None and lasting_s >= SHORTEST_S:
            samples = self._recent[-round(min(lasting_s, LONGEST_S) * SAMPLE_RATE_HZ) :]
            self._last = hear_sound(acoustic, Audio(samples))
        return self._last
