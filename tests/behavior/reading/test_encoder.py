"""The shipped encoder, on plain sentences on which all directors would agree."""

from pathlib import Path

import numpy as np
import pytest

from understudy.behavior.reading.encoder import MOST_PIECES, Encoder
from understudy.errors import ServiceError

MODEL = Path(__file__).resolve().parents[3] / "models" / "acting" / "encoder.onnx"


@pytest.fixture(scope="module")
def encoder() -> Encoder:
    return Encoder.load(MODEL)


@pytest.mark.parametrize(
    ("text", "word", "family"),
    [
        ("There is absolutely no sugar in this tea.", 3, "negation"),
        ("The fish I caught was this enormous!", 6, "size_big"),
        ("Where on earth have you put my keys?", 7, "question"),
        ("Get out of here and stay away from me!", 1, "away"),
    ],
)
def test_plain_sentences_are_read_as_anyone_would(encoder: Encoder, text: str, word: int, family: str) -> None:
    reading = encoder.read(text.split())
    best = [encoder.families[place] for place in np.argsort(-reading.nearby[word])[:4]]
    assert family in best


def test_words_in_context_are_not_words_alone(encoder: Encoder) -> None:
    denies = encoder.read(["I", "have", "never", "seen", "her", "in", "my", "whole", "life."])
    asks = encoder.read(["Why", "can't", "we", "just", "go", "home", "for", "once?"])
    negation = encoder.families.index("negation")
    assert denies.nearby[:, negation].max() > 2 * asks.nearby[:, negation].max()


def test_every_value_is_a_likelihood_and_the_same_each_time(encoder: Encoder) -> None:
    words = ["Well,", "uh,", "that", "is", "—", "how", "shall", "I", "put", "it", "—", "complicated."]
    reading = encoder.read(words)
    for values in (reading.at_word, reading.nearby, reading.head, reading.face):
        assert len(values) == len(words)
        assert ((values >= 0) & (values <= 1)).all()
    assert (encoder.read(words).nearby == reading.nearby).all()


def test_no_words_and_words_beyond_the_longest_line(encoder: Encoder) -> None:
    assert encoder.read([]).nearby.shape == (0, len(encoder.families))
    reading = encoder.read(["never"] * (MOST_PIECES + 40))
    assert reading.nearby[MOST_PIECES - 1].max() > 0
    assert (reading.nearby[MOST_PIECES:] == 0).all()


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04 broken", b"not numpy"])
def test_a_broken_file_is_told(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "encoder.onnx"
    path.write_bytes(content)
    with pytest.raises(ServiceError, match=r"encoder\.onnx is no model"):
        Encoder.load(path)
