"""Feature vectors of utterances for the classification of agitation (paper §3.1.4), and a speaker's reference: mean and
deviation of the features over other recordings, to normalize an utterance by.

There are two sets. `paper` is the median of the 12 MFCC. `full` adds range and rate of change of the MFCC, energy,
pitch, voice quality, vocal effort and voice dynamics. No feature depends on the recording's level or the utterance's
length. Without voiced frames, voice features are NaN (unknown).

Features of voice dynamics within the utterance depend little on the speaker. Speakers differ in average pitch and
timbre but less in how these change. In agitated speech, loudness, timbre and pitch change faster and decline less
towards the end, and the spectrum changes at other places: in loud and high moments rather than between them. Levels are
in dB, pitch in octaves, frames 10 ms apart. NaN if too few frames are voiced. Neither the recording's level nor the
utterance's length matters.

Statistics of few recordings are unreliable, so those of a reference are shrunk towards those of a typical speaker, with
a prior weight of `MEAN_PRIOR` recordings (`DEVIATION_PRIOR` for the deviation). `MEAN_PRIOR` is the median over
features of the variance within speakers divided by that between speakers.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...model import FRAME_SHIFT_S, Contours, FloatArray, SingleArray, VoiceQuality
from ...model.voice.signal import SpeakerReference
from .vocal_effort import effort_features, spectral_flux_db, spectrum_db

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


def paper_features(contours: Contours) -> FloatArray:
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
        paper_features(contours),
        _cepstral_motion(contours),
        _energy_and_tempo(contours),
        _of_the_voice(contours, quality),
        effort_features(contours, quality, spoken=spoken, active=active),
        dynamics_features(contours, quality, spoken=spoken),
    )
    return np.concatenate(groups)


def _within(energy_db: FloatArray, range_db: float) -> NDArray[np.bool_]:
    within: NDArray[np.bool_] = energy_db >= energy_db.max() - range_db
    return within


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


def _range(values: FloatArray) -> FloatArray:
    """The range from the 10th to the 90th percentile of each column."""
    low, high = np.percentile(values, _RANGE_PERCENT, axis=0)
    distance: FloatArray = high - low
    return distance


Mask = NDArray[np.bool_]

FEWEST_FRAMES_OF_MOTION = 8
NEAR_THE_LOUDEST_DB = (3.0, 6.0, 10.0)
_OF_THE_VOICE = 24
_PAIR_FRAMES = 2
_FEWEST_PAIRS = 6
_SPECTRUM_BANDS = 10
_LEAST_ENERGY_SPREAD = 10.0
_LEAST_SPREAD = 1e-6


def dynamics_features(contours: Contours, quality: VoiceQuality, *, spoken: Mask) -> FloatArray:
    """The features of voice dynamics, shape (34,).

    Steps 5, decline 5, flux 2, correlations with flux 7, time near the maximum 3, steadiness 2, loudness dependence of
    bands 10. `spoken` (frames,) selects the speech frames.
    """
    bands = _bands_with_loudness(contours.energy_db[spoken], spectrum_db(contours, spoken))
    voiced = spoken & (contours.f0_hz > 0)
    if voiced.sum() < FEWEST_FRAMES_OF_MOTION:
        return np.concatenate([np.full(_OF_THE_VOICE, np.nan), bands])
    octaves = np.log2(contours.f0_hz, out=np.full(len(voiced), np.nan), where=voiced)
    flux_db = spectral_flux_db(contours, np.clip(np.flatnonzero(voiced), 1, len(voiced) - 2))
    log_flux = np.log(flux_db + 0.1)
    energy_db, timbre = contours.energy_db[voiced], contours.mfcc[voiced, :3]
    kinds = np.column_stack([energy_db, octaves[voiced], quality.peak_slope[voiced], quality.harmonicity_db[voiced]])
    groups = (
        _steps(contours, quality, voiced),
        _decline(np.column_stack([octaves[voiced], energy_db, timbre])),
        np.percentile(log_flux, [20, 80]),
        _correlations(log_flux, np.column_stack([kinds, timbre])),
        [np.mean(energy_db > contours.energy_db.max() - near_db) for near_db in NEAR_THE_LOUDEST_DB],
        [_steadiness(contours.energy_db, voiced), _steadiness(octaves, voiced)],
        bands,
    )
    return np.concatenate(groups)


def _steps(contours: Contours, quality: VoiceQuality, voiced: Mask) -> FloatArray:
    """Log of the mean change of energy, tilt, peak slope, harmonicity and cepstral peak between successive voiced
    frames."""
    measures = (quality.tilt_db, quality.peak_slope, quality.harmonicity_db, quality.cepstral_peak_db)
    tracks = np.column_stack([contours.energy_db, *measures])[voiced]
    steps: FloatArray = np.log(np.median(np.abs(np.diff(tracks, axis=0)), axis=0) + 1e-2)
    return steps


def _decline(tracks: FloatArray) -> FloatArray:
    """The change of each of `tracks` (voiced frames, measures) from first to last frame along a regression line."""
    place = np.linspace(-0.5, 0.5, len(tracks))
    decline: FloatArray = place @ tracks / (place @ place)
    return decline


def _correlations(one: FloatArray, others: FloatArray) -> FloatArray:
    """The correlations of `one` (frames,) with each of `others` (frames, measures)."""
    one, others = one - one.mean(), others - others.mean(axis=0)
    correlations: FloatArray = one @ others / (np.sqrt(one @ one * np.sum(others**2, axis=0)) + _LEAST_SPREAD)
    return correlations


def _steadiness(track: FloatArray, voiced: Mask) -> float:
    """The autocorrelation of the track at a lag of 20 ms."""
    later, sooner = slice(_PAIR_FRAMES, None), slice(None, -_PAIR_FRAMES)
    pairs = voiced[later] & voiced[sooner]
    if pairs.sum() < _FEWEST_PAIRS:
        return np.nan
    return float(_correlations(track[sooner][pairs], track[later][pairs, np.newaxis])[0])


def _bands_with_loudness(energy_db: FloatArray, levels_db: SingleArray) -> FloatArray:
    """Change per dB of energy of the level of ten bands of equal width on the Mel scale; independent of voicing."""
    power = np.power(10, levels_db / 10).reshape(len(levels_db), _SPECTRUM_BANDS, -1).sum(axis=2, dtype=np.float64)
    bands_db, energy_db = 10 * np.log10(power), energy_db - energy_db.mean()
    change: FloatArray = energy_db @ (bands_db - bands_db.mean(axis=0)) / (energy_db @ energy_db + _LEAST_ENERGY_SPREAD)
    return change


FEATURE_SETS: Mapping[str, int] = MappingProxyType({"paper": 12, "full": 149})
"""How many of `full_features` each set has, which begin with the paper's."""


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
