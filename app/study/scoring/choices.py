"""The statistics of NGS's study (§4.1, §4.2): in which version, units or singletons, the character is more natural,
friendly, nervous, extroverted, competent, trustworthy.

Undecided answers are counted and then left out. The t test of a dimension is of the raters' shares of U among their
decided answers against one half, one-tailed for naturalness, which units were expected to raise, two-tailed for the
others; a rater who never decided is left out of it, as in the paper. Two dimensions go together if the same version is
chosen for both more often than not: a χ² test of equal against unequal decisions, where both were decided (Table 1).
All tests are scipy's.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from statistics import fmean, pstdev

from scipy import stats

from ...errors import InputError
from ..comparison import DIMENSIONS, NATURAL, UNITS
from .reading import Verdict, by_rater

FEWEST_RATERS = 2
CHANCE = 0.5
FEWEST_TRIALS = 10
"""For χ², of which five of each kind are to be expected; of fewer the binomial test is exact."""


@dataclass(frozen=True, slots=True)
class TTest:
    """t, its degrees of freedom, and p; `tails` are 1 or 2."""

    t: float
    freedom: int
    p: float
    tails: int


@dataclass(frozen=True, slots=True)
class DimensionStatistics:
    """The share of U among decided answers, the share of undecided answers (None if nobody decided), and the t test of
    a preference; None if all raters have the same share, or only one decided."""

    answers: int
    units: float | None
    undecided: float
    test: TTest | None


@dataclass(frozen=True, slots=True)
class Agreement:
    """How often two dimensions are decided alike, of so many trials that decide both, and the p of χ² (of few trials
    that of the binomial test)."""

    first: str
    second: str
    alike: float
    trials: int
    chi_squared: float
    p: float


@dataclass(frozen=True, slots=True)
class ChoiceStatistics:
    """A study of units: who and what was counted, each dimension, each two of them that were decided together, and the
    shares of 1, 2 and 3 in how much was understood, empty where that was not asked."""

    raters: int
    lines: int
    dimensions: Mapping[str, DimensionStatistics]
    agreements: tuple[Agreement, ...]
    understood: Mapping[int, float]


def choice_statistics(verdicts: Sequence[Verdict], understood: Sequence[int] = ()) -> ChoiceStatistics:
    """The statistics of a study; raises InputError `too_few_answers` for fewer than two raters."""
    raters = by_rater(verdicts)
    if len(raters) < FEWEST_RATERS:
        message = f"{len(raters)} raters answered; {FEWEST_RATERS} at least are needed"
        raise InputError("too_few_answers", message, field="answers")
    own = {name: [each for each in verdicts if each.dimension == name] for name in DIMENSIONS}
    return ChoiceStatistics(
        raters=len(raters),
        lines=len({each.line for each in verdicts}),
        dimensions={name: _dimension(name, found) for name, found in own.items() if found},
        agreements=tuple(_agreements(verdicts)),
        understood={level: understood.count(level) / len(understood) for level in sorted(set(understood))},
    )


def one_sample_t(values: Sequence[float], expected: float, *, tails: int = 2) -> TTest | None:
    """Student's test of a mean against what is expected, one-tailed of its being greater; None where there is no
    variance, or one value alone."""
    if len(values) < FEWEST_RATERS or not pstdev(values):
        return None
    alternative = "two-sided" if tails == 2 else "greater"
    found = stats.ttest_1samp(values, expected, alternative=alternative)
    return TTest(float(found.statistic), len(values) - 1, float(found.pvalue), tails)


def _dimension(name: str, verdicts: Sequence[Verdict]) -> DimensionStatistics:
    decided = [each for each in verdicts if each.chosen is not None]
    shares = [_share(own) for own in by_rater(decided).values()]
    test = one_sample_t(shares, CHANCE, tails=1 if name == NATURAL else 2)
    return DimensionStatistics(
        answers=len(verdicts),
        units=_share(decided) if decided else None,
        undecided=1 - len(decided) / len(verdicts),
        test=test,
    )


def _share(decided: Iterable[Verdict]) -> float:
    return fmean(each.chosen == UNITS for each in decided)


def _agreements(verdicts: Iterable[Verdict]) -> list[Agreement]:
    trials: dict[tuple[str, str], dict[str, str]] = {}
    for each in verdicts:
        if each.chosen is not None:
            trials.setdefault((each.rater, each.line), {})[each.dimension] = each.chosen
    both = (
        (one, other, [trial[one] == trial[other] for trial in trials.values() if one in trial and other in trial])
        for one, other in combinations(DIMENSIONS, 2)
    )
    return [_agreement(one, other, alike) for one, other, alike in both if alike]


def _agreement(first: str, second: str, alike: Sequence[bool]) -> Agreement:
    equal = sum(alike)
    found = stats.chisquare([equal, len(alike) - equal])
    p = found.pvalue if len(alike) >= FEWEST_TRIALS else stats.binomtest(equal, len(alike)).pvalue
    return Agreement(first, second, equal / len(alike), len(alike), float(found.statistic), float(p))
