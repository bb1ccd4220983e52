"""The mouth by sound alone."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from tests.acoustic.pitch.test_streaming import LINE
from understudy.errors import ServiceError
from understudy.files import resource_folder
from understudy.live.mouth import MouthModel, MouthShape, StreamingMouth
from understudy.model import SAMPLE_RATE_HZ
from understudy.model.tables import OPENINGS

MODEL = MouthModel.load(resource_folder("models") / "live" / "mouth.npz")


def shapes(chunk: int) -> list[MouthShape]:
    mouth = StreamingMouth(MODEL)
    return [shape for first in range(0, len(LINE), chunk) for shape in mouth.hear(LINE[first : first + chunk])]


def test_a_line_opens_and_closes_it() -> None:
    found = shapes(640)
    assert {shape.viseme for shape in found} <= set(OPENINGS)
    assert max(shape.opening for shape in found) > 0.5
    assert any(shape.viseme == "sil" for shape in found)
    assert all(one.at_s < other.at_s for one, other in pairwise(found))


def test_chunks_do_not_matter() -> None:
    assert shapes(100) == shapes(5000)


def test_silence_is_silence() -> None:
    mouth = StreamingMouth(MODEL)
    assert mouth.hear(np.zeros(SAMPLE_RATE_HZ)) == ()
    told = [*mouth.hear(LINE), *mouth.hear(np.zeros(SAMPLE_RATE_HZ))]
    assert told[-1].viseme == "sil"


def test_a_hiss_is_an_s_and_no_vowel() -> None:
    """White noise with its low half taken away."""
    noise = 0.3 * np.random.default_rng(0).standard_normal(SAMPLE_RATE_HZ)
    spectrum = np.fft.rfft(noise)
    spectrum[: len(spectrum) // 2] *= 0.01
    found = StreamingMouth(MODEL).hear(np.fft.irfft(spectrum))
    assert {shape.viseme for shape in found[1:]} <= {"SS", "CH", "FF"}


def test_a_broken_model_is_told(tmp_path: Path) -> None:
    (tmp_path / "mouth.npz").write_bytes(b"nothing")
    with pytest.raises(ServiceError, match="not a model of the mouth"):
        MouthModel.load(tmp_path / "mouth.npz")
    np.savez(tmp_path / "mouth.npz", visemes=np.array(["sil"]), weights=np.zeros((3, 1)), bias=np.zeros(1))
    with pytest.raises(ServiceError, match="other measures"):
        MouthModel.load(tmp_path / "mouth.npz")
