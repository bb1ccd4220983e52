"""Hearing as the sound comes."""

from itertools import pairwise

import numpy as np
import pytest
import soxr

from tests.acoustic.pitch.test_streaming import LINE, streamed
from tests.live.streams import CHUNK
from understudy.acoustic.signal.spectrum import energy_db
from understudy.acoustic.stage import hear_sound
from understudy.live.ear import (
    BEGIN_FRAMES,
    LONGEST_S,
    PAUSE_FRAMES,
    RECENT_FRAMES,
    SHORTEST_S,
    Ear,
    PhraseEdge,
    Phrases,
    RecentVoice,
    RunningFeeling,
    StreamingVoice,
)
from understudy.live.messages import LiveOptions
from understudy.live.models import LiveModels
from understudy.live.session import LiveSession
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray


def heard(samples: FloatArray, chunk: int) -> tuple[FloatArray, FloatArray]:
    voice = StreamingVoice()
    rows = [voice.hear(samples[first : first + chunk]) for first in range(0, len(samples), chunk)]
    rows.append(voice.finish())
    return np.concatenate([levels for levels, _ in rows]), np.concatenate([pitches for _, pitches in rows])


@pytest.mark.parametrize("chunk", [1, 320, 5000])
def test_energy_is_the_recordings(chunk: int) -> None:
    part = LINE[:12_345]
    levels_db, f0_hz = heard(part, chunk)
    assert levels_db == pytest.approx(energy_db(Audio(part)), abs=1e-3)
    assert f0_hz == pytest.approx(streamed(part, 480))


def test_little_is_kept() -> None:
    voice = StreamingVoice()
    for first in range(0, len(LINE), 640):
        voice.hear(LINE[first : first + 640])
        assert len(voice._samples) < SAMPLE_RATE_HZ / 2


def test_what_was_not_heard_is_as_usual() -> None:
    recent = RecentVoice()
    recent.hear(np.array([-30.0, -20.0, -10.0]), np.array([0.0, 100.0, 120.0]))
    contours = recent.during(0.01, 0.05)
    assert contours.energy_db.tolist() == [-20.0, -10.0, -20.0, -20.0]
    assert contours.f0_hz.tolist() == [100.0, 120.0, 110.0, 110.0]
    assert RecentVoice().during(-1.0, 0.0).f0_hz.tolist() == [0.0] * 100


def test_only_the_last_is_remembered_and_no_stretch_is_too_long() -> None:
    recent = RecentVoice()
    for _ in range(3):
        recent.hear(np.arange(RECENT_FRAMES, dtype=float), np.full(RECENT_FRAMES, 100.0))
    assert len(recent._f0_hz) == RECENT_FRAMES
    begin_s = 0.01 * 2 * RECENT_FRAMES
    assert recent.during(begin_s, begin_s + 0.02).energy_db.tolist() == [0.0, 1.0]
    assert len(recent.during(0.0, 1e9).f0_hz) < 1e5


def pitch(samples: FloatArray, rate_hz: int) -> FloatArray:
    ear, chunk = Ear(rate_hz), rate_hz // 25
    parts = [samples[first : first + chunk] for first in range(0, len(samples), chunk)]
    return np.concatenate([ear.contours(ear.resampled(part))[1] for part in parts])


@pytest.mark.parametrize("rate_hz", [8000, 22_050, 44_100, 48_000])
def test_any_rate_will_do(rate_hz: int) -> None:
    """Frames as many as at our own rate, but for those that the resampler keeps back, and the same voice in nearly all
    of them."""
    expected_hz = pitch(LINE, SAMPLE_RATE_HZ)
    f0_hz = pitch(soxr.resample(LINE, SAMPLE_RATE_HZ, rate_hz), rate_hz)
    count = min(len(f0_hz), len(expected_hz))
    assert abs(len(f0_hz) - len(expected_hz)) <= 5
    both = (f0_hz[:count] > 0) & (expected_hz[:count] > 0)
    assert (np.abs(f0_hz[:count][both] / expected_hz[:count][both] - 1) < 0.02).mean() > 0.95


def test_the_phrase_that_goes_on_is_known() -> None:
    ear = Ear(SAMPLE_RATE_HZ)
    _, f0_hz = ear.contours(LINE)
    edges = ear.phrases(f0_hz)
    assert edges[0].begins
    assert all(one.begins is not other.begins for one, other in pairwise(edges))
    assert ear.phrase_began_s == (edges[-1].at_s if edges[-1].begins else None)


def edges(*voiced: tuple[int, bool]) -> list[PhraseEdge]:
    """Of stretches of so many frames, voiced or not."""
    f0_hz = np.concatenate([np.full(count, 120.0 if is_voiced else 0.0) for count, is_voiced in voiced])
    phrases = Phrases()
    return [edge for f0 in f0_hz for edge in phrases.hear(np.array([f0]))]


def test_a_phrase_begins_with_its_first_voice_and_ends_with_its_last() -> None:
    assert edges((50, False), (100, True), (60, False)) == [PhraseEdge(0.5, begins=True), PhraseEdge(1.5, begins=False)]


def test_a_short_pause_parts_nothing_and_a_click_is_no_voice() -> None:
    assert len(edges((20, True), (PAUSE_FRAMES - 1, False), (20, True))) == 1
    assert not edges((40, False), (BEGIN_FRAMES - 1, True), (40, False))


def test_the_next_phrase_begins_anew() -> None:
    found = edges((20, True), (PAUSE_FRAMES, False), (20, True))
    assert [edge.begins for edge in found] == [True, False, True]


@pytest.fixture(scope="module")
def sound() -> FloatArray:
    time_s = np.arange(8 * SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    numbers = np.arange(1, 20)
    swell = 1.1 + np.sin(2 * np.pi * 4 * time_s)
    samples: FloatArray = swell * (np.sin(2 * np.pi * 180 * numbers * time_s[:, np.newaxis]) @ (0.05 / numbers))
    return samples


def test_nothing_is_felt_before_enough_is_heard(models: LiveModels, sound: FloatArray) -> None:
    feeling = RunningFeeling()
    feeling.hear(sound[: SAMPLE_RATE_HZ // 2])
    assert feeling.of_phrase(models.understudy.acoustic, None) is None
    assert feeling.of_phrase(models.understudy.acoustic, SHORTEST_S - 0.1) is None


def test_the_phrase_alone_is_judged_and_stays_until_the_next(models: LiveModels, sound: FloatArray) -> None:
    feeling = RunningFeeling()
    for first in range(0, 2 * SAMPLE_RATE_HZ, CHUNK):
        feeling.hear(sound[first : min(first + CHUNK, 2 * SAMPLE_RATE_HZ)])
    expected = hear_sound(models.understudy.acoustic, Audio(sound[SAMPLE_RATE_HZ : 2 * SAMPLE_RATE_HZ]))
    assert feeling.of_phrase(models.understudy.acoustic, 1.0) == expected
    assert feeling.of_phrase(models.understudy.acoustic, None) == expected
    assert feeling.of_phrase(models.understudy.acoustic, 0.1) == expected


def test_memory_does_not_grow(models: LiveModels, sound: FloatArray) -> None:
    feeling = RunningFeeling()
    feeling.hear(sound)
    latest = sound[-round(LONGEST_S * SAMPLE_RATE_HZ) :]
    assert feeling.of_phrase(models.understudy.acoustic, 100.0) == hear_sound(models.understudy.acoustic, Audio(latest))


def test_a_session_tells_how_its_voice_sounds(models: LiveModels, sound: FloatArray) -> None:
    session = LiveSession(models, LiveOptions())
    assert session.affect is None
    for first in range(0, 2 * SAMPLE_RATE_HZ, CHUNK):
        session.hear(sound[first : first + CHUNK])
    affect = session.affect
    assert affect is not None
    assert sum(affect.tones) == pytest.approx(1)
