"""How a line is said, taken from an utterance."""

from dataclasses import replace

import numpy as np
import pytest

from understudy.behavior.reading.delivery import FEATURES, NEIGHBOURS, WORDS_ALONE, Delivery, features_of
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
