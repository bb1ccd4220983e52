"""The statistics of NGS's recognition of speakers (§3.5): whether raters can tell one speaker's gestures from
another's.

In test 1 a clip is shown alone, in test 2 beside a clip of another speaker. Each test compares the raters' shares of
right answers with chance (1 / number of speakers) by Student's t, two-tailed as in the paper, and the pooled answers
by the exact binomial test.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import fmean
from types import MappingProxyType

from scipy import stats

from .reading import RecognitionAnswer, by_rater
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

ALONE, BESIDE = 1, 2
"""The paper's Test 1 and Test 2."""


@dataclass(frozen=True, slots=True)
class RecognitionTest:
    """The statistics of one test: the number of answers, the share of right answers and that expected by chance, the
    t test and p of the binomial test; the confusion counts `taken`, by "shown as answered"; normality of the shares,
    and differences between groups."""

    answers: int
    right: float
    chance: float
    test: TTest | None
    binomial_p: float
    taken: Mapping[str, int]
    normality: Normality | None
    groups: tuple[GroupDifference, ...]


@dataclass(frozen=True, slots=True)
class RecognitionStatistics:
    """The statistics of a study of speakers: the numbers of raters and lines, the speakers, and each test by its
    number."""

    raters: int
    lines: int
    speakers: tuple[str, ...]
    tests: Mapping[int, RecognitionTest]


def recognition_statistics(
    named: Sequence[RecognitionAnswer], groups: Mapping[str, str] = MappingProxyType({})
) -> RecognitionStatistics:
    """The statistics of a study; `groups` maps raters to their groups. Raises InputError `too_few_answers` for fewer
    than two raters or two speakers."""
    raters = by_rater(named)
    speakers = tuple(sorted({each.speaker for each in named} | {each.answer for each in named}))
    if len(raters) < FEWEST or len(speakers) < FEWEST:
        raise too_few(f"{len(raters)} raters answered about {len(speakers)} speakers")
    own = {test: [each for each in named if each.beside is (test == BESIDE)] for test in (ALONE, BESIDE)}
    return RecognitionStatistics(
        raters=len(raters),
        lines=len({each.line for each in named}),
        speakers=speakers,
        tests={test: _test(found, len(speakers), groups) for test, found in own.items() if found},
    )


def _test(named: Sequence[RecognitionAnswer], speakers: int, groups: Mapping[str, str]) -> RecognitionTest:
    shares = {rater: fmean(each.is_right for each in own) for rater, own in by_rater(named).items()}
    right, chance = sum(each.is_right for each in named), 1 / speakers
    return RecognitionTest(
        answers=len(named),
        right=right / len(named),
        chance=chance,
        test=one_sample_t([*shares.values()], chance),
        binomial_p=float(stats.binomtest(right, len(named), chance).pvalue),
        taken=dict(Counter(f"{each.speaker} as {each.answer}" for each in named)),
        normality=normality([*shares.values()]),
        groups=group_differences(by_group(shares, groups)),
    )
