"""Features of voice dynamics: fast or slow changes, decline, changes at loud places or between them."""

from dataclasses import replace

import numpy as np
import pytest

from understudy.acoustic.agitation.utterance_features import dynamics_features
from understudy.acoustic.agitation.voice_quality import voice_quality
from understudy.acoustic.stage import contours_of
from understudy.model import SAMPLE_RATE_HZ, Audio, Contours, FloatArray

ENERGY_STEP, PITCH_DECLINE, ENERGY_DECLINE, FLUX_WITH_ENERGY, NEAR_10_DB, BANDS = 0, 5, 6, 12, 21, slice(24, 34)
ENERGY_STEADINESS = 22
TIME_S = np.arange(2 * SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ


def voice(
    f0_hz: FloatArray | float = 150.0, *, fall: FloatArray | float = 1.0, gain_db: FloatArray | float = 0
) -> Audio:
    """Two seconds of harmonics whose amplitudes go as number to the power of -`fall`, in faint noise."""
    phase = 2 * np.pi * np.cumsum(np.broadcast_to(f0_hz, TIME_S.shape)) / SAMPLE_RATE_HZ
    samples = sum(0.1 * number**-fall * np.sin(number * phase) for number in range(1, 30))
    return Audio(10 ** (gain_db / 20) * samples + np.random.default_rng(0).normal(0, 1e-5, len(TIME_S)))


def motion(audio: Audio) -> FloatArray:
    return motion_of(audio, contours_of(audio))


def motion_of(audio: Audio, heard: Contours) -> FloatArray:
    spoken = heard.energy_db >= heard.energy_db.max() - 30
    return dynamics_features(heard, voice_quality(audio, heard.f0_hz), spoken=spoken)


def test_a_voice_that_trembles_steps_further() -> None:
    assert motion(voice(gain_db=4 * np.sin(40 * TIME_S)))[ENERGY_STEP] > motion(voice())[ENERGY_STEP] + 1


def test_pitch_and_loudness_that_fall_decline_by_as_much() -> None:
    features = motion(voice(200 * 2 ** (-TIME_S / 4), gain_db=-5 * TIME_S))
    assert features[PITCH_DECLINE] == pytest.approx(-0.5, abs=0.05)
    assert features[ENERGY_DECLINE] == pytest.approx(-10, abs=1)


def test_timbre_that_changes_where_it_is_loud_is_told_from_one_that_changes_between() -> None:
    swell = np.sin(2 * np.pi * TIME_S)
    loudly, softly = (0.3 * np.sin(40 * TIME_S) * (sign * swell > 0) + 1 for sign in (1, -1))
    for fall, sign in ((loudly, 1), (softly, -1)):
        assert sign * motion(voice(fall=fall, gain_db=6 * swell))[FLUX_WITH_ENERGY] > 0.3


def test_an_even_voice_is_near_its_loudest_most_of_the_time() -> None:
    even, swelling = (motion(voice(gain_db=range_db * np.sin(6 * TIME_S)))[NEAR_10_DB] for range_db in (2, 14))
    assert even > 0.9 > swelling + 0.2


def test_slow_swells_are_steadier_than_fast_ones() -> None:
    slow, fast = (
        motion(voice(gain_db=6 * np.sin(2 * np.pi * rate_hz * TIME_S)))[ENERGY_STEADINESS] for rate_hz in (2, 8)
    )
    assert slow > 0.95 > fast


def test_bands_that_all_swell_swell_by_a_decibel_each() -> None:
    bands = motion(voice(gain_db=5 * np.sin(6 * TIME_S)))[BANDS]
    assert bands[:5] == pytest.approx(np.ones(5), abs=0.1)


def test_neither_level_nor_length_matters() -> None:
    audio = voice(fall=1 + 0.3 * np.sin(12 * TIME_S), gain_db=5 * np.sin(6 * TIME_S))
    assert motion(Audio(audio.samples / 50)) == pytest.approx(motion(audio), abs=0.1)


def test_without_a_voice_only_bands_are_known() -> None:
    whisper = Audio(np.random.default_rng(0).normal(0, 0.05, SAMPLE_RATE_HZ))
    heard = contours_of(whisper)
    features = motion_of(whisper, replace(heard, f0_hz=np.zeros(101)))
    assert np.isnan(features).tolist() == [True] * 24 + [False] * 10
