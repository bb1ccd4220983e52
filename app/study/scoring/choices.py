"""The statistics of NGS's study (§4.1, §4.2): in which version, units (U) or singletons (S), the character is more
natural, friendly, nervous, extroverted, competent, trustworthy.

- Undecided answers are counted and then left out.
- A t test for each dimension compares each rater's share of U among the decided answers with one half: one-tailed for
  naturalness, which units were expected to raise, two-tailed for the others. A rater who never decided is left out, as
  in the paper.
- The shares are tested for normality (Lilliefors), and groups of raters are compared by Mann-Whitney's test.
- A two-factor analysis of variance tests the effect of how much was understood.
- A χ² test of equal against unequal decisions shows whether two dimensions are associated, over trials in which both
  were decided (Table 1).

All distributions are scipy's.
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
"""The χ² test requires five expected decisions of each kind; for fewer trials the exact binomial test is used."""


@dataclass(frozen=True, slots=True)
class DimensionStatistics:
    """The statistics of one dimension: the share of U among decided answers (None if nobody decided), the share of
    undecided answers, and the t test of a preference (None if all raters have the same share, or only one decided);
    normality of the raters' shares, and differences between groups of raters if there are groups."""

    answers: int
    units: float | None
    undecided: float
    test: TTest | None
    normality: Normality | None = None
    groups: tuple[GroupDifference, ...] = ()


@dataclass(frozen=True, slots=True)
class Agreement:
    """The share of equal decisions on two dimensions, the number of trials in which both were decided, and the p of the
    χ² test (for few trials that of the binomial test)."""

    first: str
    second: str
    alike: float
    trials: int
    chi_squared: float
    p: float


@dataclass(frozen=True, slots=True)
class ChoiceStatistics:
    """The statistics of a study of units: the numbers of raters and lines, each dimension, each pair of dimensions
    decided together, and the shares of the answers 1, 2 and 3 to how much was understood (empty if not asked).
    `understanding` is the two-factor analysis of variance of the shares of U by understanding and dimension."""

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
    """The statistics of a study; `groups` maps raters to their groups. Raises InputError `too_few_answers` for fewer
    than two raters."""
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
    """The analysis of variance by understanding and dimension (NGS §4.2); a value is the share of U of one rater at one
    level of understanding in one dimension."""
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
