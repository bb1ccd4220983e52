"""Hearing as the sound comes."""

import numpy as np
import pytest

from tests.acoustic.pitch.test_streaming import LINE, streamed
from understudy.acoustic.signal.spectrum import energy_db
from understudy.live.voice import StreamingVoice
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
