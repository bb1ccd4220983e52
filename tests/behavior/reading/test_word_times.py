from understudy.behavior.reading.word_times import FASTEST, SLOWEST, USUAL_WORD_S, pace_of, times_s_of
from understudy.model import Interval, Parse, Utterance, Word


def utterance(*begins_s: float | None, word_s: float = 0.2) -> Utterance:
    words = (
        Word(number, "so", None if begin_s is None else Interval(begin_s, begin_s + word_s))
        for number, begin_s in enumerate(begins_s)
    )
    return Utterance(tuple(words), Parse((), (), ()))


def test_a_word_that_was_not_heard_has_the_time_of_the_one_before() -> None:
    assert times_s_of(utterance(0.4, None, 1.0)) == [0.4, 0.4, 1.0]


def test_words_of_which_none_was_heard_have_usual_times() -> None:
    assert times_s_of(utterance(None, None, None)) == [0.0, USUAL_WORD_S, 2 * USUAL_WORD_S]


def test_pauses_count_as_a_slower_pace() -> None:
    """Two words of .2 s and .5 s between them: .45 s a word, half as long again as usual."""
    assert round(pace_of(utterance(0.0, 0.7)), 6) == 1.5


def test_pace_has_bounds_and_is_usual_where_too_little_was_heard() -> None:
    assert pace_of(utterance(0.0, 9.0)) == SLOWEST
    assert pace_of(utterance(0.0, 0.05, word_s=0.05)) == FASTEST
    assert pace_of(utterance(1.0, None)) == 1.0
