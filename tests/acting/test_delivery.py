"""How a line is said, taken from an utterance."""

from dataclasses import replace

from understudy.acting.delivery import WORDS_ALONE, Delivery
from understudy.model import Affect, Agitation, LineAffect, Parse, Utterance, Word

WORDS = tuple(Word(index, text) for index, text in enumerate(["I", "never", "said", "it."]))
SILENT = Utterance(WORDS, Parse((), (), ()))


def test_words_alone_have_no_delivery() -> None:
    assert Delivery.of(SILENT) == WORDS_ALONE


def test_a_delivery_has_what_was_measured() -> None:
    affect = LineAffect(Affect(activation=0.4))
    words = tuple(replace(word, focus=share) for word, share in zip(WORDS, (0.1, 0.7, 0.1, 0.1), strict=True))
    heard = replace(SILENT, words=words, affect=affect, agitation=Agitation(low=0.1, medium=0.3, high=0.6))
    assert Delivery.of(heard) == Delivery(focus=(0.1, 0.7, 0.1, 0.1), affect=affect, loudness=0.5)


def test_a_focus_that_lacks_words_is_none() -> None:
    words = (*WORDS[:3], replace(WORDS[3], focus=1.0))
    assert Delivery.of(replace(SILENT, words=words)).focus is None
