"""Energy and MFCC against signals whose values are known by arithmetic."""

import io
from pathlib import Path

import numpy as np
import pytest
import soundfile

from understudy.acoustic.signal.spectrum import (
    ENERGY_FLOOR_DB,
    LEAST_TRUSTED_DB,
    above_background_db,
    doubts,
    energy_db,
    mel_db,
    mfcc,
)
from understudy.acoustic.stage import analyze_signal
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray
from understudy.models import Understudy

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


def words_in_noise(decibels: float) -> Audio:
    """Three seconds of tone that pauses for half of each second, in white noise so far under its mean power."""
    time_s = np.arange(3 * SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    words = np.sin(2 * np.pi * 200 * time_s) * (time_s % 1 < 0.5)
    deviation = np.sqrt(np.mean(words**2) * 10 ** (-decibels / 10))
    return Audio(words + np.random.default_rng(0).normal(0, deviation, len(words)))


@pytest.mark.parametrize("decibels", [10, 20, 30])
def test_steady_noise_is_measured(decibels: float) -> None:
    assert above_background_db(energy_db(words_in_noise(decibels))) == pytest.approx(decibels, abs=1.5)


def test_level_and_digital_silence_change_nothing() -> None:
    audio = words_in_noise(15)
    quiet = Audio(np.concatenate([np.zeros(SAMPLE_RATE_HZ), audio.samples / 30]))
    assert above_background_db(energy_db(quiet)) == pytest.approx(above_background_db(energy_db(audio)), abs=0.3)


@pytest.mark.parametrize(
    ("decibels", "codes"), [(LEAST_TRUSTED_DB - 3, ["agitation_unsure"]), (LEAST_TRUSTED_DB + 3, [])]
)
def test_only_loud_noise_is_doubted(decibels: float, codes: list[str]) -> None:
    assert [notice.code for notice in doubts(energy_db(words_in_noise(decibels)))] == codes


@pytest.mark.parametrize(("decibels", "told"), [(5, True), (25, False)])
def test_the_doubt_comes_with_what_is_heard(understudy: Understudy, decibels: float, told: bool) -> None:
    samples, rate_hz = soundfile.read(Path(__file__).parents[2] / "audio" / "figure8.flac")
    deviation = np.sqrt(np.mean(samples**2) * 10 ** (-decibels / 10))
    noisy = io.BytesIO()
    noise = np.random.default_rng(0).normal(0, deviation, len(samples))
    soundfile.write(noisy, (samples + noise) / 4, rate_hz, format="WAV")
    notices = analyze_signal(understudy.acoustic, noisy.getvalue()).notices
    assert ("agitation_unsure" in [notice.code for notice in notices]) is told
