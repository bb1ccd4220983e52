"""Energy and MFCC against signals whose values are known by arithmetic."""

import numpy as np
import pytest

from understudy.acoustic.signal.spectrum import ENERGY_FLOOR_DB, energy_db, mel_db, mfcc
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray

HAMMING = 0.54 - 0.46 * np.cos(2 * np.pi * np.arange(512) / 512)


def noise(seconds: float, seed: int = 0) -> FloatArray:
    return np.random.default_rng(seed).normal(0, 0.1, round(seconds * SAMPLE_RATE_HZ))


def test_energy_of_a_constant_is_the_windows_energy() -> None:
    energy = energy_db(Audio(np.full(SAMPLE_RATE_HZ, 0.5)))
    assert energy[50] == pytest.approx(10 * np.log10(np.sum((0.5 * HAMMING) ** 2)))


def test_energy_of_digital_silence_is_the_floor() -> None:
    assert np.all(energy_db(Audio(np.zeros(8000))) == ENERGY_FLOOR_DB)


def test_energy_follows_the_gain() -> None:
    samples = noise(1.0)
    assert energy_db(Audio(samples * 0.1)) == pytest.approx(energy_db(Audio(samples)) - 20)


def test_a_click_is_loudest_in_the_frame_centred_on_it() -> None:
    samples = np.zeros(SAMPLE_RATE_HZ)
    samples[round(0.370 * SAMPLE_RATE_HZ)] = 1.0
    assert np.argmax(energy_db(Audio(samples))) == 37


@pytest.mark.parametrize("count", [1, 159, 160, 511, 512, 16_000, 16_159])
def test_every_contour_has_a_frame_each_ten_milliseconds(count: int) -> None:
    audio = Audio(noise(2.0)[:count])
    assert energy_db(audio).shape == (1 + count // 160,)
    assert mfcc(mel_db(audio)).shape == (1 + count // 160, 12)


def test_mfcc_ignore_the_recording_level() -> None:
    samples = noise(1.0)
    assert mfcc(mel_db(Audio(samples * 0.003))) == pytest.approx(mfcc(mel_db(Audio(samples))), abs=1e-4)


def test_the_first_coefficient_tells_low_from_high() -> None:
    time_s = np.arange(SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    low, high = (mfcc(mel_db(Audio(np.sin(2 * np.pi * f_hz * time_s))))[50, 0] for f_hz in (200, 6000))
    assert low > 0 > high


def test_mfcc_of_silence_are_zero() -> None:
    assert np.all(mfcc(mel_db(Audio(np.zeros(8000)))) == pytest.approx(0))


def test_mfcc_agree_with_librosas_own() -> None:
    from librosa.feature import mfcc as reference

    samples = noise(1.0)
    theirs = reference(
        y=samples, sr=SAMPLE_RATE_HZ, n_mfcc=13, n_fft=512, hop_length=160, n_mels=40, fmin=80, pad_mode="constant"
    )
    assert mfcc(mel_db(Audio(samples))) == pytest.approx(theirs[1:].T, abs=1e-3)


def test_mfcc_do_not_follow_noise_far_under_the_voice() -> None:
    time_s = np.arange(SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    tone, hiss = np.sin(2 * np.pi * 500 * time_s), noise(1.0) * 1e-3
    assert np.max(np.abs(mfcc(mel_db(Audio(tone + hiss))) - mfcc(mel_db(Audio(tone))))) < 1
    assert np.max(np.abs(mfcc(mel_db(Audio(tone + hiss)), range_db=120) - mfcc(mel_db(Audio(tone)), range_db=120))) > 10
