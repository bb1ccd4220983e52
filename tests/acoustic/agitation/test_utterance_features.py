"""Features of utterances: from frames near the loudest, independent of level and length, NaN without a voice."""

import numpy as np
import pytest

from tests.support.words.measured import measured
from understudy.acoustic.agitation.utterance_features import full_features, paper_features
from understudy.model import SAMPLE_RATE_HZ, Audio, Contours

PITCH = 40
"""Where the median of f0, in octaves above 1 Hz, stands in the full set."""

DECLINE = slice(120, 125)


def contours(energy_db: np.ndarray, mfcc: np.ndarray) -> Contours:
    return Contours(energy_db, f0_hz=np.zeros(len(energy_db)), mfcc=mfcc, mel_db=np.zeros((len(mfcc), 40), np.float32))


def voice(f0_hz: float = 150.0, seconds: float = 1.0) -> Audio:
    time_s = np.arange(round(seconds * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    numbers = np.arange(1, 25)
    swell = 1.1 + np.sin(2 * np.pi * 4 * time_s)
    samples = swell * (np.sin(2 * np.pi * f0_hz * numbers * time_s[:, None]) @ (0.1 / numbers))
    return Audio(samples + np.random.default_rng(0).normal(0, 1e-4, len(samples)))


def test_only_frames_near_the_loudest_speak_for_the_voice() -> None:
    mfcc = np.repeat([[1.0] * 12, [5.0] * 12], [3, 10], axis=0)
    energy_db = np.repeat([0.0, -20.1], [3, 10])
    assert paper_features(contours(energy_db, mfcc)) == pytest.approx(np.ones(12))


def test_the_full_set_begins_with_the_papers() -> None:
    heard = measured(voice())
    assert full_features(*heard)[:12] == pytest.approx(paper_features(heard[0]))


def test_an_octave_higher_is_one_more() -> None:
    low, high = (full_features(*measured(audio))[PITCH] for audio in (voice(110), voice(220)))
    assert high - low == pytest.approx(1, abs=0.02)


def test_length_changes_little() -> None:
    """But for the decline, a line through a few swells, whose ends tilt it."""
    short, long = (full_features(*measured(audio)) for audio in (voice(seconds=2), voice(seconds=6)))
    assert np.delete(long, DECLINE) == pytest.approx(np.delete(short, DECLINE), abs=1.0)


def test_swells_are_counted_as_syllables() -> None:
    audio = voice(seconds=5)
    assert full_features(*measured(audio))[38] == pytest.approx(4, abs=0.5)


def test_a_whisper_has_no_pitch_and_says_so() -> None:
    whisper = Audio(np.random.default_rng(0).normal(0, 0.05, SAMPLE_RATE_HZ))
    features = full_features(*measured(whisper, np.zeros(101)))
    assert np.isnan(features[PITCH])
    assert features[39] == 0
    assert not np.isnan(features[:39]).any()
