"""Words with times and without."""

import pytest

from understudy.analysis import Options
from understudy.errors import InputError
from understudy.live.words import PHONE_S, TimedText, paced_words, perform_words, timed_words
from understudy.model import Interval
from understudy.performance import Understudy

NO = (TimedText("No,", Interval(2.0, 2.4)), TimedText("never.", Interval(2.5, 3.0)))


def test_sounds_are_spread_over_their_word(understudy: Understudy) -> None:
    no, never = timed_words(understudy, NO)
    assert [phone.label for phone in no.phones] == ["N", "OW"]
    assert no.phones[0].interval == Interval(2.0, 2.2)
    assert never.phones[-1].interval.end_s == 3.0
    assert no.spread


def test_text_takes_its_usual_time(understudy: Understudy) -> None:
    no, never = paced_words(understudy, "No, never.", 1.0)
    assert no.interval == Interval(1.0, 1.0 + 2 * PHONE_S)
    assert never.interval is not None
    assert never.interval.start_s > no.interval.end_s


def test_what_is_known_in_time_is_done_in_time_and_what_comes_too_late_is_left_out(understudy: Understudy) -> None:
    words = timed_words(understudy, NO)
    early = perform_words(understudy, words, Options(), 0.0)
    assert early.interval == Interval(2.0, 3.0)
    assert {each.lexeme for each in early.behaviors} & {"SHAKE", "NEGATION", "REJECT"}
    assert {viseme.label for viseme in early.visemes} >= {"nn", "O"}
    late = perform_words(understudy, words, Options(), 2.2)
    assert all(each.sync.start >= 2.2 for each in late.behaviors)
    assert len(late.behaviors) < len(early.behaviors)


def test_text_of_which_nothing_can_be_spoken_is_refused(understudy: Understudy) -> None:
    with pytest.raises(InputError) as raised:
        paced_words(understudy, "— …", 0.0)
    assert raised.value.code == "transcript_unspoken"
