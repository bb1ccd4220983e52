"""The statistics of the main paper's study (§5): how appropriate the performances of three modes are.

Ratings are from 1 to 10. *Normalised* ratings are divided by the rater's highest rating. The unit of the analysis of
variance is a rater's mean in a condition. This agrees with the paper's F(2, 180), which implies 61 raters in three
groups (of the 69 it names); as single ratings, 69 raters of five lines would give 1,035. A rater's line counts only if
the rater rated every clip of it.

The analysis of variance is one-way, followed by Tukey's HSD (Tukey-Kramer); both are scipy's.
"""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from statistics import fmean, stdev
from types import MappingProxyType

from scipy import stats

from ..comparison import CONDITIONS, Comparison, RaterChoice
from .reading import Rating, by_rater
from .samples import FEWEST, GroupDifference, Normality, by_group, group_differences, normality, too_few

CONFIDENCE = 0.95

Groups = Mapping[str, Sequence[float]]
"""The values of each condition."""


@dataclass(frozen=True, slots=True)
class Mean:
    """The mean and the standard deviation of a condition's values."""

    mean: float
    deviation: float


@dataclass(frozen=True, slots=True)
class Anova:
    """A one-way analysis of variance: F, its degrees of freedom between and within groups, and p."""

    f: float
    between: int
    within: int
    p: float


@dataclass(frozen=True, slots=True)
class Difference:
    """The difference between the means of the first and the second condition, its 95 % confidence interval (`low`,
    `high`), and Tukey's p."""

    first: str
    second: str
    difference: float
    low: float
    high: float
    p: float


@dataclass(frozen=True, slots=True)
class Variance:
    """The means of the conditions and the tests of their differences. Without variance within any condition `anova` is
    None and `differences` is empty."""

    means: Mapping[str, Mean]
    anova: Anova | None
    differences: tuple[Difference, ...]


@dataclass(frozen=True, slots=True)
class Preference:
    """The shares of lines in which a condition is ranked first and last; tied clips share the rank evenly."""

    first: float
    last: float


@dataclass(frozen=True, slots=True)
class RatingStatistics:
    """The statistics of a study of modes: the numbers of raters, lines and ratings; the ratings and the normalised
    ratings; preferences by the highest and lowest grades of a line (`by_grade`), and by the raters' choices of best and
    worst (`by_choice`, None if not asked). `incomplete` counts pairs of rater and line that lack a rating. `normality`
    of the raters' means and differences between `groups` of raters are by condition."""

    raters: int
    lines: int
    ratings: int
    incomplete: int
    graded: Variance
    normalised: Variance
    by_grade: Mapping[str, Preference]
    by_choice: Mapping[str, Preference] | None
    normality: Mapping[str, Normality | None] = field(default_factory=dict)
    groups: Mapping[str, tuple[GroupDifference, ...]] = field(default_factory=dict)


def rating_statistics(ratings: Sequence[Rating], groups: Mapping[str, str] = MappingProxyType({})) -> RatingStatistics:
    """The statistics of a study; `groups` maps raters to their groups. Raises InputError `too_few_answers` if fewer
    than two raters rated every clip of a line."""
    conditions = CONDITIONS[Comparison.MODES]
    every = _trials(ratings)
    trials = {name: trial for name, trial in every.items() if len(trial) == len(conditions)}
    whole = [each for trial in trials.values() for each in trial]
    raters = by_rater(whole)
    if len(raters) < FEWEST:
        raise too_few(f"{len(raters)} raters rated every clip of a line")
    means = {condition: [_mean(own, condition) for own in raters.values()] for condition in conditions}
    highest = [max(each.grade for each in own) for own in raters.values()]
    shares = {name: [mean / most for mean, most in zip(own, highest, strict=True)] for name, own in means.items()}
    return RatingStatistics(
        raters=len(raters),
        lines=len({each.line for each in whole}),
        ratings=len(whole),
        incomplete=len(every) - len(trials),
        graded=variance(means),
        normalised=variance(shares),
        by_grade=_by_grade(trials.values(), conditions),
        by_choice=_by_choice(whole, conditions),
        normality={name: normality(values) for name, values in means.items()},
        groups={
            name: group_differences(by_group(dict(zip(raters, values, strict=True)), groups))
            for name, values in means.items()
        },
    )


def variance(groups: Groups) -> Variance:
    """The means of groups, the one-way analysis of variance, and Tukey's comparison of each pair."""
    means = {name: Mean(fmean(values), stdev(values)) for name, values in groups.items()}
    if not any(each.deviation for each in means.values()):
        return Variance(means, None, ())
    within = sum(len(values) - 1 for values in groups.values())
    found = stats.f_oneway(*groups.values())
    anova = Anova(float(found.statistic), len(groups) - 1, within, float(found.pvalue))
    return Variance(means, anova, tuple(_differences(groups)))


def _differences(groups: Groups) -> list[Difference]:
    names = list(groups)
    found = stats.tukey_hsd(*groups.values())
    bounds = found.confidence_interval(CONFIDENCE)
    return [
        Difference(
            names[one],
            names[other],
            float(found.statistic[one, other]),
            float(bounds.low[one, other]),
            float(bounds.high[one, other]),
            float(found.pvalue[one, other]),
        )
        for one, other in combinations(range(len(names)), 2)
    ]


def _trials(ratings: Iterable[Rating]) -> dict[tuple[str, str], list[Rating]]:
    """The ratings of each line by each rater."""
    trials: dict[tuple[str, str], list[Rating]] = {}
    for each in ratings:
        trials.setdefault((each.rater, each.line), []).append(each)
    return trials


def _mean(ratings: Iterable[Rating], condition: str) -> float:
    return fmean(each.grade for each in ratings if each.condition == condition)


def _by_grade(trials: Iterable[Sequence[Rating]], conditions: Sequence[str]) -> Mapping[str, Preference]:
    """The paper's first choice: the clip of a line with the highest grade; and the last: with the lowest."""
    first, last, count = dict.fromkeys(conditions, 0.0), dict.fromkeys(conditions, 0.0), 0
    for trial in trials:
        count += 1
        grades = [each.grade for each in trial]
        for shares, grade in ((first, max(grades)), (last, min(grades))):
            for each in trial:
                if each.grade == grade:
                    shares[each.condition] += 1 / grades.count(grade)
    return {name: Preference(first[name] / count, last[name] / count) for name in conditions}


def _by_choice(ratings: Iterable[Rating], conditions: Iterable[str]) -> Mapping[str, Preference] | None:
    """The shares of the raters' choices of best and worst; None if either was never chosen."""
    chosen = Counter((each.choice, each.condition) for each in ratings)
    best, worst = (sum(chosen[choice, name] for name in conditions) for choice in (RaterChoice.BEST, RaterChoice.WORST))
    if not best or not worst:
        return None
    return {
        name: Preference(chosen[RaterChoice.BEST, name] / best, chosen[RaterChoice.WORST, name] / worst)
        for name in conditions
    }
