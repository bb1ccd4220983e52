"""Statistical tests shared by the studies: Student's t, Mann-Whitney's U, normality, and two-factor analysis of
variance; and power analysis: how many raters a study needs to find an effect of a given size.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from statistics import pstdev

import numpy as np
from scipy import stats

from ...errors import InputError
from ...model import FloatArray
from ..comparison import Comparison

FEWEST = 2
FEWEST_TO_FIT = 4
DRAWS = 1999
"""The number of normal samples from which the p value of normality is estimated."""


def too_few(told: str) -> InputError:
    """The error for too few raters; `told` states how many there are."""
    return InputError("too_few_answers", f"{told}; {FEWEST} at least are needed", field="answers")


@dataclass(frozen=True, slots=True)
class TTest:
    """A t test: t, its degrees of freedom, p, and the number of tails (1 or 2)."""

    t: float
    freedom: int
    p: float
    tails: int


@dataclass(frozen=True, slots=True)
class Normality:
    """A normality test: the largest distance between the sample's distribution and the normal distribution with its
    mean and deviation (Kolmogorov-Smirnov), and the share of normal samples at least that far (Lilliefors)."""

    distance: float
    p: float


@dataclass(frozen=True, slots=True)
class GroupDifference:
    """Mann-Whitney's U of the first of two groups of raters, their sizes, and p, two-tailed."""

    first: str
    second: str
    sizes: tuple[int, int]
    u: float
    p: float


@dataclass(frozen=True, slots=True)
class Effect:
    """The effect of a factor, or of the interaction of two: F, its degrees of freedom, and p."""

    name: str
    f: float
    between: int
    within: int
    p: float


def one_sample_t(values: Sequence[float], expected: float, *, tails: int = 2) -> TTest | None:
    """Student's t test of a mean against the expected value; one-tailed it tests for a greater mean. None for a single
    value, or without variance."""
    if len(values) < FEWEST or not pstdev(values):
        return None
    alternative = "two-sided" if tails == 2 else "greater"
    found = stats.ttest_1samp(values, expected, alternative=alternative)
    return TTest(float(found.statistic), len(values) - 1, float(found.pvalue), tails)


def normality(values: Sequence[float]) -> Normality | None:
    """Whether the values may be normally distributed, as the t test assumes; None for too few or equal values."""
    if len(values) < FEWEST_TO_FIT or not pstdev(values):
        return None
    found = stats.goodness_of_fit(
        stats.norm, values, statistic="ks", n_mc_samples=DRAWS, rng=np.random.default_rng(len(values))
    )
    return Normality(float(found.statistic), float(found.pvalue))


def group_differences(values: Mapping[str, Sequence[float]]) -> tuple[GroupDifference, ...]:
    """Compares each pair of groups by Mann-Whitney's test; exact for few values without ties."""
    return tuple(
        GroupDifference(one, other, (len(values[one]), len(values[other])), float(found.statistic), float(found.pvalue))
        for one, other in combinations(values, 2)
        for found in [stats.mannwhitneyu(values[one], values[other])]
    )


def by_group(values: Mapping[str, float], groups: Mapping[str, str]) -> Mapping[str, Sequence[float]]:
    """The raters' values by group; raters without a group are left out."""
    found: dict[str, list[float]] = {}
    for rater, value in values.items():
        if groups.get(rater):
            found.setdefault(groups[rater], []).append(value)
    return dict(sorted(found.items()))


def two_factors(values: Sequence[float], first: Sequence[str], second: Sequence[str]) -> tuple[Effect, ...]:
    """Two-factor analysis of variance with interaction, for cells of unequal size (type II sums of squares: each factor
    adjusted for the other). Terms without degrees of freedom are left out; the result is empty if no cell has
    variance.

    `first` and `second` are the levels of each value.
    """
    one, other = _dummies(first), _dummies(second)
    products: list[FloatArray] = [one[:, [column]] * other for column in range(one.shape[1])]
    both = np.hstack(products or [one])
    observed, ones = np.asarray(values, dtype=float), np.ones((len(values), 1))
    alone = [np.hstack([ones, one]), np.hstack([ones, other])]
    additive, full = np.hstack([ones, one, other]), np.hstack([ones, one, other, both])
    error, rank = _residual(full, observed)
    within = len(values) - rank
    if within < 1 or error <= 1e-12 * max(1.0, float(observed @ observed)):
        return ()
    pairs = (("first", alone[1], additive), ("second", alone[0], additive), ("both", additive, full))
    found = ((name, _residual(less, observed), _residual(more, observed)) for name, less, more in pairs)
    return tuple(
        _effect(name, less[0] - more[0], more[1] - less[1], error / within, within)
        for name, less, more in found
        if more[1] > less[1]
    )


def _effect(name: str, squares: float, between: int, error: float, within: int) -> Effect:
    f = squares / between / error
    return Effect(name, f, between, within, float(stats.f.sf(f, between, within)))


def _dummies(levels: Sequence[str]) -> FloatArray:
    """Dummy coding: a column for each level except the first, 1 where a value has that level."""
    known = sorted(set(levels))[1:]
    return np.array([[float(level == each) for each in known] for level in levels]).reshape(len(levels), len(known))


def _residual(design: FloatArray, observed: FloatArray) -> tuple[float, int]:
    """The residual sum of squares of a least-squares fit of the design, and the rank of the design."""
    fitted, _residuals, rank, _values = np.linalg.lstsq(design, observed, rcond=None)
    left = observed - design @ fitted
    return float(left @ left), int(rank)


SIGNIFICANT = 0.05
POWER = 0.8

SIZES_OF_T = (0.2, 0.5, 0.8)
SIZES_OF_F = (0.1, 0.25, 0.4)


@dataclass(frozen=True, slots=True)
class SampleSize:
    """The number of raters that find an effect of this size with probability `POWER`."""

    size: float
    raters: int


def raters_needed(comparison: Comparison, conditions: int) -> tuple[SampleSize, ...]:
    """The number of raters needed to find a small, a medium and a large effect in this comparison."""
    if comparison is Comparison.MODES:
        return tuple(SampleSize(size, _fewest(partial(power_of_f, size, conditions))) for size in SIZES_OF_F)
    return tuple(SampleSize(size, _fewest(partial(power_of_t, size))) for size in SIZES_OF_T)


def power_of_t(d: float, raters: int) -> float:
    """The power of a two-tailed t test at p < `SIGNIFICANT` for an effect size of d (mean over deviation)."""
    freedom, shift = raters - 1, d * raters**0.5
    least = stats.t.ppf(1 - SIGNIFICANT / 2, freedom)
    return float(stats.nct.sf(least, freedom, shift) + stats.nct.cdf(-least, freedom, shift))


def power_of_f(f: float, conditions: int, raters: int) -> float:
    """The power of a one-way analysis of variance at p < `SIGNIFICANT` for an effect size of f; `raters` is the number
    of values per condition."""
    between, within = conditions - 1, conditions * (raters - 1)
    least = stats.f.ppf(1 - SIGNIFICANT, between, within)
    return float(stats.ncf.sf(least, between, within, f * f * conditions * raters))


def plan_told(comparison: Comparison, conditions: int) -> str:
    """A sentence on how many raters to recruit, for the experimenter."""
    name = "f" if comparison is Comparison.MODES else "d"
    small, medium, large = raters_needed(comparison, conditions)
    sizes = [f"{each.raters} if {told} ({each.size:g})" for each, told in ((medium, "medium"), (small, "small"))]
    take = f"take {large.raters} raters if it is large ({name} = {large.size:g}), {', '.join(sizes)}"
    return f"to find an effect at p < {SIGNIFICANT:g} in {100 * POWER:.0f} of 100 studies, {take}"


def _fewest(power: Callable[[int], float]) -> int:
    high = 2
    while power(high) < POWER:  # doubled, since noncentral distributions are inaccurate where power is nearly 1
        high *= 2
    low = high // 2
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if power(middle) >= POWER else (middle + 1, high)
    return low
