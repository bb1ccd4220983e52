"""Stress of words that nobody has spoken, by marks, by the ends of phrases and by length."""

from understudy.acoustic.unheard import ACCENTED, MARKED, NUCLEAR, WEAK, timed_stress, usual_stress
from understudy.model import Interval, Parse, Phone, Token, Word


def _word(index: int, start_s: float, lasts_s: float = 0.2) -> Word:
    interval = Interval(start_s, start_s + lasts_s)
    return Word(index, "x", interval, (Phone("AA", interval),))


def _parse(*parts_of_speech: str) -> Parse:
    tokens = (Token(each, each, "x", "x", part, "", "", 0) for each, part in enumerate(parts_of_speech))
    return Parse(tuple(tokens), (), ())


WORDS = (_word(0, 0.0), _word(1, 0.2), _word(2, 0.4), _word(3, 1.0), _word(4, 1.2))
PARSE = _parse("NOUN", "VERB", "ADP", "DET", "NOUN")


def test_the_last_content_word_of_each_phrase_is_stressed_where_no_mark_says_otherwise() -> None:
    stressed = usual_stress(WORDS, PARSE, ())
    assert [word.prominence for word in stressed] == [ACCENTED, NUCLEAR, WEAK, WEAK, NUCLEAR]
    assert {word.focus for word in stressed} == {None}


def test_marked_words_share_the_focus_and_take_the_stress_of_their_phrase() -> None:
    stressed = usual_stress(WORDS, PARSE, {0, 2})
    assert [word.prominence for word in stressed] == [MARKED, ACCENTED, MARKED, WEAK, NUCLEAR]
    assert [word.focus for word in stressed] == [0.5, 0.0, 0.5, 0.0, 0.0]


def test_of_a_synthesizers_times_long_words_are_stressed() -> None:
    lasts_s = (0.2, 0.2, 0.5, 0.2, 0.2)
    words = tuple(_word(index, sum(lasts_s[:index]), each_s) for index, each_s in enumerate(lasts_s))
    prominences = [word.prominence or 0.0 for word in timed_stress(words, ())]
    assert max(prominences) == prominences[2]
