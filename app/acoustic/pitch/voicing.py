"""Which frames are voiced: four measures of each frame, weighed together, and a price on every change of language.

SRH alone, the paper's measure (§3.1.3), hears the window of 100 ms it is taken from: voicing begins too early and ends
too late, a faint hum between words counts as a voice, and so do other voices behind the speaker's. Three measures of
the band in which a voice is strongest (`understudy.acoustic.pitch.periodicity`) stand beside it. The weights are a
logistic regression (`python -m training.voicing`); `python -m benchmarks.acoustic.pitch` shows what they are worth
against `SRH_ALONE`.
"""

from dataclasses import dataclass
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .periodicity import Levels


@dataclass(frozen=True, slots=True)
class Voicing:
    """How the four measures are weighed: a frame is voiced when their weighted sum exceeds `threshold`.

    harmonics: weight of the SRH at f0.
    periodicity: weight of the correlation, at most 1, of the band with itself one period later.
    below_loud, above_quiet: weights of the band's energy over the loud and over the quiet frames, per 10 dB.
    change_cost: what it costs to turn from voiced to unvoiced or back between two frames, in units of the sum.
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
"""Fitted by `training.voicing` on the files of odd number; the cost was chosen on the same."""


def measures(srh: FloatArray, periodicities: FloatArray, levels: Levels) -> FloatArray:
    """What is weighed, in the order of `Voicing.weights` (frames × 4)."""
    return np.column_stack([srh, periodicities, levels.below_loud_db / 10, levels.above_quiet_db / 10])


def voiced_frames(measured: FloatArray, voicing: Voicing) -> NDArray[np.bool_]:
    """Whether each frame is voiced: the sequence of greatest excess over the threshold less the cost of its changes.

    `advantage` is how much better the best sequence is that is voiced in the frame than the best that is not, with all
    that came before (Viterbi). A change costs less than an advantage beyond its cost loses, whatever comes after: such
    frames are decided, and those between are as the next decided one is.
    """
    cost = voicing.change_cost
    excess = measured @ voicing.weights - voicing.threshold
    advantage = np.array(list(accumulate(excess.tolist(), lambda before, here: min(max(before, -cost), cost) + here)))
    decided = np.abs(advantage) >= cost
    decided[-1] = True
    deciding = np.flatnonzero(decided)[np.cumsum(decided) - decided]
    voiced: NDArray[np.bool_] = advantage[deciding] > 0
    return voiced
