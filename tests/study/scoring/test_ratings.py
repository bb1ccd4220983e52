"""The analysis of ratings, against figures published for R's data sets, and against raters whose taste is known."""

import random

import pytest

from understudy.errors import InputError
from understudy.study.comparison import RaterChoice
from understudy.study.scoring.ratings import Preference, rating_statistics, variance
from understudy.study.scoring.reading import Rating

# R's data set PlantGrowth (Dobson 1983): its ANOVA and TukeyHSD are on many pages.
CONTROL = [4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14]
FIRST = [4.81, 4.17, 4.41, 3.59, 5.87, 3.83, 6.03, 4.89, 4.32, 4.69]
SECOND = [6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26]

MODES = ("semantic", "prosody", "random")


def _rated(rater: str, line: str, grades: tuple[float, float, float]) -> list[Rating]:
    return [Rating(rater, line, mode, grade) for mode, grade in zip(MODES, grades, strict=True)]


def _study(tastes: tuple[float, float, float], raters: int = 30, lines: int = 5) -> list[Rating]:
    """Raters who like each mode so much, each on a scale of his own, with some chance."""
    rng, ratings = random.Random(7), []
    for rater in range(raters):
        own = rng.uniform(-1.5, 1.5)
        for line in range(lines):
            grades = [min(10, max(1, round(taste + own + rng.gauss(0, 1.5)))) for taste in tastes]
            ratings += _rated(f"r{rater}", f"l{line}", (grades[0], grades[1], grades[2]))
    return ratings


def test_the_analysis_of_variance_is_that_of_plant_growth() -> None:
    found = variance({"control": CONTROL, "first": FIRST, "second": SECOND})
    assert found.anova is not None
    assert (found.anova.between, found.anova.within) == (2, 27)
    assert found.anova.f == pytest.approx(4.846, abs=5e-4)
    assert found.anova.p == pytest.approx(0.01591, abs=5e-6)


def test_tukey_hsd_is_that_of_plant_growth() -> None:
    found = {(each.first, each.second): each for each in variance({"c": CONTROL, "1": FIRST, "2": SECOND}).differences}
    told = {pair: (-each.difference, -each.high, -each.low, each.p) for pair, each in found.items()}
    assert told["c", "1"] == pytest.approx((-0.371, -1.0622161, 0.3202161, 0.3908711), abs=2e-4)
    assert told["c", "2"] == pytest.approx((0.494, -0.1972161, 1.1852161, 0.1979960), abs=2e-4)
    assert told["1", "2"] == pytest.approx((0.865, 0.1737839, 1.5562161, 0.0120064), abs=2e-4)


def test_a_preference_is_found_and_the_others_are_alike() -> None:
    found = rating_statistics(_study((8.0, 4.0, 4.0)))
    for each in (found.graded, found.normalised):
        assert each.anova is not None
        assert (each.anova.between, each.anova.within) == (2, 87)
        assert each.anova.p < 0.001
        by_pair = {(one.first, one.second): one for one in each.differences}
        assert by_pair["semantic", "prosody"].p < 0.001
        assert by_pair["semantic", "random"].low > 0
        assert by_pair["prosody", "random"].p > 0.05
    assert found.by_grade["semantic"].first > 0.85


def test_no_preference_is_none() -> None:
    found = rating_statistics(_study((6.0, 6.0, 6.0)))
    assert found.graded.anova is not None
    assert found.graded.anova.p > 0.05


def test_ratings_are_normalised_by_the_highest_of_a_rater() -> None:
    """By hand: r1's highest is 8, r2's is 4, so that the semantic mode is 1 for both."""
    found = rating_statistics([*_rated("r1", "l", (8, 4, 2)), *_rated("r2", "l", (4, 1, 2))])
    means = {name: each.mean for name, each in found.normalised.means.items()}
    assert means == pytest.approx({"semantic": 1.0, "prosody": (0.5 + 0.25) / 2, "random": (0.25 + 0.5) / 2})
    assert {name: each.mean for name, each in found.graded.means.items()} == {
        "semantic": 6.0,
        "prosody": 2.5,
        "random": 2.0,
    }


def test_the_paper_s_degrees_of_freedom_are_those_of_61_raters() -> None:
    found = rating_statistics(_study((8.0, 4.0, 4.0), raters=61))
    assert found.graded.anova is not None
    assert (found.graded.anova.between, found.graded.anova.within) == (2, 180)


def test_equal_grades_share_the_first_place() -> None:
    found = rating_statistics([*_rated("r1", "l", (7, 7, 2)), *_rated("r2", "l", (9, 3, 3))])
    assert found.by_grade["semantic"] == Preference(0.75, 0.0)
    assert found.by_grade["prosody"] == Preference(0.25, 0.25)
    assert found.by_choice is None


def test_best_and_worst_are_those_that_were_said() -> None:
    said = [
        Rating("r1", "l", "semantic", 9, RaterChoice.BEST),
        Rating("r1", "l", "prosody", 5, RaterChoice.NEITHER),
        Rating("r1", "l", "random", 2, RaterChoice.WORST),
        Rating("r2", "l", "semantic", 6, RaterChoice.NEITHER),
        Rating("r2", "l", "prosody", 7, RaterChoice.BEST),
        Rating("r2", "l", "random", 3, RaterChoice.WORST),
    ]
    found = rating_statistics(said).by_choice
    assert found == {
        "semantic": Preference(0.5, 0.0),
        "prosody": Preference(0.5, 0.0),
        "random": Preference(0.0, 1.0),
    }


def test_lines_that_were_not_rated_whole_are_left_out() -> None:
    ratings = [*_study((8.0, 4.0, 4.0), raters=3, lines=2), Rating("r0", "broken off", "semantic", 10)]
    found = rating_statistics(ratings)
    assert (found.raters, found.lines, found.ratings, found.incomplete) == (3, 2, 18, 1)


def test_raters_who_all_agree_leave_nothing_to_compare_with() -> None:
    found = rating_statistics([*_rated("r1", "l", (9, 4, 2)), *_rated("r2", "l", (9, 4, 2))])
    assert found.graded.anova is None
    assert found.graded.differences == ()


def test_one_rater_is_too_few() -> None:
    with pytest.raises(InputError) as raised:
        rating_statistics(_rated("r1", "l", (9, 4, 2)))
    assert raised.value.code == "too_few_answers"
