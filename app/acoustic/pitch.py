"""The fundamental frequency of a voice, frame by frame: summation of residual harmonics (SRH).

Inverse filtering by linear prediction takes the vocal tract off the signal; what remains of a voiced sound is a train
of pulses, whose spectrum has even peaks at the multiples of f0. For each candidate f, SRH sums the amplitudes at its
first harmonics and subtracts those half way between, so that neither the octave above nor the one below wins.
Source: paper §3.1.3, eq. 3; Drugman & Alwan, "Joint robust voicing detection and pitch estimation based on residual
harmonics" (Interspeech 2011).

Frame k is centred on k × `FRAME_SHIFT_S`; frequencies are Hz. `TUNED` departs from `PUBLISHED` in seven things,
measured together by `benchmarks.pitch`:
- A path of least cost through each frame's ten best candidates takes the place of the best candidate of each frame
  alone: most octave errors vanish. Faint frames have less of a say in it: other voices are heard in them, or none.
- By eq. 3 the triple of f0 is as strong as f0 when the harmonics are even, since the valleys of its comb meet none; so
  are the odd multiples beyond. Part of the SRH at f / 3, f / 5 or f / 7, whichever is most, is taken off that at f in
  the search: f0 itself has little there.
- Not the energy of the whole spectrum is brought to one, but that below 3.5 kHz, counted as if the rest were as
  strong. Wide bands give the same; speech that was recorded at 8 kHz keeps its voicing.
- Where the voice moves fast, the window of 100 ms blurs; the period is sought again nearby in one of 40 ms.
- Voicing is decided by more than the SRH (`app.acoustic.voicing`).
- The second pass looks further down than an octave below the speaker's median, where sentences end in creaky voice.
SRH is evaluated every 2 Hz on amplitudes of that spacing, linear in between; a parabola then finds the peak.
"""

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from app.acoustic.best_path import best_path
from app.acoustic.peaks import neighbours, peak_offsets
from app.acoustic.periodicity import WIDEST_BELOW_LOUD_DB, Levels, band_levels, periods_nearby
from app.acoustic.voicing import SRH_ALONE, WEIGHED, Voicing, measures, voiced_frames
from app.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray

LOWEST_F0_HZ = 20
HIGHEST_F0_HZ = 500
HARMONICS = 5
ODD_DIVISORS = (3, 5, 7)
RANGE_THRESHOLD = 0.1
"""SRH above which a frame is trusted when the speaker's range is estimated from the first pass."""

_CANDIDATES_PER_FRAME = 10
_HOP = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ)
_WINDOW = round(0.100 * SAMPLE_RATE_HZ)
_PREDICTION_WINDOW = round(0.025 * SAMPLE_RATE_HZ)
_PREDICTION_HOP = _PREDICTION_WINDOW // 2
_PREDICTION_ORDER = SAMPLE_RATE_HZ // 1000 + 2
_PREDICTION_FFT = 3 * _PREDICTION_HOP
_BIN_HZ = 2
_BLOCK = 256
_HANN = np.hanning(_PREDICTION_WINDOW + 1)[:-1]
_BLACKMAN = np.blackman(_WINDOW + 1)[:-1]
_CANDIDATES_HZ = np.arange(LOWEST_F0_HZ, HIGHEST_F0_HZ + 1, _BIN_HZ, dtype=np.float64)


@dataclass(frozen=True, slots=True)
class Tuning:
    """What may be set.

    speaker_range: the multiples of the first pass's median between which the second pass searches.
    unit_energy_band_hz: the energy from 0 Hz to here is brought to one.
    octave_cost: SRH that a step of one octave between neighbouring frames costs the path; larger steps cost no more.
    faintest_weight: how much the path heeds frames 25 dB under the loud, which count 1.
    submultiple_share: the share of the SRH at f / 3, f / 5 or f / 7 that is taken off that at f.
    mends: whether the f0 so found is moved to the best period nearby (`app.acoustic.periodicity`).
    voicing: how it is decided which frames are voiced.
    """

    speaker_range: tuple[float, float]
    unit_energy_band_hz: int
    octave_cost: float
    faintest_weight: float
    submultiple_share: float
    mends: bool
    voicing: Voicing


PUBLISHED = Tuning(
    speaker_range=(0.5, 2.0),
    unit_energy_band_hz=SAMPLE_RATE_HZ // 2,
    octave_cost=0.0,
    faintest_weight=1.0,
    submultiple_share=0.0,
    mends=False,
    voicing=SRH_ALONE,
)
TUNED = Tuning(
    speaker_range=(0.4, 2.0),
    unit_energy_band_hz=3500,
    octave_cost=0.15,
    faintest_weight=0.05,
    submultiple_share=0.35,
    mends=True,
    voicing=WEIGHED,
)


def track_f0(audio: Audio, tuning: Tuning = TUNED) -> FloatArray:
    """f0 in Hz of each frame, 0 where unvoiced; `1 + len(samples) // 160` frames (paper §3.1.3, eq. 3)."""
    f0_hz, evidence = pitch_if_voiced(audio, tuning)
    return np.where(voiced_frames(evidence, tuning.voicing), f0_hz, 0.0)


def pitch_if_voiced(audio: Audio, tuning: Tuning = TUNED) -> tuple[FloatArray, FloatArray]:
    """The best f0 in Hz of every frame, voiced or not, and what speaks for its being voiced (`voicing.measures`)."""
    strengths = _summed_harmonics(_residual(audio.samples), tuning.unit_energy_band_hz)
    merits = strengths - tuning.submultiple_share * _at_submultiples(strengths)
    first, last = _speaker_range(merits, tuning.speaker_range)
    levels = band_levels(audio.samples)
    heeded = merits[:, first : last + 1] * _frame_weights(levels, tuning.faintest_weight)[:, None]
    path = first + _smooth_path(heeded, _CANDIDATES_HZ[first : last + 1], tuning.octave_cost)[:, None]
    f0_hz = (_CANDIDATES_HZ[path] + _BIN_HZ * peak_offsets(merits, path))[:, 0]
    srh = np.take_along_axis(strengths, path, axis=1)[:, 0]
    mended_hz, correlation = periods_nearby(audio.samples, f0_hz)
    return mended_hz if tuning.mends else f0_hz, measures(srh, correlation, levels)


def _residual(samples: FloatArray) -> FloatArray:
    """The signal less what linear prediction foresees, as long as the signal.

    Hann frames of 25 ms, each filtered by the inverse of its own predictor, overlap by half and add up.
    """
    count = 1 + -(-len(samples) // _PREDICTION_HOP)
    padded = np.zeros((count + 1) * _PREDICTION_HOP)
    padded[_PREDICTION_HOP : _PREDICTION_HOP + len(samples)] = samples
    frames = sliding_window_view(padded, _PREDICTION_WINDOW)[::_PREDICTION_HOP]
    total = np.zeros((count + 2, _PREDICTION_HOP))
    for start in range(0, count, _BLOCK):
        filtered = _inversely_filtered(frames[start : start + _BLOCK])
        for shift, part in enumerate(np.split(filtered, 3, axis=1), start):
            total[shift : shift + len(part)] += part
    return total.ravel()[_PREDICTION_HOP : _PREDICTION_HOP + len(samples)]


def _inversely_filtered(frames: FloatArray) -> FloatArray:
    """Each frame, windowed and filtered by its own prediction error filter (frames × `_PREDICTION_FFT`)."""
    spectra = np.fft.rfft(frames * _HANN, _PREDICTION_FFT)
    autocorrelation = np.fft.irfft(np.abs(spectra) ** 2, _PREDICTION_FFT)[:, : _PREDICTION_ORDER + 1]
    filters = np.fft.rfft(_prediction_error_filters(autocorrelation), _PREDICTION_FFT)
    filtered: FloatArray = np.fft.irfft(spectra * filters, _PREDICTION_FFT)
    return filtered


def _prediction_error_filters(autocorrelation: FloatArray) -> FloatArray:
    """The coefficients 1, a₁, a₂ … that whiten each frame (frames × order + 1), by Levinson's recursion."""
    error = autocorrelation[:, 0] * (1 + 1e-9) + 1e-12  # else silence and pure tones have no solution
    coefficients = np.zeros_like(autocorrelation)
    coefficients[:, 0] = 1.0
    for order in range(1, autocorrelation.shape[1]):
        reflection = -np.sum(coefficients[:, :order] * autocorrelation[:, order:0:-1], axis=1) / error
        coefficients[:, 1 : order + 1] += reflection[:, None] * coefficients[:, order - 1 :: -1][:, :order]
        error = error * (1 - reflection**2)
    return coefficients


def _summed_harmonics(residual: FloatArray, band_hz: int) -> FloatArray:
    """SRH of every candidate in every frame (frames × candidates)."""
    count = 1 + len(residual) // _HOP
    padded = np.pad(residual, _WINDOW // 2)
    frames = sliding_window_view(padded, _WINDOW)[::_HOP][:count]
    blocks = [_eq_3(_unit_spectra(frames[start : start + _BLOCK], band_hz)) for start in range(0, count, _BLOCK)]
    return np.concatenate(blocks)


def _unit_spectra(frames: FloatArray, band_hz: int) -> FloatArray:
    """Amplitudes at 0, 1, 2 … Hz, as far as the harmonics need them, of frames with unit energy up to `band_hz`."""
    fft = SAMPLE_RATE_HZ // _BIN_HZ
    amplitudes = np.abs(np.fft.rfft(frames * _BLACKMAN, fft))
    band = amplitudes[:, : band_hz // _BIN_HZ]
    energy = np.sum(band**2, axis=1) * _BIN_HZ * (SAMPLE_RATE_HZ / 2 / band_hz)
    amplitudes = amplitudes[:, : HARMONICS * HIGHEST_F0_HZ // _BIN_HZ + 1]
    amplitudes /= np.sqrt(np.maximum(energy, np.finfo(float).tiny))[:, None]
    spectra = np.empty((len(frames), 2 * amplitudes.shape[1] - 1))
    spectra[:, ::2] = amplitudes
    spectra[:, 1::2] = (amplitudes[:, 1:] + amplitudes[:, :-1]) / 2
    return spectra


def _eq_3(spectra: FloatArray) -> FloatArray:
    """E(f) + Σ E(k f) − E((k − ½) f), k = 2 … `HARMONICS`, for every candidate f; spectra have a value every Hz."""
    low, high = LOWEST_F0_HZ, HIGHEST_F0_HZ
    total = spectra[:, low : high + 1 : _BIN_HZ].copy()
    for k in range(2, HARMONICS + 1):
        total += spectra[:, k * low : k * high + 1 : k * _BIN_HZ]
        total -= spectra[:, k * low - low // 2 : k * high - high // 2 + 1 : (2 * k - 1) * _BIN_HZ // 2]
    return total


def _at_submultiples(strengths: FloatArray) -> FloatArray:
    """The greatest SRH at an odd submultiple of every candidate, linear between candidates; 0 where there is none."""
    greatest = np.zeros_like(strengths)
    for divisor in ODD_DIVISORS:
        position = (_CANDIDATES_HZ / divisor - LOWEST_F0_HZ) / _BIN_HZ
        above = np.flatnonzero(position >= 0)
        below = np.floor(position[above]).astype(int)
        share = position[above] - below
        interpolated = (1 - share) * strengths[:, below] + share * strengths[:, below + 1]
        greatest[:, above] = np.maximum(greatest[:, above], interpolated)
    return greatest


def _speaker_range(merits: FloatArray, multiples: tuple[float, float]) -> tuple[int, int]:
    """The first and last candidate of the second pass; all when the first finds no voice."""
    last = len(_CANDIDATES_HZ) - 1
    best = np.argmax(merits, axis=1)
    trusted = best[np.max(merits, axis=1) > RANGE_THRESHOLD]
    if not len(trusted):
        return 0, last
    bounds = np.searchsorted(_CANDIDATES_HZ, np.median(_CANDIDATES_HZ[trusted]) * np.array(multiples))
    return int(bounds[0]), min(int(bounds[1]), last)


def _frame_weights(levels: Levels, faintest: float) -> FloatArray:
    """1 where the voice is loud, falling with its level in dB to `faintest`."""
    return faintest + (1 - faintest) * (1 + levels.below_loud_db / WIDEST_BELOW_LOUD_DB)


def _smooth_path(merits: FloatArray, candidates_hz: FloatArray, octave_cost: float) -> NDArray[np.intp]:
    """The candidate (column) of every frame along the path of greatest merit less the cost of its steps (Viterbi)."""
    before, after = neighbours(merits)
    peaks = np.where((merits >= before) & (merits >= after), merits, -1.0)
    columns = np.argpartition(-peaks, _CANDIDATES_PER_FRAME, axis=1)[:, :_CANDIDATES_PER_FRAME]
    octaves = np.log2(candidates_hz[columns])
    steps = octave_cost * np.minimum(np.abs(octaves[1:, :, None] - octaves[:-1, None, :]), 1.0)
    path = best_path(np.take_along_axis(peaks, columns, axis=1), steps)
    return np.take_along_axis(columns, path[:, None], axis=1)[:, 0]
