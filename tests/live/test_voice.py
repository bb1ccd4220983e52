"""Hearing as the sound comes."""

import numpy as np
import pytest

from tests.acoustic.pitch.test_streaming import LINE, streamed
from understudy.acoustic.signal.spectrum import energy_db
from understudy.live.voice import RECENT_FRAMES, RecentVoice, StreamingVoice
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
