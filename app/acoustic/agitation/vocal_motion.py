"""Features of voice dynamics within the utterance, which depend little on the speaker.

Speakers differ in average pitch and timbre but less in how these change. In agitated speech, loudness, timbre and pitch
change faster and decline less towards the end, and the spectrum changes at other places: in loud and high moments
rather than between them. Levels are in dB, pitch in octaves, frames 10 ms apart. NaN if too few frames are voiced.
Neither the recording's level nor the utterance's length matters.
"""

import numpy as np
from numpy.typing import NDArray

from ...model import Contours, FloatArray, SingleArray, VoiceQuality
from .vocal_effort import spectral_flux_db, spectrum_db

Mask = NDArray[np.bool_]

FEWEST_VOICED_FRAMES = 8
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
    if voiced.sum() < FEWEST_VOICED_FRAMES:
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
