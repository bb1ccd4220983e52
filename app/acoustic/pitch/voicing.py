"""Voicing decision: a weighted sum of four measures per frame, with a cost for each change between voiced and unvoiced.

SRH alone, the paper's measure (§3.1.3), smears over its 100 ms window: voicing starts too early and ends too late, and
faint hum or other voices between words count as voiced. Three measures of the frequency band in which voices are
strongest (`understudy.acoustic.pitch.periodicity`) are added. The weights are from a logistic regression (`python -m
training.voicing`); `python -m benchmarks.acoustic.pitch` compares the result with `SRH_ALONE`.
"""

from dataclasses import dataclass
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .periodicity import Levels


@dataclass(frozen=True, slots=True)
class Voicing:
    """The weights of the four measures; a frame is voiced if their weighted sum exceeds `threshold`.

    harmonics: weight of the SRH at f0.
    periodicity: weight of the autocorrelation of the band, at most 1, at a lag of one period.
    below_loud, above_quiet: weights of the band's energy relative to the loud and to the quiet frames, per 10 dB.
    change_cost: cost of a change between voiced and unvoiced frames, in units of the sum.
    """

    harmonics: float
    periodicity: float
    below_loud: float
    above_quiet: float
    threshold: float
    change_cost: float

    @property
    def weights(self) -> FloatArray:
        return np.array([self.harmonics, self.periodicity, self.below_loud, self.above_quiet])


SRH_ALONE = Voicing(1.0, 0.0, 0.0, 0.0, threshold=0.07, change_cost=0.0)
"""The published decision (Drugman & Alwan 2011)."""

WEIGHED = Voicing(16.1, 5.1, 2.25, 1.5, threshold=3.85, change_cost=2.0)
"""Fitted by `training.voicing` on the files with odd numbers, which were also used to choose the cost."""


def measures(srh: FloatArray, periodicities: FloatArray, levels: Levels) -> FloatArray:
    """The four measures in the order of `Voicing.weights` (frames × 4)."""
    return np.column_stack([srh, periodicities, levels.below_loud_db / 10, levels.above_quiet_db / 10])


def voiced_frames(measured: FloatArray, voicing: Voicing) -> NDArray[np.bool_]:
    """Whether each frame is voiced: the sequence that maximizes the excess over the threshold less the cost of changes.

    `advantage` is the score of the best sequence so far that is voiced in the frame, less that of the best one that is
    not (Viterbi). An advantage beyond the cost of a change cannot be reversed by later frames: such frames are decided,
    and those between take the decision of the next decided one.
    """
    cost = voicing.change_cost
    excess = measured @ voicing.weights - voicing.threshold
    advantage = np.array(list(accumulate(excess.tolist(), lambda before, here: min(max(before, -cost), cost) + here)))
    decided = np.abs(advantage) >= cost
    decided[-1] = True
    deciding = np.flatnonzero(decided)[np.cumsum(decided) - decided]
    voiced: NDArray[np.bool_] = advantage[deciding] > 0
    return voiced
