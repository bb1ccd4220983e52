"""The statistics of paired comparisons (RTS §3.2), on a scale from -2, the first clip much better, to 2, the second.

For each pair of conditions: the mean preference, whose sign is such that values below 0 favour the condition named
first, as in the thesis' Table 3.3; a t test of the raters' means against 0; and Wilcoxon's signed-rank test, for means
that are not normal. Identical pairs are a check on the raters: their mean should be near 0.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from statistics import fmean, stdev
from types import MappingProxyType

from scipy import stats

from ..comparison import CONDITIONS, Comparison
from .reading import PreferenceAnswer, by_rater
from .samples import (
    FEWEST,
    GroupDifference,
    Normality,
    TTest,
    by_group,
    group_differences,
    normality,
    one_sample_t,
    too_few,
)


@dataclass(frozen=True, slots=True)
class PairStatistics:
    """The statistics of a pair of conditions: the number of answers, the mean over raters and its deviation, the share
    of answers that prefer neither, the t test, p of Wilcoxon's test (None if every mean is 0), normality of the means
    and differences between groups."""

    first: str
    second: str
    answers: int
    mean: float
    deviation: float
    neither: float
    test: TTest | None
    wilcoxon_p: float | None
    normality: Normality | None
    groups: tuple[GroupDifference, ...]


@dataclass(frozen=True, slots=True)
class PreferenceStatistics:
    """The statistics of a study of pairs: the numbers of raters and lines, and each pair of conditions that was
    compared, identical pairs last."""

    raters: int
    lines: int
    pairs: tuple[PairStatistics, ...]


def preference_statistics(
    comparison: Comparison, preferred: Sequence[PreferenceAnswer], groups: Mapping[str, str] = MappingProxyType({})
) -> PreferenceStatistics:
    """The statistics of a study; `groups` maps raters to their groups. Raises InputError `too_few_answers` for fewer
    than two raters."""
    raters = by_rater(preferred)
    if len(raters) < FEWEST:
        raise too_few(f"{len(raters)} raters answered")
    turned = [_turned(each, CONDITIONS[comparison]) for each in preferred]
    names = [*combinations(CONDITIONS[comparison], 2), *((name, name) for name in CONDITIONS[comparison])]
    own = {pair: [each for each in turned if (each.first, each.second) == pair] for pair in names}
    return PreferenceStatistics(
        raters=len(raters),
        lines=len({each.line for each in preferred}),
        pairs=tuple(_pair(*pair, found, groups) for pair, found in own.items() if found),
    )


def _turned(answer: PreferenceAnswer, order: Sequence[str]) -> PreferenceAnswer:
    """The answer with its conditions in the order of the table."""
    if order.index(answer.first) <= order.index(answer.second):
        return answer
    return PreferenceAnswer(answer.rater, answer.line, answer.second, answer.first, -answer.preference)


def _pair(first: str, second: str, answers: Sequence[PreferenceAnswer], groups: Mapping[str, str]) -> PairStatistics:
    means = {rater: fmean(each.preference for each in own) for rater, own in by_rater(answers).items()}
    values = [*means.values()]
    return PairStatistics(
        first=first,
        second=second,
        answers=len(answers),
        mean=fmean(values),
        deviation=stdev(values) if len(values) > 1 else 0.0,
        neither=fmean(each.preference == 0 for each in answers),
        test=one_sample_t(values, 0.0),
        wilcoxon_p=float(stats.wilcoxon(values, method="approx").pvalue) if any(values) else None,
        normality=normality(values),
        groups=group_differences(by_group(means, groups)),
    )
