"""Noise behind speech: estimated from the faintest frames, with a notice when it is louder than in the training
data."""

import io
from pathlib import Path

import numpy as np
import pytest
import soundfile

from understudy.acoustic.signal.background import LEAST_TRUSTED_DB, above_background_db, doubts
from understudy.acoustic.signal.spectrum import energy_db
from understudy.acoustic.stage import analyze_signal
from understudy.model import SAMPLE_RATE_HZ, Audio
from understudy.models import Understudy


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
