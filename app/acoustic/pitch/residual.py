"""The linear prediction residual: the signal with the vocal tract removed, a pulse train in voiced speech (paper
§3.1.3).

Hann frames of 25 ms, each filtered by its own prediction error filter of order fs / 1000 + 2, are overlapped by half
and added. If only the lower part of the spectrum is needed, the residual can have half the signal's rate: the upper
half of each frame's spectrum is dropped.

Spectra are in single precision, prediction in double: its filters cancel components up to 60 dB above the rest. Two of
the four transforms have few inputs or outputs and are computed as matrix products.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from ...model import SAMPLE_RATE_HZ, FloatArray, SingleArray
from ..signal.frames import blocks_of_frames
from ..signal.products import product

_WINDOW = round(0.025 * SAMPLE_RATE_HZ)
_HOP = _WINDOW // 2
_FFT = 3 * _HOP
_ORDER = SAMPLE_RATE_HZ // 1000 + 2
_HANN = np.hanning(_WINDOW + 1)[:-1].astype(np.float32)

_TURNS = np.exp(-2j * np.pi / _FFT * np.outer(np.arange(_ORDER + 1), np.arange(_FFT // 2 + 1)))
"""The phase factors of delays of 0, 1, 2 … `_ORDER` samples at each frequency (delays × frequencies)."""

_CORRELATING = (_TURNS.real * np.where(np.arange(_FFT // 2 + 1) % (_FFT // 2), 2, 1) / _FFT).T.copy()
"""The matrix from the power spectrum to the autocorrelation at each delay (frequencies × delays)."""


def prediction_residual(samples: FloatArray, *, decimation: int = 1) -> SingleArray:
    """The prediction residual of the signal, one value for every `decimation` (1 or 2) samples."""
    count = 1 + -(-len(samples) // _HOP)
    hop = _HOP // decimation
    total = np.zeros((count + 2, hop), dtype=np.float32)
    for block, frames in blocks_of_frames(samples, _WINDOW, count, shift=_HOP):
        filtered = _inversely_filtered(frames, 3 * hop)
        for row, part in enumerate(np.split(filtered, 3, axis=1), block.start):
            total[row : row + len(part)] += part
    return total.ravel()[hop : hop - (-len(samples) // decimation)]


def _inversely_filtered(frames: SingleArray, length: int) -> SingleArray:
    """Each frame windowed and filtered by its own prediction error filter, in `length` samples (frames × length)."""
    spectra = scipy.fft.rfft(frames * _HANN, _FFT)
    filters = _prediction_error_filters(product(_power(spectra), _CORRELATING).T.copy())
    kept = length // 2 + 1
    responses = product(filters.T, _TURNS.view(np.float64)[:, : 2 * kept]).view(np.complex128)
    responses *= spectra[:, :kept]
    filtered: SingleArray = scipy.fft.irfft(responses.astype(np.complex64), length)
    filtered *= length / _FFT
    return filtered


def _power(spectra: NDArray[np.complex64]) -> FloatArray:
    """The power spectrum in double precision."""
    power = np.abs(spectra).astype(np.float64)
    return np.square(power, out=power)


def _prediction_error_filters(autocorrelation: FloatArray) -> FloatArray:
    """The coefficients 1, a₁, a₂ … that whiten each frame (order + 1 × frames), by the Levinson-Durbin recursion."""
    error = autocorrelation[0] * (1 + 1e-9) + 1e-12  # else silence and pure tones have no solution
    coefficients = np.zeros_like(autocorrelation)
    coefficients[0] = 1.0
    for order in range(1, len(autocorrelation)):
        reflection = np.sum(coefficients[:order] * autocorrelation[order:0:-1], axis=0)
        reflection /= -error
        coefficients[1 : order + 1] += reflection * coefficients[order - 1 :: -1][:order]
        error *= 1 - reflection**2
    return coefficients
