"""The listeners' network: one value a word, whatever the level, and what a file that is none gives."""

from pathlib import Path

import numpy as np
import pytest

from understudy.acoustic.focus.listeners import Listeners
from understudy.errors import ServiceError
from understudy.files import resource_folder
from understudy.model import SAMPLE_RATE_HZ, Audio, Interval, Word

INTERVALS = tuple(Interval(0.2 + 0.4 * place, 0.5 + 0.4 * place) for place in range(5))


@pytest.fixture(scope="module")
def listeners() -> Listeners:
    return Listeners.load(resource_folder("models") / "focus" / "emphases.onnx")


def voice(loud: int | None = None) -> Audio:
    """Five buzzes of a falling pitch, one of them louder and higher."""
    times_s = np.arange(int(2.4 * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    samples = np.random.default_rng(0).normal(0, 1e-4, len(times_s))
    for place, interval in enumerate(INTERVALS):
        inside = (times_s >= interval.start_s) & (times_s < interval.end_s)
        pitch_hz = 120.0 - 4 * place + 50 * (place == loud)
        buzz = sum(np.sin(2 * np.pi * pitch_hz * harmonic * times_s[inside]) / harmonic for harmonic in range(1, 20))
        samples[inside] += (0.02, 0.06)[place == loud] * buzz
    return Audio(samples)


@pytest.mark.parametrize("loud", range(1, 4))
def test_a_louder_and_higher_word_is_more_emphasised_than_where_it_is_not(listeners: Listeners, loud: int) -> None:
    assert listeners.log_odds(voice(loud), INTERVALS)[loud] > listeners.log_odds(voice(), INTERVALS)[loud] + 0.3


def test_the_level_of_the_recording_does_not_matter(listeners: Listeners) -> None:
    heard = voice(2)
    quiet = Audio(heard.samples * 0.1)
    assert listeners.log_odds(quiet, INTERVALS) == pytest.approx(listeners.log_odds(heard, INTERVALS), abs=1e-3)


def test_words_without_times_and_recordings_without_words_have_no_value(listeners: Listeners) -> None:
    words = (Word(0, "so", INTERVALS[0]), Word(1, "—"), Word(2, "it", INTERVALS[2]))
    assert set(listeners.heard(voice(), words)) == {0, 2}
    assert listeners.heard(voice(), (Word(0, "—"),)) == {}


def test_silence_and_a_recording_shorter_than_its_words_are_heard(listeners: Listeners) -> None:
    assert np.isfinite(listeners.log_odds(Audio(np.zeros(800)), INTERVALS)).all()


def test_a_file_that_is_no_such_model_is_refused(tmp_path: Path) -> None:
    (tmp_path / "text.onnx").write_bytes(b"not a model")
    for name in ("gone.onnx", "text.onnx"):
        with pytest.raises(ServiceError) as caught:
            Listeners.load(tmp_path / name)
        assert caught.value.code == "model_unreadable"
