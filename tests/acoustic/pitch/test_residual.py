"""The prediction residual of signals whose source is known."""

import numpy as np
import pytest

from understudy.acoustic.pitch.residual import prediction_residual
from understudy.model import SAMPLE_RATE_HZ, FloatArray


def resonant_pulses(period: int = 160, formant_hz: float = 900.0) -> FloatArray:
    """Half a second of pulses through one resonance."""
    decay, turn = 0.97, 2 * np.pi * formant_hz / SAMPLE_RATE_HZ
    times = np.arange(400)
    response = decay**times * np.cos(turn * times)
    pulses = np.zeros(SAMPLE_RATE_HZ // 2)
    pulses[80::period] = 1.0
    return np.convolve(pulses, response)[: len(pulses)]


def test_pulses_are_freed_of_their_resonance() -> None:
    voice = resonant_pulses()
    residual = prediction_residual(voice)[1600:-1600].reshape(-1, 160)
    strongest = np.sort(np.abs(residual), axis=1)[:, ::-1]
    assert (strongest[:, :8] ** 2).sum() > 0.9 * (residual**2).sum()
    assert (np.sort(np.abs(voice[1600:-1600].reshape(-1, 160)), axis=1)[:, -8:] ** 2).sum() < 0.9 * (
        voice[1600:-1600] ** 2
    ).sum()


def test_at_half_the_rate_it_is_the_same_below_the_half_band() -> None:
    voice = resonant_pulses() + np.random.default_rng(0).normal(0, 1e-3, 8000)
    whole, half = prediction_residual(voice), prediction_residual(voice, decimation=2)
    spectra = [np.abs(np.fft.rfft(each * np.hanning(len(each)))) * scale for each, scale in ((whole, 0.5), (half, 1))]
    np.testing.assert_allclose(spectra[1][:1750], spectra[0][:1750], atol=0.02 * spectra[0].max())


@pytest.mark.parametrize("length", [1, 2, 199, 200, 201, 8001])
def test_it_is_as_long_as_the_signal(length: int) -> None:
    samples = np.random.default_rng(0).normal(size=length)
    assert len(prediction_residual(samples)) == length
    assert len(prediction_residual(samples, decimation=2)) == -(-length // 2)
