"""The statistics of NGS's study (§4.1, §4.2): in which version, units or singletons, the character is more natural,
friendly, nervous, extroverted, competent, trustworthy.

Undecided answers are counted and then left out. The t test of a dimension is of the raters' shares of U among their
decided answers against one half, one-tailed for naturalness, which units were expected to raise, two-tailed for the
others; a rater who never decided is left out of it, as in the paper. Whether shares are normal is tested (Lilliefors),
groups of raters are compared by Mann-Whitney's test, and how much was understood by two factors. Two dimensions go
together if the same version is chosen for both more often than not: a χ² test of equal against unequal decisions, where
both were decided (Table 1).
All tests are scipy's.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from statistics import fmean
from types import MappingProxyType

from scipy import stats

from ..comparison import DIMENSIONS, NATURAL, UNITS
from .reading import Understanding, Verdict, by_rater
from .samples import (
    FEWEST,
    Effect,
    GroupDifference,
    Normality,
    TTest,
    by_group,
    group_differences,
    normality,
    one_sample_t,
    too_few,
    two_factors,
)

CHANCE = 0.5
FEWEST_TRIALS = 10
"""For χ², of which five of each kind are to be expected; of fewer the binomial test is exact."""


@dataclass(frozen=True, slots=True)
class DimensionStatistics:
    """The share of U among decided answers, the share of undecided answers (None if nobody decided), and the t test of
    a preference; None if all raters have the same share, or only one decided. Whether the raters' shares are normal,
    and whether groups of raters differ, where there are some."""

    answers: int
    units: float | None
    undecided: float
    test: TTest | None
    normality: Normality | None = None
    groups: tuple[GroupDifference, ...] = ()


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
    shares of 1, 2 and 3 in how much was understood, empty where that was not asked. `understanding` says whether it
    and the dimension change which version is chosen: the variance of raters' shares of U by both."""

    raters: int
    lines: int
    dimensions: Mapping[str, DimensionStatistics]
    agreements: tuple[Agreement, ...]
    understood: Mapping[int, float]
    understanding: tuple[Effect, ...] = ()


def choice_statistics(
    verdicts: Sequence[Verdict],
    understood: Sequence[Understanding] = (),
    groups: Mapping[str, str] = MappingProxyType({}),
) -> ChoiceStatistics:
    """The statistics of a study, whose raters are of these groups; raises InputError `too_few_answers` for fewer than
    two raters."""
    raters = by_rater(verdicts)
    if len(raters) < FEWEST:
        raise too_few(f"{len(raters)} raters answered")
    own = {name: [each for each in verdicts if each.dimension == name] for name in DIMENSIONS}
    levels = [each.level for each in understood]
    return ChoiceStatistics(
        raters=len(raters),
        lines=len({each.line for each in verdicts}),
        dimensions={name: _dimension(name, found, groups) for name, found in own.items() if found},
        agreements=tuple(_agreements(verdicts)),
        understood={level: levels.count(level) / len(levels) for level in sorted(set(levels))},
        understanding=_understanding(verdicts, understood),
    )


def _dimension(name: str, verdicts: Sequence[Verdict], groups: Mapping[str, str]) -> DimensionStatistics:
    decided = [each for each in verdicts if each.chosen is not None]
    shares = {rater: _share(own) for rater, own in by_rater(decided).items()}
    test = one_sample_t([*shares.values()], CHANCE, tails=1 if name == NATURAL else 2)
    return DimensionStatistics(
        answers=len(verdicts),
        units=_share(decided) if decided else None,
        undecided=1 - len(decided) / len(verdicts),
        test=test,
        normality=normality([*shares.values()]),
        groups=group_differences(by_group(shares, groups)),
    )


def _understanding(verdicts: Iterable[Verdict], understood: Iterable[Understanding]) -> tuple[Effect, ...]:
    """Two factors, how much was understood and the dimension (NGS §4.2); a value is a rater's share of U in both."""
    level_of = {(each.rater, each.line): str(each.level) for each in understood}
    cells: dict[tuple[str, str, str], list[Verdict]] = {}
    for each in verdicts:
        level = level_of.get((each.rater, each.line))
        if level is not None and each.chosen is not None:
            cells.setdefault((level, each.dimension, each.rater), []).append(each)
    named = {"first": "understanding", "second": "dimension", "both": "both together"}
    values = [_share(own) for own in cells.values()]
    if not values:
        return ()
    found = two_factors(values, [level for level, _, _ in cells], [dimension for _, dimension, _ in cells])
    return tuple(replace(each, name=named[each.name]) for each in found)


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
