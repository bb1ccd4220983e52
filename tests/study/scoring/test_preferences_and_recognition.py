"""Paired comparisons turned to the table's order, and the paper's own figures of recognised speakers."""

import pytest

from understudy.errors import InputError
from understudy.study.comparison import Comparison
from understudy.study.scoring.preferences import preference_statistics
from understudy.study.scoring.reading import PreferenceAnswer, RecognitionAnswer
from understudy.study.scoring.recognition import ALONE, BESIDE, recognition_statistics


def test_preferences_are_for_the_pair_in_the_table_s_order() -> None:
    answers = [
        PreferenceAnswer("r1", "l1", "offline", "random", -2),
        PreferenceAnswer("r1", "l2", "random", "offline", 1),
        PreferenceAnswer("r2", "l1", "random", "offline", 1),
        PreferenceAnswer("r2", "l3", "live", "live", 0),
    ]
    pair, same = preference_statistics(Comparison.WAYS, answers, {"r1": "DE", "r2": "US"}).pairs
    assert (pair.first, pair.second, pair.answers, pair.neither) == ("offline", "random", 3, 0)
    assert pair.mean == pytest.approx((-1.5 - 1) / 2), "the mean of the raters' means"
    assert pair.test is not None
    assert (pair.test.t, pair.test.freedom) == pytest.approx((-1.25 / 0.25, 1))
    assert [each.sizes for each in pair.groups] == [(1, 1)]
    assert (same.first, same.second, same.mean, same.wilcoxon_p) == ("live", "live", 0, None)


def _named(right: int, raters: int, *, beside: bool) -> list[RecognitionAnswer]:
    return [RecognitionAnswer(f"r{n}", "l", "JL", "JL" if n < right else "MR", beside) for n in range(raters)]


def test_recognition_has_the_paper_s_figures() -> None:
    """NGS §3.5: 69 % of 26 subjects, t(25) = 2.083, p < .05; side by side 88 %, t(25) = 6.019, p < .001."""
    found = recognition_statistics([*_named(18, 26, beside=False), *_named(23, 26, beside=True)])
    alone, beside = found.tests[ALONE], found.tests[BESIDE]
    assert alone.test is not None
    assert beside.test is not None
    assert (alone.right, alone.test.t, alone.test.freedom) == pytest.approx((0.69, 2.083, 25), abs=0.005)
    assert alone.test.p < 0.05
    assert (beside.right, beside.test.t) == pytest.approx((0.88, 6.019), abs=0.005)
    assert beside.test.p < 0.001
    assert alone.binomial_p == pytest.approx(2 * 0.0378, abs=0.001), "the tail of 18 or more of 26 heads, twice"
    assert alone.taken == {"JL as JL": 18, "JL as MR": 8}


def test_one_rater_is_too_few() -> None:
    with pytest.raises(InputError, match="1 raters"):
        preference_statistics(Comparison.WAYS, [PreferenceAnswer("r1", "l", "live", "random", 1)])
    with pytest.raises(InputError, match="1 raters"):
        recognition_statistics(_named(0, 1, beside=False))
