"""The transforms are SciPy's, to the last bit, and do not import `scipy.fft`."""

import subprocess
import sys

import numpy as np
import pytest
import scipy.fft

from understudy.acoustic.signal.fourier import dct1, irfft, rfft

PRECISIONS = pytest.mark.parametrize("precision", [np.float32, np.float64])


def rows(precision: type[np.floating], length: int = 300) -> np.ndarray:
    return np.random.default_rng(1).standard_normal((7, length)).astype(precision)


@PRECISIONS
@pytest.mark.parametrize("length", [None, 256, 300, 512, 401])
def test_spectra_are_scipys(precision: type[np.floating], length: int | None) -> None:
    found = rfft(rows(precision), length)
    assert np.array_equal(found, scipy.fft.rfft(rows(precision), length))
    assert found.dtype == np.result_type(precision, np.complex64)


@PRECISIONS
@pytest.mark.parametrize("length", [298, 256, 401])
def test_signals_are_scipys(precision: type[np.floating], length: int) -> None:
    spectra = scipy.fft.rfft(rows(precision))
    assert np.array_equal(irfft(spectra, length), scipy.fft.irfft(spectra, length))


@PRECISIONS
def test_cosine_transforms_are_scipys_and_leave_their_input_alone(precision: type[np.floating]) -> None:
    before = rows(precision)
    assert np.array_equal(dct1(before), scipy.fft.dct(before, type=1))
    assert np.array_equal(before, rows(precision))


def test_scipy_fft_is_not_imported_and_can_be_imported_afterwards() -> None:
    code = (
        "import sys, understudy.acoustic.stage; assert 'scipy.fft' not in sys.modules; "
        "import numpy, scipy.fft; from understudy.acoustic.signal.fourier import rfft; "
        "ones = numpy.ones((2, 8)); assert numpy.array_equal(rfft(ones), scipy.fft.rfft(ones))"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
