"""Gestures get the manner of the word at their stroke; nothing else has one."""

from dataclasses import replace

import pytest

from tests.support.motion.gesture_clips import gesture
from tests.support.words.utterances import utterance
from understudy.behavior.timing.manner import with_manner
from understudy.model import Channel, Interval, Manner, Utterance, Word

SOFT, LOUD = Manner(0.8, 0.9, 0.7), Manner(1.3, 1.2, 1.1)


def spoken() -> Utterance:
    words = (Word(0, "not", Interval(1.0, 1.5)), Word(1, "—"), Word(2, "THIS", Interval(1.6, 2.2)))
    return replace(utterance("not — THIS", ""), words=words, manners=(SOFT, SOFT, LOUD))


@pytest.mark.parametrize(("stroke_s", "manner"), [(0.2, SOFT), (1.2, SOFT), (1.54, SOFT), (1.58, LOUD), (5.0, LOUD)])
def test_the_word_nearest_to_the_stroke_decides(stroke_s: float, manner: Manner) -> None:
    (made,) = with_manner((gesture("g1", stroke_s, stroke_s + 0.5),), spoken())
    assert made.manner == manner


def test_other_channels_and_words_without_a_voice_have_none() -> None:
    nod = replace(gesture("h1", 1.2, 1.7), kind=Channel.HEAD)
    assert with_manner((nod,), spoken()) == (nod,)
    beat = gesture("g1", 1.2, 1.7)
    assert with_manner((beat,), replace(spoken(), manners=())) == (beat,)
