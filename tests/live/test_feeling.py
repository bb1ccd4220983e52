"""The running estimate: judged when asked, from the phrase alone, kept until the next phrase says enough."""

import numpy as np
import pytest

from tests.live.streams import CHUNK
from understudy.acoustic.stage import hear_sound
from understudy.live.feeling import LONGEST_S, SHORTEST_S, RunningFeeling
from understudy.live.messages import LiveOptions
from understudy.live.models import LiveModels
from understudy.live.session import LiveSession
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray


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
