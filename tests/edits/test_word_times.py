"""Corrected word times: neighbours are adjusted, the order is kept, another recording is detected."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.edits.words import corrected
from understudy.model import Interval, Phone, Word
from understudy.model.edits import HeardTime, WordEdit, WordReference

AH = Phone("AH", Interval(1.0, 1.2), stress=1)
WORDS = (
    Word(0, "so", Interval(0.5, 1.0)),
    Word(1, "much", Interval(1.0, 1.4), phones=(AH, Phone("CH", Interval(1.2, 1.4)))),
    Word(2, "—"),
    Word(3, "more", Interval(1.5, 2.0)),
)
LINE_S = 2.2


def _edit(word: int, start_s: float, end_s: float) -> WordEdit:
    heard = WORDS[word].interval
    assert heard is not None
    reference = WordReference(word, WORDS[word].text)
    return WordEdit(reference, start_s=start_s, end_s=end_s, heard=HeardTime(heard.start_s, heard.end_s))


def _times_s(words: tuple[Word, ...]) -> list[tuple[float, float]]:
    return [(word.interval.start_s, word.interval.end_s) for word in words if word.interval]


def test_neighbours_give_way_and_phones_keep_their_shares() -> None:
    words, notices = corrected(WORDS, [_edit(1, 0.9, 1.7)], duration_s=LINE_S)
    assert notices == ()
    assert _times_s(words) == [(0.5, 0.9), (0.9, 1.7), (1.7, 2.0)]
    edges_s = [edge_s for phone in words[1].phones for edge_s in (phone.interval.start_s, phone.interval.end_s)]
    assert edges_s == pytest.approx([0.9, 1.3, 1.3, 1.7])


def test_a_word_cannot_push_its_neighbours_out_and_that_is_told() -> None:
    words, [notice] = corrected(WORDS, [_edit(1, 0.2, 2.1)], duration_s=LINE_S)
    assert notice.code == "edit_word_moved"
    assert "words[0]: 'much' can only be at 0.520 to 1.980 s" in notice.message
    assert _times_s(words) == [(0.5, 0.52), (0.52, 1.98), (1.98, 2.0)]


def test_two_corrected_neighbours_share_their_boundary() -> None:
    words, notices = corrected(WORDS, [_edit(0, 0.4, 1.1), _edit(1, 1.1, 1.4)], duration_s=LINE_S)
    assert notices == ()
    assert _times_s(words)[:2] == [(0.4, 1.1), (1.1, 1.4)]


def test_in_another_recording_nothing_is_corrected() -> None:
    later = WordEdit(WordReference(3, "more"), start_s=1.6, end_s=1.9, heard=HeardTime(3.0, 3.4))
    words, [notice] = corrected(WORDS, [later], duration_s=LINE_S)
    assert words == WORDS
    assert notice.code == "edit_word_heard"


def test_a_word_that_is_gone_is_told() -> None:
    edit = WordEdit(WordReference(1, "many"), start_s=1.0, end_s=1.2)
    words, [notice] = corrected(WORDS, [edit], duration_s=LINE_S)
    assert (words, notice.code) == (WORDS, "edit_word_gone")


_TIMES = st.tuples(st.floats(0, 3), st.floats(0.001, 2))


@given(st.dictionaries(st.sampled_from((0, 1, 3)), _TIMES))
def test_words_stay_in_order_and_in_the_recording(wanted: dict[int, tuple[float, float]]) -> None:
    edits = [_edit(word, start_s, start_s + lasts_s) for word, (start_s, lasts_s) in wanted.items()]
    words, _notices = corrected(WORDS, edits, duration_s=LINE_S)
    times_s = [0.0, *(edge_s for interval in _times_s(words) for edge_s in interval), LINE_S]
    assert all(earlier_s <= later_s + 1e-9 for earlier_s, later_s in pairwise(times_s))
