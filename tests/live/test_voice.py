"""Hearing as the sound comes."""

import numpy as np
import pytest
import soxr

from tests.acoustic.pitch.test_streaming import LINE, streamed
from understudy.acoustic.signal.spectrum import energy_db
from understudy.live.voice import StreamingVoice
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray


def heard(samples: FloatArray, rate_hz: int, chunk: int) -> tuple[FloatArray, FloatArray]:
    voice = StreamingVoice(rate_hz)
    rows = [voice.hear(samples[first : first + chunk]) for first in range(0, len(samples), chunk)]
    rows.append(voice.finish())
    return np.concatenate([levels for levels, _ in rows]), np.concatenate([pitches for _, pitches in rows])


@pytest.mark.parametrize("chunk", [1, 320, 5000])
def test_energy_is_the_recordings(chunk: int) -> None:
    part = LINE[:12_345]
    levels_db, f0_hz = heard(part, SAMPLE_RATE_HZ, chunk)
    assert levels_db == pytest.approx(energy_db(Audio(part)), abs=1e-3)
    assert f0_hz == pytest.approx(streamed(part, 480))


@pytest.mark.parametrize("rate_hz", [8000, 22_050, 44_100, 48_000])
def test_any_rate_will_do(rate_hz: int) -> None:
    """Frames as many as of the recording, but for the resampler's end, and the same voice in nearly all of them."""
    resampled = soxr.resample(LINE, SAMPLE_RATE_HZ, rate_hz)
    _, expected_hz = heard(LINE, SAMPLE_RATE_HZ, 640)
    _, f0_hz = heard(resampled, rate_hz, rate_hz // 25)
    count = min(len(f0_hz), len(expected_hz))
    assert abs(len(f0_hz) - len(expected_hz)) <= 1
    both = (f0_hz[:count] > 0) & (expected_hz[:count] > 0)
    assert (np.abs(f0_hz[:count][both] / expected_hz[:count][both] - 1) < 0.02).mean() > 0.95


def test_little_is_kept() -> None:
    voice = StreamingVoice(SAMPLE_RATE_HZ)
    for first in range(0, len(LINE), 640):
        voice.hear(LINE[first : first + 640])
        assert len(voice._samples) < SAMPLE_RATE_HZ / 2
