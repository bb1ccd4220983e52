from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.behavior.reading.decoding import (
    MOST_HELD,
    PLACE,
    PRECISE,
    STROKES_APART_S,
    Span,
    gains,
    held,
    spans_of,
    spread,
    stretches_of,
    strokes,
    usual_times_s,
)
from understudy.model import SingleArray

PRICE = 0.4


def column(*values: float) -> SingleArray:
    return np.array([[value] for value in values], np.float32).reshape(-1, 1)


def taken(gain: SingleArray, **options: list[int]) -> list[int]:
    """The strokes at the usual times of words: four words apart."""
    return strokes(gain, PRICE, usual_times_s(len(gain)), **options)


def test_nothing_is_taken_that_costs_more_than_it_gains() -> None:
    assert taken(column(0.1, 0.39, 0.2)) == []
    assert taken(column()) == []


def test_of_two_that_are_too_near_the_better_is_taken() -> None:
    assert taken(column(0.5, 0.1, 0.9, 0.1, 0.1, 0.1, 0.6)) == [2, 6]


def test_two_good_ones_beat_a_better_one_between_them() -> None:
    assert taken(column(0.8, 0.1, 0.9, 0.1, 0.8)) == [0, 4]


def test_no_stroke_falls_where_the_hands_are_to_be_still() -> None:
    assert taken(column(0.2, 0.9, 0.2), still=[1]) == []


TIMES_S = [0.0, 0.4, 0.6, 1.1, 1.45, 1.7, 2.9, 3.0, 3.2]


@given(st.lists(st.floats(0, 1, width=32), max_size=9))
def test_the_strokes_are_the_best_of_all_that_are_possible(values: list[float]) -> None:
    over = [value - PRICE for value in values]
    legal = [
        places
        for count in range(len(values) + 1)
        for places in combinations(range(len(values)), count)
        if all(TIMES_S[later] - TIMES_S[earlier] >= STROKES_APART_S for earlier, later in pairwise(places))
    ]
    best = max(sum(over[place] for place in places) for places in legal)
    chosen = strokes(column(*values), PRICE, TIMES_S[: len(values)])
    assert tuple(chosen) in legal
    assert sum(over[place] for place in chosen) == pytest.approx(best, abs=1e-5)


def test_slow_words_have_room_for_more_strokes_and_quick_ones_for_fewer() -> None:
    gain = column(*[0.9] * 9)
    counts = [len(strokes(gain, PRICE, [word * word_s for word in range(9)])) for word_s in (0.15, 0.3, 0.6)]
    assert counts == [2, 3, 5]


def test_a_stroke_earns_what_lies_within_two_words() -> None:
    assert spread(column(0, 0, 1, 0, 0, 0))[:, 0].tolist() == [1, 1, 1, 1, 1, 0]


def test_a_gain_counts_the_word_itself_and_likely_strokes_beside_the_worth() -> None:
    found = gains(column(0.5, 0.5), column(1, 0), np.array([0.0, 0.2], np.float32))
    assert found[:, 0] == pytest.approx([0.5 + PRECISE + PLACE * 0.2, 0.5 + PLACE * 0.2])


@pytest.mark.parametrize(
    ("text", "stretches"),
    [
        ("Well, I never said that. Did you?", [(0, 4), (5, 6)]),
        ("No, not now, and not here, my friend!", [(0, 2), (3, 5), (6, 7)]),
        ("one two three four five six seven eight nine ten", [(0, 4), (5, 9)]),
        ("", []),
    ],
)
def test_stretches_lie_between_punctuation_neither_short_nor_long(text: str, stretches: list[tuple[int, int]]) -> None:
    assert stretches_of(text.split()) == stretches


THRESHOLDS = {"nod": 0.3, "shake": 0.3, "tilt": 0.3, "smile": 0.3, "brows_up": 0.3}


def spans(kinds: tuple[str, ...], *rows: tuple[float, ...]) -> list[Span]:
    return list(spans_of(kinds, np.array(rows, np.float32), [(0, len(rows) - 1)], THRESHOLDS))


def test_contrary_movements_are_not_made_in_one_stretch() -> None:
    (only,) = spans(("nod", "shake"), (0.5, 0.9), (0.5, 0.9))
    assert (only.kind, only.first, only.last) == ("shake", 0, 1)


def test_two_head_movements_come_one_after_the_other() -> None:
    made = spans(("nod", "tilt"), (0.4, 0.9), (0.4, 0.5), (0.5, 0.4), (0.9, 0.4))
    assert [(each.kind, each.first, each.last) for each in made] == [("tilt", 0, 1), ("nod", 2, 3)]


def test_a_mouth_and_brows_go_together() -> None:
    made = spans(("smile", "brows_up"), (0.9, 0.8), (0.9, 0.8))
    assert {(each.kind, each.first, each.last) for each in made} == {("smile", 0, 1), ("brows_up", 0, 1)}


def test_what_is_held_goes_on_over_the_phrases_of_a_sentence_and_what_is_done_is_done_again() -> None:
    tilts = [Span("tilt", first, first + 2, 0.4, first + 1) for first in (0, 3, 6)]
    nods = [Span("nod", first, first + 2, 0.4, first) for first in (0, 3)]
    going_on = [each for each in held([*tilts, *nods], {5}) if each.kind == "tilt"]
    assert going_on == [replace(tilts[0], last=5), tilts[2]]
    assert [each for each in held([*tilts, *nods], {5}) if each.kind == "nod"] == nods


def test_nothing_is_held_for_longer_than_is_natural() -> None:
    half = MOST_HELD // 2
    smiles = [Span("smile", first, first + half - 1, 0.4, first) for first in (0, half, MOST_HELD)]
    assert [(each.first, each.last) for each in held(smiles, ())] == [
        (0, MOST_HELD - 1),
        (MOST_HELD, MOST_HELD + half - 1),
    ]
