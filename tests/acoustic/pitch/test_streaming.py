"""f0 of a live signal: close to the recording's, in time, whatever the chunk size."""

from pathlib import Path

import numpy as np
import pytest

from understudy.acoustic.pitch.streaming import LATEST_S, StreamingPitch
from understudy.acoustic.pitch.tracking import track_f0
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.acoustic.signal.frames import frame_count
from understudy.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray

LIMITS = AudioLimits(max_duration_s=60, max_bytes=10**7, min_sample_rate_hz=8000, max_sample_rate_hz=48000)
LINE = decode((Path(__file__).parents[2] / "audio" / "figure8.flac").read_bytes(), LIMITS)[0].samples


def streamed(samples: FloatArray, chunk: int) -> FloatArray:
    live = StreamingPitch()
    parts = [live.hear(samples[first : first + chunk]) for first in range(0, len(samples), chunk)]
    return np.concatenate([*parts, live.finish()])


def test_a_spoken_line_has_the_recordings_pitch() -> None:
    """Of frames voiced in both, 97 % within 2 %; nine in ten voiced alike, from the first word on."""
    live_hz, whole_hz = streamed(LINE, 480), track_f0(Audio(LINE))
    both = (live_hz > 0) & (whole_hz > 0)
    assert live_hz.shape == whole_hz.shape
    assert (np.abs(live_hz[both] / whole_hz[both] - 1) < 0.02).mean() > 0.97
    assert ((live_hz > 0) == (whole_hz > 0)).mean() > 0.9
    assert both.sum() > 0.85 * (whole_hz > 0).sum()


@pytest.mark.parametrize("chunk", [100, 7777, 10**6])
def test_chunks_do_not_matter(chunk: int) -> None:
    assert streamed(LINE, chunk) == pytest.approx(streamed(LINE, 480))


def test_frames_come_in_time_and_little_is_kept() -> None:
    live, count = StreamingPitch(), 0
    for first in range(0, len(LINE), 160):
        count += len(live.hear(LINE[first : first + 160]))
        assert first / SAMPLE_RATE_HZ - count * FRAME_SHIFT_S <= LATEST_S
        assert len(live._samples) < 6000


@pytest.mark.parametrize("length", [0, 1, 159, 160, 799, 2000, 2001])
def test_there_are_as_many_frames_as_in_a_recording(length: int) -> None:
    assert len(streamed(LINE[:length], 480)) == frame_count(length)


def test_silence_has_no_voice() -> None:
    assert not streamed(np.zeros(16000), 320).any()
