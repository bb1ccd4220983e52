"""The statistics of paired comparisons (RTS §3.2), on a scale from -2, the first clip much better, to 2, the second.

Of each two conditions the mean preference, turned so that below 0 is for the condition named first, as in the paper's
Table 3.3; a t test of the raters' own means against 0, and, for those that are not normal, Wilcoxon's signed ranks.
Identical pairs show whether raters answer what they see: their mean should be near 0.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from statistics import fmean, stdev
from types import MappingProxyType

from scipy import stats

from ..comparison import CONDITIONS, Comparison
from .reading import Preferred, by_rater
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
    """Two conditions: the answers, the mean over raters and their deviation, how often neither was preferred, the t
    test, p of Wilcoxon's test (None where every mean is 0), and whether means are normal and groups differ."""

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
    """A study of pairs: who and what was counted, and each two conditions that were compared, identical ones last."""

    raters: int
    lines: int
    pairs: tuple[PairStatistics, ...]


def preference_statistics(
    comparison: Comparison, preferred: Sequence[Preferred], groups: Mapping[str, str] = MappingProxyType({})
) -> PreferenceStatistics:
    """The statistics of a study, whose raters are of these groups; raises InputError `too_few_answers` for fewer than
    two raters."""
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


def _turned(answer: Preferred, order: Sequence[str]) -> Preferred:
    """The answer with its conditions in the order of the table."""
    if order.index(answer.first) <= order.index(answer.second):
        return answer
    return Preferred(answer.rater, answer.line, answer.second, answer.first, -answer.preference)


def _pair(first: str, second: str, answers: Sequence[Preferred], groups: Mapping[str, str]) -> PairStatistics:
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
