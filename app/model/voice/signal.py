"""The recording and what is measured in it frame by frame."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.floating]
SingleArray = NDArray[np.float32]

SAMPLE_RATE_HZ = 16_000
"""The sample rate of every signal that passes between the stages."""

FRAME_SHIFT_S = 0.010
"""One analysis frame every 10 ms: frame k is centred on k × 10 ms (paper §3.1.1, §3.1.2)."""


@dataclass(frozen=True, slots=True, eq=False)
class Audio:
    """One mono signal at `SAMPLE_RATE_HZ`; full scale is ±1. Single precision once decoded, as fine as 24 bits."""

    samples: FloatArray

    @property
    def duration_s(self) -> float:
        return len(self.samples) / SAMPLE_RATE_HZ


@dataclass(frozen=True, slots=True, eq=False)
class Contours:
    """One row a frame (`FRAME_SHIFT_S`): energy in dB, f0 in Hz (0: unvoiced), 12 MFCC, and their Mel bands in dB."""

    energy_db: FloatArray
    f0_hz: FloatArray
    mfcc: FloatArray
    mel_db: SingleArray


@dataclass(frozen=True, slots=True, eq=False)
class VoiceQuality:
    """Frame-wise measures, shape (frames,) each; the first is meaningful in voiced frames only.

    harmonicity_db: harmonics-to-noise ratio (Boersma 1993), from the autocorrelation at the period, divided by that of
        the window; the minimum where the frame is unvoiced.
    cepstral_peak_db: cepstral peak prominence between 60 and 500 Hz over a regression line (Hillenbrand, Cleveland &
        Erickson 1994).
    tilt_db: power from 1 to 5 kHz over power from 50 Hz to 1 kHz.
    peak_slope: slope of wavelet peaks over octaves (`understudy.acoustic.agitation.peak_slope`).
    """

    harmonicity_db: FloatArray
    cepstral_peak_db: FloatArray
    tilt_db: FloatArray
    peak_slope: FloatArray
