"""Orders that are balanced over raters."""

from collections import Counter
from itertools import pairwise

import pytest

from understudy.study.making.ordering import rater_orders, williams_square


@pytest.mark.parametrize("count", range(1, 13))
def test_each_thing_is_in_each_place_equally_often(count: int) -> None:
    rows = williams_square(count)
    assert all(sorted(row) == list(range(count)) for row in rows)
    assert set(Counter((place, thing) for row in rows for place, thing in enumerate(row)).values()) == {
        len(rows) // count
    }


@pytest.mark.parametrize("count", range(2, 13))
def test_each_thing_comes_after_each_other_equally_often(count: int) -> None:
    rows = williams_square(count)
    follows = Counter(pair for row in rows for pair in pairwise(row))
    assert len(follows) == count * (count - 1)
    assert len(set(follows.values())) == 1


def test_three_clips_are_seen_in_all_six_orders() -> None:
    assert sorted(williams_square(3)) == [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]


@pytest.mark.parametrize(("lines", "clips"), [(5, 3), (11, 2), (6, 3), (1, 2), (4, 3)])
def test_each_line_has_each_order_of_its_clips_equally_often(lines: int, clips: int) -> None:
    raters = rater_orders(lines, clips)
    assert all(sorted(line for line, _order in rater) == list(range(lines)) for rater in raters)
    orders = Counter(pair for rater in raters for pair in rater)
    assert len(orders) == lines * len(williams_square(clips))
    assert len(set(orders.values())) == 1


def test_a_rater_does_not_see_the_clips_in_one_order_alone() -> None:
    assert all(len({order for _line, order in rater}) > 1 for rater in rater_orders(5, 3))
