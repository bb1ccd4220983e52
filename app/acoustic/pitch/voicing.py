"""Voicing decision: a weighted sum of four measures per frame, with a cost for each change between voiced and unvoiced.

SRH alone, the paper's measure (§3.1.3), smears over its 100 ms window: voicing starts too early and ends too late, and
faint hum or other voices between words count as voiced. Three measures of the frequency band in which voices are
strongest are added. The weights are from a logistic regression (`python -m training.voicing`); `python -m
benchmarks.acoustic.pitch` compares the result with `SRH_ALONE`.

Level and periodicity of the frequency band in which voices are strongest.

The autocorrelation in 40 ms windows has better time resolution than the harmonic sum over 100 ms, but confuses the
period with its multiples: it can refine an f0 that is nearly right, not find one (cf. Boersma, "Accurate short-term
analysis of the fundamental frequency …", 1993, whose division by the window's autocorrelation is used).

Frames are those of `understudy.acoustic.signal.frames`.
"""

from dataclasses import dataclass
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from ...model import SAMPLE_RATE_HZ, FloatArray, SingleArray
from ..signal.fourier import rfft
from ..signal.frames import BLOCK, blocks_of_frames, frame_count, product
from .harmonics import peak_offsets


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


@dataclass(frozen=True, slots=True, eq=False)
class Levels:
    """The band's energy in each frame: relative to the loud frames (<= 0) and to the quiet ones (>= 0)."""

    below_loud_db: FloatArray
    above_quiet_db: FloatArray


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


LOWEST_HZ, HIGHEST_HZ = 60, 1000
"""The band: above rumble and below hiss."""

LOUD_PERCENTILE, QUIET_PERCENTILE = 95.0, 10.0
WIDEST_BELOW_LOUD_DB = 25.0

WIDEST_ABOVE_QUIET_DB = 20.0
"""Levels are clamped here: -25 dB is silence, and a studio is no better than a quiet room."""

REACH_OCTAVES = 0.4

OCTAVE_PENALTY = 0.5
"""The correlation by which a period one octave away would have to be better."""

WINDOW_S = 0.040

PERIODS_IN_WINDOW = 3
"""Lower voices, of which a window holds fewer periods, are not refined (Boersma's limit)."""

_STEP_OCTAVES = 0.02
_STEPS = np.arange(-REACH_OCTAVES, REACH_OCTAVES + _STEP_OCTAVES / 2, _STEP_OCTAVES)
_WINDOW = round(WINDOW_S * SAMPLE_RATE_HZ)
_LONGEST_LAG = _WINDOW * 3 // 4

_FFT = 1200
"""At least a window plus the longest lag, to avoid circular correlation."""

_FIRST_BIN, _LAST_BIN = -(-LOWEST_HZ * _FFT // SAMPLE_RATE_HZ), HIGHEST_HZ * _FFT // SAMPLE_RATE_HZ
_HANN = np.hanning(_WINDOW + 1)[:-1].astype(np.float32)
_WINDOW_CORRELATION = np.correlate(_HANN, _HANN, "full")[_WINDOW - 1 :][: _LONGEST_LAG + 2]
_LEAST_ENERGY = 1e-10

_TURNS = 2 * np.pi / _FFT * np.outer(np.arange(_FIRST_BIN, _LAST_BIN + 1), np.arange(_LONGEST_LAG + 2))

_CORRELATING = (2 / _FFT * np.cos(_TURNS) * _WINDOW_CORRELATION[0] / _WINDOW_CORRELATION).astype(np.float32)
"""The matrix from the power spectrum of the band to the autocorrelation at each lag, divided by the window's
(frequencies × lags): with a tenth of the frequencies a matrix product is faster than a transform."""


def band_power(samples: FloatArray) -> SingleArray:
    """The power spectrum of each frame within the band (frames × frequencies)."""
    power = np.empty((frame_count(len(samples)), _LAST_BIN + 1 - _FIRST_BIN), dtype=np.float32)
    for block, frames in blocks_of_frames(samples, _WINDOW, len(power)):
        spectra = rfft(frames * _HANN, _FFT)[:, _FIRST_BIN : _LAST_BIN + 1]
        power[block] = np.square(np.abs(spectra))
    return power


def band_level_db(power: SingleArray) -> FloatArray:
    """The level of each frame in dB, given its `band_power`."""
    level_db: FloatArray = 10 * np.log10(np.sum(power, axis=1, dtype=np.float64) + _LEAST_ENERGY)
    return level_db


def band_levels(power: SingleArray) -> Levels:
    """The level of each frame relative to those of the whole signal, given its `band_power`."""
    level_db = band_level_db(power)
    loud_db, quiet_db = np.percentile(level_db, [LOUD_PERCENTILE, QUIET_PERCENTILE])
    return Levels(
        below_loud_db=np.clip(level_db - loud_db, -WIDEST_BELOW_LOUD_DB, 0),
        above_quiet_db=np.clip(level_db - quiet_db, 0, WIDEST_ABOVE_QUIET_DB),
    )


def periods_nearby(power: SingleArray, f0_hz: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The f0 in Hz near `f0_hz` (> 0) with the highest autocorrelation in each frame, and that correlation, -1 to 1.

    `power` is the signal's `band_power`.
    """
    nearby_hz, correlation = np.empty((2, len(f0_hz)))
    for start in range(0, len(f0_hz), BLOCK):
        block = slice(start, start + BLOCK)
        nearby_hz[block], correlation[block] = _refined(power[block], f0_hz[block])
    return nearby_hz, correlation


def _refined(power: SingleArray, f0_hz: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The refined f0 of each frame and the correlation there."""
    correlations = _correlations(power, SAMPLE_RATE_HZ / f0_hz[:, None] * np.exp2(-_STEPS))
    mendable = f0_hz >= PERIODS_IN_WINDOW / WINDOW_S
    merits = np.where(mendable[:, None], correlations, 0.0) - OCTAVE_PENALTY * np.abs(_STEPS)
    best = np.argmax(merits, axis=1)[:, None]
    steps = _STEPS[best] + _STEP_OCTAVES * peak_offsets(merits, best)
    return f0_hz * np.exp2(steps[:, 0]), np.take_along_axis(correlations, best, axis=1)[:, 0]


def _correlations(power: SingleArray, lags: FloatArray) -> FloatArray:
    """The normalized autocorrelation of each frame's band at its own lags, in samples (frames × lags)."""
    freed = product(power, _CORRELATING)
    freed /= freed[:, :1] + np.float32(_LEAST_ENERGY)
    lags = np.minimum(lags, _LONGEST_LAG)
    below = lags.astype(np.intp)
    share = lags - below
    before, after = (np.take_along_axis(freed, below + step, axis=1) for step in (0, 1))
    interpolated: FloatArray = np.clip((1 - share) * before + share * after, -1, 1)
    return interpolated
