"""librosa's Mel filters and cepstral coefficients, as matrices by which a spectrum is multiplied.

The scale is Slaney's (Auditory Toolbox, 1998), linear up to 1 kHz and logarithmic beyond; filters are triangles of area
1 over hertz. Both are constants of librosa's, and importing librosa takes longer than analysing a line, and 180 MB
(docs/measurements/speed.md): so it is imported only if a matrix is not cached (`understudy.cache`).
"""

from collections.abc import Callable
from functools import cache
from importlib.metadata import version

import numpy as np

from ...cache import Cache
from ...model import SAMPLE_RATE_HZ, FloatArray


@cache
def mel_filters(transform_samples: int, *, bands: int, lowest_hz: float, highest_hz: float) -> FloatArray:
    """The filters (bands, 1 + transform_samples // 2) over the bins of a power spectrum, for bands of equal width on
    the Mel scale from `lowest_hz` to `highest_hz`; read-only."""

    def make() -> FloatArray:
        from librosa.filters import mel

        filters: FloatArray = mel(
            sr=SAMPLE_RATE_HZ,
            n_fft=transform_samples,
            n_mels=bands,
            fmin=lowest_hz,
            fmax=highest_hz,
            dtype=np.float64,
        )
        return filters

    return _kept(f"mel_filters_{transform_samples}_{bands}_{lowest_hz:g}_{highest_hz:g}", make)


@cache
def cepstral_basis(bands: int, coefficients: int) -> FloatArray:
    """The matrix from levels (…, bands) to MFCC 0 to `coefficients` - 1, shape (bands, coefficients); read-only.

    MFCC are linear in the levels, so its rows are the MFCC of each band alone.
    """

    def make() -> FloatArray:
        from librosa.feature import mfcc

        basis: FloatArray = mfcc(S=np.eye(bands), n_mfcc=coefficients, dct_type=2, norm="ortho").T
        return np.ascontiguousarray(basis)

    return _kept(f"cepstral_basis_{bands}_{coefficients}", make)


def _kept(name: str, make: Callable[[], FloatArray]) -> FloatArray:
    matrix = Cache.of_environment().kept(name, (), make, made_with=f"librosa {version('librosa')}")
    matrix.setflags(write=False)
    return matrix
