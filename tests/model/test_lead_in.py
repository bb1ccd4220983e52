"""A lead-in shifts all times of the recording equally, to the millisecond."""

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from tests.support.words.by_hand import FIGURE_8, spoken, utterance
from understudy.model import Filler, Interval, Word
from understudy.model.lead_in import later_word, with_lead_in


@given(st.integers(0, 3000), st.integers(0, 5000))
def test_all_times_are_later_by_the_lead_in(lead_in_ms: int, start_ms: int) -> None:
    words = spoken(FIGURE_8, start_s=start_ms / 1000, word_s=0.123)
    heard = replace(utterance(words), fillers=(Filler("um", Interval(0.05, 0.1)),))
    later = with_lead_in(heard, lead_in_ms / 1000)
    assert later.lead_in_s == lead_in_ms / 1000
    assert heard.duration_s is not None
    assert later.duration_s is not None
    assert abs(later.duration_s - heard.duration_s - lead_in_ms / 1000) < 1e-6
    assert later.fillers[0].interval.start_s == round(0.05 + lead_in_ms / 1000, 6)
    for word, moved in zip(words, later.words, strict=True):
        assert word.interval is not None
        assert moved.interval is not None
        assert abs(moved.interval.start_s - word.interval.start_s - lead_in_ms / 1000) < 1e-6
        gaps = [phone.interval.start_s - word.interval.start_s for phone in word.phones]
        moved_gaps = [phone.interval.start_s - moved.interval.start_s for phone in moved.phones]
        assert max(abs(a - b) for a, b in zip(gaps, moved_gaps, strict=True)) < 2e-6
        assert replace(moved, interval=word.interval, phones=word.phones) == word
    back = with_lead_in(later, 0.0)
    assert back.lead_in_s == 0
    pairs = zip(words, back.words, strict=True)
    assert all(abs(a.interval.end_s - b.interval.end_s) < 1e-5 for a, b in pairs if a.interval and b.interval)


def test_without_a_lead_in_and_without_times_nothing_moves() -> None:
    heard = utterance(spoken(FIGURE_8))
    assert with_lead_in(heard, 0.0) is heard
    assert later_word(Word(0, "λόγος"), 1.0) == Word(0, "λόγος")
