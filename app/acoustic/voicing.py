"""Which frames are voiced: four measures of each frame, weighed together, and a price on every change of mind.

SRH alone, the paper's measure (§3.1.3), hears the window of 100 ms it is taken from: voicing begins too early and ends
too late, a faint hum between words counts as a voice, and so do other voices behind the speaker's. Three measures of
the band in which a voice is strongest (`app.acoustic.periodicity`) stand beside it. The weights are a logistic
regression (`python -m training.voicing`); `python -m benchmarks.pitch` shows what they are worth against `SRH_ALONE`.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.acoustic.best_path import best_path
from app.acoustic.periodicity import Levels
from app.model import FloatArray


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
    """Whether each frame is voiced."""
    excess = measured @ voicing.weights - voicing.threshold
    change_costs = np.broadcast_to(voicing.change_cost * (1 - np.eye(2)), (len(excess) - 1, 2, 2))
    voiced: NDArray[np.bool_] = best_path(np.column_stack([np.zeros(len(excess)), excess]), change_costs) == 1
    return voiced
