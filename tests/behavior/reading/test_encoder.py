"""How a line is said, taken from an utterance."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.behavior.reading.encoder import (
    FEATURES,
    MOST_PIECES,
    NEIGHBOURS,
    UNKNOWN,
    WORDS_ALONE,
    Delivery,
    Encoder,
    features_of,
    pieces_of,
)
from understudy.errors import ServiceError
from understudy.model import Affect, Agitation, LineAffect, Parse, PhraseAffect, Utterance, Word

WORDS = tuple(Word(index, text) for index, text in enumerate(["I", "never", "said", "it."]))
SILENT = Utterance(WORDS, Parse((), (), ()))


def test_words_alone_have_no_delivery() -> None:
    assert Delivery.of(SILENT) == WORDS_ALONE


def test_a_delivery_has_what_was_measured() -> None:
    affect = LineAffect(Affect(activation=0.4))
    words = tuple(replace(word, focus=share) for word, share in zip(WORDS, (0.1, 0.7, 0.1, 0.1), strict=True))
    heard = replace(SILENT, words=words, affect=affect, agitation=Agitation(low=0.1, medium=0.3, high=0.6))
    assert Delivery.of(heard) == Delivery(focus=(0.1, 0.7, 0.1, 0.1), affect=affect, loudness=0.5)


def test_a_line_without_a_clear_focus_has_none() -> None:
    words = tuple(replace(word, focus=share) for word, share in zip(WORDS, (0.3, 0.4, 0.2, 0.1), strict=True))
    assert Delivery.of(replace(SILENT, words=words)).focus is None


def test_a_focus_that_lacks_words_is_none() -> None:
    words = (*WORDS[:3], replace(WORDS[3], focus=1.0))
    assert Delivery.of(replace(SILENT, words=words)).focus is None


def test_what_is_not_known_is_told_as_nothing() -> None:
    assert not features_of(WORDS_ALONE, 4).any()
    told = features_of(Delivery(loudness=0.0), 4)
    assert (told[:, -2] == 1).all()
    assert not told[:, :-2].any()


def test_a_word_is_told_its_share_and_its_neighbours() -> None:
    told = features_of(Delivery(focus=(0.1, 0.6, 0.2, 0.1)), 4)
    known, share, relative, *around = told[2, : 3 + len(NEIGHBOURS)]
    assert (known, share) == (1, np.float32(0.2))
    assert relative == pytest.approx(1 / 3, abs=1e-5)
    assert around == pytest.approx([0.1, 0.6, 0.1, 0.0])


def test_a_word_is_told_the_affect_of_its_phrase() -> None:
    sad = Affect(-0.5, -0.4, -0.3, tones=(0, 0, 1, 0, 0, 0, 0))
    told = features_of(Delivery(affect=LineAffect(Affect(), (PhraseAffect(2, 3, sad),))), 4)
    before, after = told[1], told[3]
    assert before[7:11] == pytest.approx([1, 0, 0, 0])
    assert after[7:11] == pytest.approx([1, -0.5, -0.4, -0.3])
    assert after[11:18] == pytest.approx(sad.tones)
    assert told.shape == (4, FEATURES)


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
    with pytest.raises(ServiceError, match=r"encoder\.onnx is not a model"):
        Encoder.load(path)


def test_the_focus_draws_the_stroke(encoder: Encoder) -> None:
    words = ["I", "never", "said", "she", "took", "the", "money."]
    said, she = ((0.02, 0.02, 0.88, *(0.02,) * 4), (0.02, 0.02, 0.02, 0.88, *(0.02,) * 3))
    first, second = (encoder.read(words, Delivery(focus=shares)) for shares in (said, she))
    assert first.stroke[2] > 2 * second.stroke[2]
    assert second.stroke[3] > 2 * first.stroke[3]


def test_the_tone_decides_the_face(encoder: Encoder) -> None:
    words = ["He", "came", "home", "with", "the", "boys."]
    angry = LineAffect(Affect(0.6, -0.5, 0.5, (0.1, 0, 0, 0.9, 0, 0, 0)))
    happy = LineAffect(Affect(0.4, 0.5, 0.2, (0.1, 0.9, 0, 0, 0, 0, 0)))
    frowns, smiles = (encoder.read(words, Delivery(affect=affect)) for affect in (angry, happy))
    frown, smile = encoder.face.index("frown"), encoder.face.index("smile")
    assert frowns.face[:, frown].max() > 2 * smiles.face[:, frown].max()
    assert smiles.face[:, smile].max() > 2 * frowns.face[:, smile].max()


def test_what_is_soft_and_weary_is_smaller_and_slower(encoder: Encoder) -> None:
    words = ["We", "have", "to", "go", "on", "until", "the", "morning."]
    weary = LineAffect(Affect(-0.6, -0.3, -0.3, (0.3, 0, 0.7, 0, 0, 0, 0)))
    angry = LineAffect(Affect(0.7, -0.5, 0.5, (0.1, 0, 0, 0.9, 0, 0, 0)))
    low, high = encoder.read(words, Delivery(None, weary, -0.9)), encoder.read(words, Delivery(None, angry, 0.8))
    assert low.size < high.size
    assert low.speed < high.speed


PIECES = {
    piece: number
    for number, piece in enumerate((UNKNOWN, "un", "##believ", "##able", "believ", "'", "!", "don", "t", "e"))
}


def spelt(word: str) -> list[str]:
    names = {number: piece for piece, number in PIECES.items()}
    return [names[number] for number in pieces_of(word, PIECES)]


def test_a_word_is_its_longest_pieces_from_the_left() -> None:
    assert spelt("Unbelievable!") == ["un", "##believ", "##able", "!"]


def test_punctuation_stands_alone_and_accents_go() -> None:
    assert spelt("Don't") == ["don", "'", "t"]
    assert spelt("é") == ["e"]


def test_what_cannot_be_spelt_is_unknown_as_a_whole() -> None:
    assert spelt("unknown") == [UNKNOWN]
    assert spelt("") == [UNKNOWN]


@given(st.text(max_size=60))
def test_any_word_has_pieces(word: str) -> None:
    assert pieces_of(word, PIECES)
