"""How a voice moves within the utterance: one row of numbers that needs no knowledge of whose voice it is.

Where a voice lies differs from speaker to speaker; how it moves against itself differs less. An agitated speaker's
loudness, timbre and pitch change faster, fall less towards the end, and the spectrum changes in other places: in his
loud and high moments rather than between them. Levels are dB, pitch octaves, frames 10 ms apart as all contours are.
NaN where too little is voiced to tell. Neither the recording's level nor the utterance's length matters.
"""

import numpy as np
from numpy.typing import NDArray

from ...model import Contours, FloatArray, SingleArray
from .vocal_effort import spectral_flux_db, spectrum_db
from .voice_quality import VoiceQuality

Mask = NDArray[np.bool_]

FEWEST_VOICED_FRAMES = 8
NEAR_THE_LOUDEST_DB = (3.0, 6.0, 10.0)
_OF_THE_VOICE = 24
_PAIR_FRAMES = 2
_FEWEST_PAIRS = 6
_SPECTRUM_BANDS = 10
_LEAST_ENERGY_SPREAD = 10.0
_LEAST_SPREAD = 1e-6


def motion_features(contours: Contours, quality: VoiceQuality, *, spoken: Mask) -> FloatArray:
    """What tells how the voice moves; shape (34,).

    Steps 5, decline 5, flux 2, what flux goes with 7, time near the loudest 3, steadiness 2, bands that go with
    loudness 10. `spoken` (frames,) tells which frames are speech.
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
    """Log of how far energy, tilt, peak slope, harmonicity and cepstral peak go from one voiced frame to the next."""
    measures = (quality.tilt_db, quality.peak_slope, quality.harmonicity_db, quality.cepstral_peak_db)
    tracks = np.column_stack([contours.energy_db, *measures])[voiced]
    steps: FloatArray = np.log(np.median(np.abs(np.diff(tracks, axis=0)), axis=0) + 1e-2)
    return steps


def _decline(tracks: FloatArray) -> FloatArray:
    """How far each of `tracks` (voiced frames, measures) climbs from the first to the last, along a straight line."""
    place = np.linspace(-0.5, 0.5, len(tracks))
    decline: FloatArray = place @ tracks / (place @ place)
    return decline


def _correlations(one: FloatArray, others: FloatArray) -> FloatArray:
    """Of `one` (frames,) with each of `others` (frames, measures)."""
    one, others = one - one.mean(), others - others.mean(axis=0)
    correlations: FloatArray = one @ others / (np.sqrt(one @ one * np.sum(others**2, axis=0)) + _LEAST_SPREAD)
    return correlations


def _steadiness(track: FloatArray, voiced: Mask) -> float:
    """Correlation of the track with itself 20 ms later."""
    later, sooner = slice(_PAIR_FRAMES, None), slice(None, -_PAIR_FRAMES)
    pairs = voiced[later] & voiced[sooner]
    if pairs.sum() < _FEWEST_PAIRS:
        return np.nan
    return float(_correlations(track[sooner][pairs], track[later][pairs, np.newaxis])[0])


def _bands_with_loudness(energy_db: FloatArray, levels_db: SingleArray) -> FloatArray:
    """Change, for each dB of energy, of the level of ten bands of even width on the Mel scale; needs no voice."""
    power = np.power(10, levels_db / 10).reshape(len(levels_db), _SPECTRUM_BANDS, -1).sum(axis=2, dtype=np.float64)
    bands_db, energy_db = 10 * np.log10(power), energy_db - energy_db.mean()
    change: FloatArray = energy_db @ (bands_db - bands_db.mean(axis=0)) / (energy_db @ energy_db + _LEAST_ENERGY_SPREAD)
    return change
