"""Mel bands: where they lie, how they share the spectrum out, and that librosa, which has the same, agrees."""

import numpy as np
import pytest

from understudy.acoustic.signal.mel import mel_filters


def test_each_band_weighs_a_flat_spectrum_the_same() -> None:
    filters = mel_filters(8192, bands=20, lowest_hz=60, highest_hz=7600)
    assert filters.shape == (20, 4097)
    assert filters.sum(axis=1) * 16_000 / 8192 == pytest.approx(1, rel=1e-3)


def test_bands_are_even_in_hertz_below_a_kilohertz_and_in_octaves_above() -> None:
    peaks_hz = mel_filters(65_536, bands=40, lowest_hz=0, highest_hz=8000).argmax(axis=1) * 16_000 / 65_536
    low, high = peaks_hz[peaks_hz < 990], peaks_hz[peaks_hz > 1010]
    assert np.diff(low) == pytest.approx(np.diff(low)[0], abs=0.5)
    assert np.diff(np.log(high)) == pytest.approx(np.diff(np.log(high))[0], abs=1e-3)


def test_nothing_outside_is_heard() -> None:
    bins_hz = np.arange(257) * 16_000 / 512
    heard = mel_filters(512, bands=10, lowest_hz=300, highest_hz=3400).sum(axis=0) > 0
    assert not heard[(bins_hz <= 300) | (bins_hz >= 3400)].any()
    assert heard[(bins_hz > 320) & (bins_hz < 3380)].all()


@pytest.mark.parametrize(("bands", "lowest_hz", "highest_hz"), [(40, 80, 8000), (10, 60, 7600)])
def test_librosa_has_the_same(bands: int, lowest_hz: float, highest_hz: float) -> None:
    from librosa.filters import mel

    theirs = mel(sr=16_000, n_fft=512, n_mels=bands, fmin=lowest_hz, fmax=highest_hz, dtype=np.float64)
    ours = mel_filters(512, bands=bands, lowest_hz=lowest_hz, highest_hz=highest_hz)
    assert ours == pytest.approx(theirs, abs=1e-15)
