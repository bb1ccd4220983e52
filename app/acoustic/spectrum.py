"""Energy and Mel frequency cepstral coefficients, one row every 10 ms (paper §3.1.1, §3.1.2).

All contours share their frames: frame k is centred on k × 10 ms and 32 ms long, the signal counts as silent outside
itself, and n samples at 16 kHz make 1 + n // 160 frames. librosa cuts and transforms them. Levels are in dB re full
scale squared, so that energy is 0 dB where the windowed samples' squares sum to 1.
"""

import numpy as np
from librosa import feature, filters, power_to_db, stft
from librosa.util import frame

from app.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray

FRAME_SAMPLES = round(0.032 * SAMPLE_RATE_HZ)
SHIFT_SAMPLES = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ)
ENERGY_FLOOR_DB = -100.0
"""Energy of digital silence: some 20 dB under the rounding noise of 16-bit samples (about -78 dB in a frame)."""

MEL_BANDS = 40
MEL_MIN_HZ = 80.0
"""Under the voice there is only rumble, which would tell the recording apart, not the voice."""

MEL_RANGE_DB = 50.0
"""A Mel band counts as no fainter than this under the loudest of the utterance, lest the cepstrum follow the noise."""

COEFFICIENTS = 12


def energy_db(audio: Audio) -> FloatArray:
    """Energy of each frame, 10 log10 of the sum of the squared Hamming-windowed samples, dB (paper §3.1.2, eq. 1, 2).

    Never below `ENERGY_FLOOR_DB`; shape (frames,).
    """
    frames = frame(_padded(audio), frame_length=FRAME_SAMPLES, hop_length=SHIFT_SAMPLES, axis=0)
    energy = np.square(frames) @ np.square(filters.get_window("hamming", FRAME_SAMPLES))
    decibels: FloatArray = 10 * np.log10(np.maximum(energy, 10 ** (ENERGY_FLOOR_DB / 10)))
    return decibels


def mfcc(audio: Audio, *, min_hz: float = MEL_MIN_HZ, range_db: float = MEL_RANGE_DB) -> FloatArray:
    """Mel frequency cepstral coefficients 1 to 12 of Hann-windowed frames; shape (frames, 12) (paper §3.1.1).

    The paper does not say which 12. We leave out coefficient 0, the mean level in dB, since it tells how the recording
    was set up rather than how the voice sounds. Scaling the signal changes nothing: faint bands are floored relative to
    the loudest (`python -m benchmarks.agitation --ablation` shows what floor and lower edge are worth).
    """
    spectrum = stft(_padded(audio), n_fft=FRAME_SAMPLES, hop_length=SHIFT_SAMPLES, window="hann", center=False)
    bands = filters.mel(sr=SAMPLE_RATE_HZ, n_fft=FRAME_SAMPLES, n_mels=MEL_BANDS, fmin=min_hz, dtype=np.float64)
    mel_db = power_to_db(bands @ np.square(np.abs(spectrum)), ref=np.max, amin=1e-20, top_db=range_db)
    coefficients: FloatArray = feature.mfcc(S=mel_db, n_mfcc=1 + COEFFICIENTS)[1:].T
    return coefficients


def _padded(audio: Audio) -> FloatArray:
    """The signal with half a frame of silence at both ends, so that the first frame is centred on the first sample."""
    return np.pad(audio.samples, FRAME_SAMPLES // 2)
