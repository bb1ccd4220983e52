"""Feature vectors of utterances for the classification of agitation (paper §3.1.4).

There are two sets. `paper` is the median of the 12 MFCC. `full` adds range and rate of change of the MFCC, energy,
pitch, voice quality, vocal effort and voice dynamics. No feature depends on the recording's level or the utterance's
length. Without voiced frames, voice features are NaN (unknown).
"""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from ...model import FRAME_SHIFT_S, Contours, FloatArray, VoiceQuality
from .vocal_effort import effort_features
from .vocal_motion import dynamics_features

ACTIVE_RANGE_DB = 20.0
"""Frames within this range of the loudest count as voice rather than background."""

SPOKEN_RANGE_DB = 30.0
"""Frames within this range of the loudest count as speech, including its faint sounds."""

SYLLABLES_A_SECOND, PITCH_RANGE_OCTAVES = 38, 41
"""Where these stand in `full_features`."""

FEWEST_VOICED_FRAMES = 5
_SYLLABLE_RANGE_DB = 25.0
_RANGE_PERCENT = (10, 90)
_SMOOTHING = np.hanning(9) / np.hanning(9).sum()


def paper_features(contours: Contours, _quality: VoiceQuality) -> FloatArray:
    """The median MFCC over the active frames, shape (12,).

    The paper uses all frames. Pauses and background say nothing about the voice, and leaving them out is the largest
    single gain in accuracy (`python -m benchmarks.acoustic.agitation --ablation`).
    """
    features: FloatArray = np.median(contours.mfcc[_within(contours.energy_db, ACTIVE_RANGE_DB)], axis=0)
    return features


def full_features(contours: Contours, quality: VoiceQuality) -> FloatArray:
    """The paper's features and those of dynamics, pitch, voice quality and effort, shape (149,).

    Together these gain .08 on RAVDESS and .19 on EmoDB; they overlap, so that hardly any single group is missed alone
    (`python -m benchmarks.acoustic.agitation --ablation`).
    """
    spoken = _within(contours.energy_db, SPOKEN_RANGE_DB)
    active = _within(contours.energy_db, ACTIVE_RANGE_DB)
    groups = (
        paper_features(contours, quality),
        _cepstral_motion(contours),
        _energy_and_tempo(contours),
        _of_the_voice(contours, quality),
        effort_features(contours, quality, spoken=spoken, active=active),
        dynamics_features(contours, quality, spoken=spoken),
    )
    return np.concatenate(groups)


FEATURE_SETS: Mapping[str, Callable[[Contours, VoiceQuality], FloatArray]] = {
    "paper": paper_features,
    "full": full_features,
}


def _cepstral_motion(contours: Contours) -> FloatArray:
    """For each MFCC over the active frames: its range, and the log of its mean change in 20 ms; 24 features."""
    active = _within(contours.energy_db, ACTIVE_RANGE_DB)
    if len(active) < 3:
        return np.full(2 * contours.mfcc.shape[1], np.nan)
    steps = np.abs(contours.mfcc[2:] - contours.mfcc[:-2])[active[1:-1]]
    if not len(steps):
        return np.full(2 * contours.mfcc.shape[1], np.nan)
    return np.concatenate([_range(contours.mfcc[active]), np.log(np.median(steps, axis=0) + 0.1)])


def _energy_and_tempo(contours: Contours) -> FloatArray:
    """Spread of energy in dB, share of the utterance that is speech, and energy peaks per second (roughly
    syllables)."""
    energy_db = contours.energy_db
    spoken = np.flatnonzero(_within(energy_db, SPOKEN_RANGE_DB))
    span = spoken[-1] - spoken[0] + 1
    smooth = np.convolve(np.maximum(energy_db, energy_db.max() - 40), _SMOOTHING, mode="same")[: len(energy_db)]
    before, at, after = smooth[:-2], smooth[1:-1], smooth[2:]
    peaks = np.sum((at > before) & (at >= after) & (at > energy_db.max() - _SYLLABLE_RANGE_DB))
    return np.array([energy_db[spoken].std(), len(spoken) / span, peaks / (span * FRAME_SHIFT_S)])


def _of_the_voice(contours: Contours, quality: VoiceQuality) -> FloatArray:
    """Pitch (in octaves) and voice quality of voiced frames, 10 features. The share of voicing is always known."""
    spoken = _within(contours.energy_db, SPOKEN_RANGE_DB)
    voiced = spoken & (contours.f0_hz > 0)
    share = np.sum(voiced) / np.sum(spoken)
    if np.sum(voiced) < FEWEST_VOICED_FRAMES:
        return np.array([share, *[np.nan] * 9])
    octaves = np.log2(contours.f0_hz[voiced])
    tilt_db = quality.tilt_db
    active = _within(contours.energy_db, ACTIVE_RANGE_DB)
    return np.array(
        [
            share,
            np.median(octaves),
            _range(octaves),
            np.percentile(octaves, 95),
            np.log(np.median(np.abs(np.diff(octaves))) + 1e-3),
            np.median(quality.peak_slope[voiced]),
            np.median(quality.harmonicity_db[voiced]),
            np.median(quality.cepstral_peak_db[voiced]),
            np.median(tilt_db[voiced]),
            _range(tilt_db[active]),
        ]
    )


def _within(energy_db: FloatArray, range_db: float) -> NDArray[np.bool_]:
    within: NDArray[np.bool_] = energy_db >= energy_db.max() - range_db
    return within


def _range(values: FloatArray) -> FloatArray:
    """The range from the 10th to the 90th percentile of each column."""
    low, high = np.percentile(values, _RANGE_PERCENT, axis=0)
    distance: FloatArray = high - low
    return distance
