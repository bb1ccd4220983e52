"""How many raters are needed, against Cohen's tables and G*Power."""

import pytest

from understudy.study.comparison import Comparison
from understudy.study.power import Needed, plan_told, power_of_t, raters_needed


def test_raters_are_those_of_the_tables() -> None:
    """G*Power 3.1: one-sample t 199, 34 and 15; three groups of 323, 53 and 22 (totals 969, 159, 66)."""
    assert raters_needed(Comparison.UNITS, 2) == (Needed(0.2, 199), Needed(0.5, 34), Needed(0.8, 15))
    assert raters_needed(Comparison.MODES, 3) == (Needed(0.1, 323), Needed(0.25, 53), Needed(0.4, 22))


def test_no_effect_is_found_as_often_as_the_level_says() -> None:
    assert power_of_t(0.0, 20) == pytest.approx(0.05)


def test_the_plan_is_a_sentence() -> None:
    assert "take 15 raters if it is large (d = 0.8), 34 if medium (0.5), 199 if small (0.2)" in plan_told(
        Comparison.UNITS, 2
    )
