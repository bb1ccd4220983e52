"""The analysis of comparisons: Student's own data, a χ² by hand, and raters whose taste is known."""

import random

import pytest

from understudy.errors import InputError
from understudy.study.comparison import DIMENSIONS
from understudy.study.scoring.choices import choice_statistics
from understudy.study.scoring.reading import Understanding, Verdict
from understudy.study.scoring.samples import one_sample_t

# The additional hours of sleep by the second drug over the first (Student 1908): t(9) = 4.0621, p = .002833.
SLEEP_H = [1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4]


def _verdicts(rater: str, chosen: dict[str, list[str | None]]) -> list[Verdict]:
    """The versions that a rater chose, line by line."""
    return [
        Verdict(rater, f"l{line}", dimension, choice)
        for dimension, choices in chosen.items()
        for line, choice in enumerate(choices)
    ]


def test_the_t_test_is_student_s() -> None:
    found = one_sample_t(SLEEP_H, 0.0)
    assert found is not None
    assert (found.t, found.freedom, found.p) == pytest.approx((4.0621, 9, 0.002833), abs=5e-5)
    one_tailed = one_sample_t(SLEEP_H, 0.0, tails=1)
    assert one_tailed is not None
    assert one_tailed.p == pytest.approx(0.002833 / 2, abs=5e-6)


def test_without_variance_there_is_no_t() -> None:
    assert one_sample_t([0.75, 0.75, 0.75], 0.5) is None
    assert one_sample_t([0.75], 0.5) is None


def test_undecided_answers_are_counted_and_left_out() -> None:
    found = choice_statistics(
        [
            *_verdicts("r1", {"natural": ["U", "U", "S", None]}),
            *_verdicts("r2", {"natural": ["U", None, None, None]}),
            *_verdicts("r3", {"natural": [None] * 4}),
        ]
    ).dimensions["natural"]
    assert found.answers == 12
    assert found.units == pytest.approx(3 / 4)
    assert found.undecided == pytest.approx(8 / 12)
    assert found.test is not None
    assert found.test.freedom == 1, "who never decides is left out, as in the paper's t(23)"
    assert found.test.tails == 1


def test_dimensions_that_are_decided_alike_agree() -> None:
    """By hand: 30 equal decisions of 40 have χ² = (30 - 20)² / 20 · 2 = 10, p = .001565."""
    alike: list[str | None] = [*["U"] * 30, *["S"] * 10]
    all_units: list[str | None] = [*["U"] * 40]
    verdicts = [
        *_verdicts("r1", {"natural": alike, "friendly": all_units}),
        *_verdicts("r2", {"natural": [None] * 40, "friendly": all_units}),
    ]
    (found,) = choice_statistics(verdicts).agreements
    assert (found.first, found.second, found.trials) == ("natural", "friendly", 40)
    assert found.alike == pytest.approx(0.75)
    assert (found.chi_squared, found.p) == pytest.approx((10.0, 0.001565), abs=1e-6)


def test_of_few_trials_the_test_is_exact() -> None:
    """Five of five alike are no sign: chance has five alike, or five unlike, in one case of sixteen."""
    both: list[str | None] = ["U", "S", "U", "U", "S"]
    verdicts = [*_verdicts("r1", {"natural": both, "friendly": both}), *_verdicts("r2", {"natural": [None] * 5})]
    (found,) = choice_statistics(verdicts).agreements
    assert found.alike == 1.0
    assert found.p == pytest.approx(1 / 16)


def test_a_taste_for_units_is_found() -> None:
    """25 raters of 11 lines as in the paper: units are natural and friendly, singletons nervous, the rest is chance."""
    rng, verdicts = random.Random(3), []
    likely = {"natural": 0.7, "friendly": 0.75, "nervous": 0.2}
    for rater in range(25):
        for line in range(11):
            for dimension in DIMENSIONS:
                chosen = "U" if rng.random() < likely.get(dimension, 0.5) else "S"
                verdicts.append(Verdict(f"r{rater}", f"l{line}", dimension, None if rng.random() < 0.2 else chosen))
    understood = [
        Understanding(f"r{rater}", f"l{line}", 3 if line < 6 else 1 + line % 2)
        for rater in range(25)
        for line in range(11)
    ]
    groups = {f"r{rater}": "DE" if rater < 14 else "US" for rater in range(25)}
    found = choice_statistics(verdicts, understood, groups)
    tests = {name: each.test for name, each in found.dimensions.items()}
    assert all(tests[name] is not None for name in DIMENSIONS)
    told = {name: (test.t, test.p) for name, test in tests.items() if test}
    assert told["natural"][0] > 0
    assert told["natural"][1] < 0.01
    assert told["nervous"][0] < 0
    assert told["nervous"][1] < 0.001
    assert told["extroverted"][1] > 0.01
    opposite = next(each for each in found.agreements if (each.first, each.second) == ("friendly", "nervous"))
    assert opposite.alike < 0.5
    assert opposite.p < 0.05
    assert found.understood == pytest.approx({1: 3 / 11, 2: 2 / 11, 3: 6 / 11})
    effects = {each.name: each.p for each in found.understanding}
    assert effects["dimension"] < 0.001
    assert effects["understanding"] > 0.01, "it decides nothing here, as in the paper"
    (groups_differ,) = found.dimensions["natural"].groups
    assert (groups_differ.first, groups_differ.second, groups_differ.sizes) == ("DE", "US", (14, 11))
    assert found.dimensions["natural"].normality is not None


def test_one_rater_is_too_few() -> None:
    with pytest.raises(InputError) as raised:
        choice_statistics(_verdicts("r1", {"natural": ["U", "S"]}))
    assert raised.value.code == "too_few_answers"
