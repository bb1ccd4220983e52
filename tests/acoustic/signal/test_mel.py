"""Mel bands: their positions and weights; and librosa's matrices, cached between processes."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from understudy.acoustic.signal.spectrum import cepstral_basis, mel_filters


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


def test_the_basis_makes_librosas_coefficients() -> None:
    from librosa.feature import mfcc  # which takes seconds to import: not in each process that collects tests

    levels_db = np.random.default_rng(1).normal(-40, 20, (50, 40))
    theirs = mfcc(S=levels_db.T, n_mfcc=13, norm="ortho").T
    assert levels_db @ cepstral_basis(40, 13) == pytest.approx(theirs, abs=1e-9)


def test_coefficients_but_the_first_do_not_follow_the_level() -> None:
    assert cepstral_basis(40, 13)[:, 1:].sum(axis=0) == pytest.approx(0, abs=1e-12)


def test_nobody_can_change_what_all_share() -> None:
    with pytest.raises(ValueError, match="read-only"):
        mel_filters(512, bands=40, lowest_hz=80, highest_hz=8000)[0, 0] = 1


def test_librosa_is_imported_once_for_all_processes(tmp_path: Path) -> None:
    """The second process finds what the first one kept, and gets the very same."""
    code = (
        "import sys; from understudy.acoustic.signal.spectrum import cepstral_basis, mel_filters\n"
        "kept = mel_filters(512, bands=40, lowest_hz=80, highest_hz=8000), cepstral_basis(40, 13)\n"
        "print('librosa' in sys.modules, *(matrix.tobytes().hex() for matrix in kept))"
    )
    environment = os.environ | {"UNDERSTUDY_CACHE": str(tmp_path / "cache")}
    first, second = (
        subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, check=True).stdout.split()
        for _ in range(2)
    )
    assert (first[0], second[0]) == (b"True", b"False")
    assert first[1:] == second[1:]
