"""Tests of samples against tables and by hand."""

from statistics import NormalDist

import pytest

from understudy.study.comparison import Comparison
from understudy.study.scoring.samples import (
    SampleSize,
    by_group,
    group_differences,
    normality,
    plan_told,
    power_of_t,
    raters_needed,
    two_factors,
)

CELLS = {("a", "x"): [4, 6], ("a", "y"): [8, 10], ("b", "x"): [6, 8], ("b", "y"): [16, 18]}


def test_two_factors_by_hand() -> None:
    """Rows 7 and 12, columns 6 and 13, of 9.5: 50, 98 and 18 for both, over an error of 8 / 4; F = 25 is t(4) = 5."""
    values = [(value, *levels) for levels, own in CELLS.items() for value in own]
    found = {each.name: each for each in two_factors(*(list(column) for column in zip(*values, strict=True)))}
    told = {name: (each.f, each.between, each.within) for name, each in found.items()}
    assert told["first"] == pytest.approx((25, 1, 4))
    assert told["second"] == pytest.approx((49, 1, 4))
    assert told["both"] == pytest.approx((9, 1, 4))
    assert found["first"].p == pytest.approx(0.00749, abs=1e-5)


def test_of_cells_of_other_sizes_each_factor_is_beside_the_other() -> None:
    """Values that only the second factor decides, with more of one level in one row: the first decides nothing."""
    first, second = list("aaaabb" * 2), list("xxxyxyyxyyyy")
    values = [(10.0 if level == "y" else 2.0) + (-1) ** place * 0.5 for place, level in enumerate(second)]
    found = {each.name: each.p for each in two_factors(values, first, second)}
    assert found["second"] < 1e-4
    assert found["first"] > 0.2


@pytest.mark.parametrize("values", [[1.0] * 8, [1.0] * 4 + [2.0] * 4])
def test_without_variance_within_cells_there_is_no_f(values: list[float]) -> None:
    assert two_factors(values, list("aaaabbbb"), list("xxyyxxyy")) == ()


def test_groups_are_compared_by_ranks() -> None:
    """U is the number of pairs that the first has more in: 17 of 20 here, and none is tied."""
    groups = {"DE": [19, 22, 16, 29, 24], "US": [20, 11, 17, 12]}
    (found,) = group_differences(groups)
    assert found.u == sum(one > other for one in groups["DE"] for other in groups["US"]) == 17
    assert found.p == pytest.approx(2 * 7 / 126), "7 of the 126 ways to draw the groups have as large a U"
    assert by_group({"r1": 1.0, "r2": 2.0}, {"r1": "US"}) == {"US": [1.0]}


def test_normality_has_lilliefors_s_critical_value() -> None:
    """For 20 values D = .190 has p = .05 (Lilliefors 1967, table 1)."""
    quantiles = [NormalDist().inv_cdf((place + 0.5) / 20) for place in range(20)]
    skewed = [normality([2.718 ** (spread / 10 * each) for each in quantiles]) for spread in range(1, 16)]
    near = min((each for each in skewed if each), key=lambda each: abs(each.distance - 0.19))
    assert near.distance == pytest.approx(0.19, abs=0.012)
    assert near.p == pytest.approx(0.05, abs=0.025)
    even = normality(quantiles)
    assert even is not None
    assert even.p > 0.9
    assert normality([0.5] * 9) is normality([1.0, 2.0]) is None


def test_raters_are_those_of_the_tables() -> None:
    """G*Power 3.1: one-sample t 199, 34 and 15; three groups of 323, 53 and 22 (totals 969, 159, 66)."""
    assert raters_needed(Comparison.UNITS, 2) == (SampleSize(0.2, 199), SampleSize(0.5, 34), SampleSize(0.8, 15))
    assert raters_needed(Comparison.MODES, 3) == (SampleSize(0.1, 323), SampleSize(0.25, 53), SampleSize(0.4, 22))


def test_no_effect_is_found_as_often_as_the_level_says() -> None:
    assert power_of_t(0.0, 20) == pytest.approx(0.05)


def test_the_plan_is_a_sentence() -> None:
    assert "take 15 raters if it is large (d = 0.8), 34 if medium (0.5), 199 if small (0.2)" in plan_told(
        Comparison.UNITS, 2
    )
