"""Features of vocal effort beyond median pitch and timbre.

Raising the voice boosts the upper spectrum and the first formant relative to the fundamental, makes them change faster
and further, and raises and widens pitch; and with more effort, timbre and pitch depend more on loudness. All features
are measured within the utterance and as level differences, so that neither the recording's level nor the utterance's
length matters. Levels are in dB, pitch in octaves, frames 10 ms apart. NaN if too few frames are voiced.
"""

import numpy as np
from numpy.typing import NDArray

from ...model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Contours, FloatArray, SingleArray, VoiceQuality
from ..signal.spectrum import FRAME_SAMPLES, MEL_BANDS, MEL_MIN_HZ, mel_filters

Mask = NDArray[np.bool_]
Indices = NDArray[np.intp]

MEL_RANGE_DB = 60.0
"""Bands are clamped to at most this far below the loudest of the utterance."""

FEWEST_VOICED_FRAMES = 8
_SLOPE_BANDS_HZ = ((80, 600), (500, 1600), (1500, 5000))
_LEAPS_FRAMES = (5, 1)
_GREATEST_LEAP_OCTAVES = 0.3
_LEAST_ENERGY_SPREAD = 10.0
_SPECTRUM_BANDS = 10
_LEAST_SHARE = 1e-7


def spectrum_db(contours: Contours, frames: Mask | Indices) -> SingleArray:
    """The level of each Mel band in `frames`, clamped to `MEL_RANGE_DB`; shape (frames, bands)."""
    levels_db: SingleArray = contours.mel_db[frames]
    np.maximum(levels_db, contours.mel_db.max() - MEL_RANGE_DB, out=levels_db)
    return levels_db


def spectral_flux_db(contours: Contours, frames: Indices) -> SingleArray:
    """How much the spectral shape changes in the 20 ms around each of `frames`, which exclude the first and the
    last."""
    steps = spectrum_db(contours, frames + 1) - spectrum_db(contours, frames - 1)
    steps -= steps.mean(axis=1, keepdims=True)
    flux_db: SingleArray = np.sqrt(np.vecdot(steps, steps) / steps.shape[1])
    return flux_db


def effort_features(contours: Contours, quality: VoiceQuality, *, spoken: Mask, active: Mask) -> FloatArray:
    """The features of vocal effort, shape (66,).

    Spectral slopes 12, flux 2, pitch distribution 7, loudness dependence 11, MFCC quartiles 24, spectrum 10. `spoken`
    and the louder `active` (frames,) select the speech frames.
    """
    voiced = spoken & (contours.f0_hz > 0)
    flux = _flux(contours, active)
    always = np.concatenate([_quartiles(contours.mfcc[active]), _spectrum(spectrum_db(contours, spoken))])
    if voiced.sum() < FEWEST_VOICED_FRAMES:
        return np.concatenate([np.full(12, np.nan), flux, np.full(18, np.nan), always])
    octaves = np.log2(contours.f0_hz, out=np.full(len(voiced), np.nan), where=voiced)
    loud = voiced & active
    slopes = _slopes(spectrum_db(contours, loud if loud.any() else voiced))
    return np.concatenate([slopes, flux, _course(octaves), _with_loudness(contours, quality, octaves), always])


def _slopes(levels_db: SingleArray) -> FloatArray:
    """Median and range of the spectral slopes in dB per octave, and of level differences between regions in dB.

    The regions: peak up to 2 kHz over 2 to 5 kHz (Hammarberg et al. 1980), mean of 1 to 5 kHz over that below (alpha
    ratio), peak of the first formant's region (300 Hz to 1 kHz) over the fundamental's.
    """
    filters = mel_filters(FRAME_SAMPLES, bands=MEL_BANDS, lowest_hz=MEL_MIN_HZ, highest_hz=SAMPLE_RATE_HZ / 2)
    centres_hz = filters @ np.fft.rfftfreq(FRAME_SAMPLES, 1 / SAMPLE_RATE_HZ) / filters.sum(axis=1)

    def inside(low_hz: float, high_hz: float) -> Mask:
        bands: Mask = (centres_hz >= low_hz) & (centres_hz < high_hz)
        return bands

    def region(low_hz: float, high_hz: float) -> SingleArray:
        return levels_db[:, inside(low_hz, high_hz)]

    measures = [
        *(_slope(region(*band_hz), np.log2(centres_hz[inside(*band_hz)])) for band_hz in _SLOPE_BANDS_HZ),
        region(0, 2000).max(axis=1) - region(2000, 5000).max(axis=1),
        region(1000, 5000).mean(axis=1) - region(0, 1000).mean(axis=1),
        region(300, 1000).max(axis=1) - region(0, 300).max(axis=1),
    ]
    low, median, high = np.percentile(measures, [20, 50, 80], axis=1)
    return np.concatenate([median, high - low])


def _slope(levels_db: SingleArray, octaves: FloatArray) -> FloatArray:
    aside = octaves - octaves.mean()
    slope: FloatArray = levels_db @ aside / (aside @ aside)
    return slope


def _flux(contours: Contours, active: Mask) -> FloatArray:
    """Log of the spectral flux: median and mean over active frames."""
    flux = spectral_flux_db(contours, np.flatnonzero(active[1:-1]) + 1)
    return np.log(np.array([np.median(flux), np.mean(flux)]) + 0.1) if len(flux) else np.full(2, np.nan)


def _course(octaves: FloatArray) -> FloatArray:
    """Low, lower-quartile and upper-quartile pitch, its deviation, its slope in octaves per second, and the log of its
    changes in 50 ms and in 10 ms."""
    (voiced,) = np.nonzero(~np.isnan(octaves))
    time_s = (voiced - voiced.mean()) * FRAME_SHIFT_S
    slope = time_s @ octaves[voiced] / (time_s @ time_s)
    leaps = [np.abs(octaves[frames:] - octaves[:-frames]) for frames in _LEAPS_FRAMES]
    slow, fast = leaps[0][~np.isnan(leaps[0])], leaps[1][leaps[1] < _GREATEST_LEAP_OCTAVES]
    return np.array(
        [
            *np.percentile(octaves[voiced], [5, 25, 75]),
            octaves[voiced].std(),
            slope,
            np.log(np.median(slow) + 1e-3) if len(slow) else np.nan,
            np.log(np.percentile(fast, 90) + 1e-3) if len(fast) else np.nan,
        ]
    )


def _with_loudness(contours: Contours, quality: VoiceQuality, octaves: FloatArray) -> FloatArray:
    """Change per dB of energy of MFCC 1 to 6, tilt, peak slope, harmonicity, cepstral peak and pitch."""
    voiced = ~np.isnan(octaves)
    columns = (quality.tilt_db, quality.peak_slope, quality.harmonicity_db, quality.cepstral_peak_db, octaves)
    measures = np.column_stack([contours.mfcc[:, :6], *columns])[voiced]
    energy_db = contours.energy_db[voiced] - contours.energy_db[voiced].mean()
    change: FloatArray = energy_db @ (measures - measures.mean(axis=0)) / (energy_db @ energy_db + _LEAST_ENERGY_SPREAD)
    return change


def _quartiles(mfcc: FloatArray) -> FloatArray:
    """The distance of the lower and the upper quartile of each MFCC from its median."""
    low, median, high = np.percentile(mfcc, [25, 50, 75], axis=0)
    return np.concatenate([low - median, high - median])


def _spectrum(levels_db: SingleArray) -> FloatArray:
    """The share of power, in dB, in each of ten bands of equal width on the Mel scale."""
    of_frames = levels_db / 10
    np.power(10, of_frames, out=of_frames)  # avoids a third copy of half an hour of audio
    power = of_frames.sum(axis=0, dtype=np.float64).reshape(_SPECTRUM_BANDS, -1).sum(axis=1)
    shares: FloatArray = 10 * np.log10(power / power.sum() + _LEAST_SHARE)
    return shares
