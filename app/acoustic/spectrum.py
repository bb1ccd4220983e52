"""Energy and Mel frequency cepstral coefficients, one row every 10 ms (paper §3.1.1, §3.1.2).

All contours share their frames: frame k is centred on k × 10 ms and 32 ms long, the signal counts as silent outside
itself, and n samples at 16 kHz make 1 + n // 160 frames. Levels are in dB re full scale squared, so that energy is 0 dB
where the windowed samples' squares sum to 1.
"""

from collections.abc import Iterator

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from app.acoustic.mel import mel_filters
from app.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray

FRAME_SAMPLES = round(0.032 * SAMPLE_RATE_HZ)
SHIFT_SAMPLES = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ)
ENERGY_FLOOR_DB = -100.0
"""Energy of digital silence: some 20 dB under the rounding noise of 16-bit samples (about -78 dB in a frame)."""

_LEAST_POWER = 1e-20
"""Of a Mel band of digital silence."""

MEL_BANDS = 40
MEL_MIN_HZ = 80.0
"""Under the voice there is only rumble, which would tell the recording apart, not the voice."""

MEL_RANGE_DB = 50.0
"""A Mel band counts as no fainter than this under the loudest of the utterance, lest the cepstrum follow the noise."""

COEFFICIENTS = 12

_HAMMING = np.hamming(FRAME_SAMPLES + 1)[:-1]
_HANN = np.hanning(FRAME_SAMPLES + 1)[:-1]
_FRAMES_AT_ONCE = 2000
"""So many, lest half an hour of speech take gigabytes."""


def energy_db(audio: Audio) -> FloatArray:
    """Energy of each frame, 10 log10 of the sum of the squared Hamming-windowed samples, dB (paper §3.1.2, eq. 1, 2).

    Never below `ENERGY_FLOOR_DB`; shape (frames,).
    """
    energy = np.concatenate([np.square(block) @ np.square(_HAMMING) for block in _blocks(audio)])
    decibels: FloatArray = 10 * np.log10(np.maximum(energy, 10 ** (ENERGY_FLOOR_DB / 10)))
    return decibels


def mfcc(audio: Audio, *, min_hz: float = MEL_MIN_HZ, range_db: float = MEL_RANGE_DB) -> FloatArray:
    """Mel frequency cepstral coefficients 1 to 12 of Hann-windowed frames; shape (frames, 12) (paper §3.1.1).

    The paper does not say which 12. We leave out coefficient 0, the mean level in dB, since it tells how the recording
    was set up rather than how the voice sounds. Scaling the signal changes nothing: faint bands are floored relative to
    the loudest (`python -m benchmarks.agitation --ablation` shows what floor and lower edge are worth).
    """
    filters = mel_filters(FRAME_SAMPLES, bands=MEL_BANDS, lowest_hz=min_hz, highest_hz=SAMPLE_RATE_HZ / 2)
    spectra = (np.abs(np.fft.rfft(block * _HANN)) ** 2 for block in _blocks(audio))
    mel_db = 10 * np.log10(np.maximum(np.concatenate([spectrum @ filters.T for spectrum in spectra]), _LEAST_POWER))
    coefficients: FloatArray = np.maximum(mel_db, mel_db.max() - range_db) @ _cosines().T
    return coefficients


def _cosines() -> FloatArray:
    """The orthonormal discrete cosine transform (type II) over the bands, less coefficient 0; (coefficients, bands)."""
    orders, bands = np.arange(1, 1 + COEFFICIENTS)[:, None], np.arange(MEL_BANDS)
    cosines: FloatArray = np.sqrt(2 / MEL_BANDS) * np.cos(np.pi * orders * (bands + 0.5) / MEL_BANDS)
    return cosines


def _blocks(audio: Audio) -> Iterator[FloatArray]:
    """The frames in order, (frames, samples); half a frame of silence at both ends centres the first on sample 0."""
    padded = np.pad(audio.samples, FRAME_SAMPLES // 2)
    frames = sliding_window_view(padded, FRAME_SAMPLES)[::SHIFT_SAMPLES]
    return (frames[first : first + _FRAMES_AT_ONCE] for first in range(0, len(frames), _FRAMES_AT_ONCE))
