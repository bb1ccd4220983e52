"""Features of vocal effort: for a brighter voice, a faster changing one, one whose timbre depends on its loudness."""

from dataclasses import replace

import numpy as np
import pytest

from understudy.acoustic.agitation.vocal_effort import effort_features
from understudy.acoustic.agitation.voice_quality import voice_quality
from understudy.acoustic.stage import contours_of
from understudy.model import SAMPLE_RATE_HZ, Audio, Contours, FloatArray

ALPHA, FLUX, PITCH_SLOPE, TILT_WITH_LOUDNESS, PITCH_WITH_LOUDNESS, SPECTRUM = 4, 12, 18, 27, 31, slice(56, 66)
TIME_S = np.arange(2 * SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ


def voice(f0_hz: FloatArray | float, fall: FloatArray | float = 1.0, loudness: FloatArray | float = 1.0) -> Audio:
    """Two seconds of harmonics whose amplitudes go as number to the power of -`fall`, in faint noise."""
    phase = 2 * np.pi * np.cumsum(np.broadcast_to(f0_hz, TIME_S.shape)) / SAMPLE_RATE_HZ
    fall = np.broadcast_to(fall, TIME_S.shape)
    samples = sum(0.1 * number**-fall * np.sin(number * phase) for number in range(1, 30))
    return Audio(loudness * samples + np.random.default_rng(0).normal(0, 1e-5, len(TIME_S)))


def effort(audio: Audio) -> FloatArray:
    heard = contours_of(audio)
    return effort_of(audio, heard)


def effort_of(audio: Audio, heard: Contours) -> FloatArray:
    quality = voice_quality(audio, heard.f0_hz)
    spoken, active = (heard.energy_db >= heard.energy_db.max() - range_db for range_db in (30, 20))
    return effort_features(heard, quality, spoken=spoken, active=active)


def test_a_brighter_voice_has_more_above_1_khz() -> None:
    assert effort(voice(150, fall=0.5))[ALPHA] > effort(voice(150, fall=1.5))[ALPHA] + 5


def test_pitch_that_climbs_an_octave_in_two_seconds_climbs_half_a_second() -> None:
    assert effort(voice(120 * 2 ** (TIME_S / 2)))[PITCH_SLOPE] == pytest.approx(0.5, abs=0.05)


def test_restless_timbre_has_more_flux() -> None:
    assert effort(voice(150, fall=1 + 0.5 * np.sin(30 * TIME_S)))[FLUX] > effort(voice(150))[FLUX] + 1


def test_timbre_and_pitch_that_go_with_loudness_are_told() -> None:
    swell = np.sin(2 * np.pi * TIME_S)
    goes_along = effort(voice(150 * 2 ** (0.1 * swell), fall=1 - 0.3 * swell, loudness=10 ** (swell / 4)))
    steady = effort(voice(150, loudness=10 ** (swell / 4)))
    for measure in (TILT_WITH_LOUDNESS, PITCH_WITH_LOUDNESS):
        assert goes_along[measure] > 0 == pytest.approx(steady[measure], abs=0.1 * goes_along[measure])


def test_shares_of_the_spectrum_are_of_all_of_it() -> None:
    shares = 10 ** (effort(voice(150))[SPECTRUM] / 10)
    assert shares.sum() == pytest.approx(1, abs=1e-3)
    assert shares[0] == shares.max()


def test_neither_level_nor_length_matters() -> None:
    audio = voice(150, fall=1 + 0.3 * np.sin(12 * TIME_S))
    known = effort(audio)
    assert effort(Audio(audio.samples / 50)) == pytest.approx(known, abs=0.05)
    assert effort(Audio(np.tile(audio.samples, 3)))[:18] == pytest.approx(known[:18], abs=0.7)


def test_without_a_voice_only_what_needs_none_is_known() -> None:
    whisper = Audio(np.random.default_rng(0).normal(0, 0.05, SAMPLE_RATE_HZ))
    heard = contours_of(whisper)
    features = effort_of(whisper, replace(heard, f0_hz=np.zeros(101)))
    assert np.isnan(features).tolist() == [True] * 12 + [False] * 2 + [True] * 18 + [False] * 34
