"""Tests of samples that several studies need: Student's and Mann-Whitney's, normality, and analysis of two factors; and
how many raters a study needs to find a difference of a size, told before it is run.
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
"""Samples of a normal distribution that p of normality is counted in."""


def too_few(told: str) -> InputError:
    """The error for answers of fewer raters than statistics need; `told` says how many there are."""
    return InputError("too_few_answers", f"{told}; {FEWEST} at least are needed", field="answers")


@dataclass(frozen=True, slots=True)
class TTest:
    """t, its degrees of freedom, and p; `tails` are 1 or 2."""

    t: float
    freedom: int
    p: float
    tails: int


@dataclass(frozen=True, slots=True)
class Normality:
    """The largest distance between the sample's distribution and the normal one of its mean and deviation
    (Kolmogorov-Smirnov), and the share of normal samples that are as far (Lilliefors)."""

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
    """F of a factor, or of two together, with its degrees of freedom, and p."""

    name: str
    f: float
    between: int
    within: int
    p: float


def one_sample_t(values: Sequence[float], expected: float, *, tails: int = 2) -> TTest | None:
    """Student's test of a mean against what is expected, one-tailed of its being greater; None where there is no
    variance, or one value alone."""
    if len(values) < FEWEST or not pstdev(values):
        return None
    alternative = "two-sided" if tails == 2 else "greater"
    found = stats.ttest_1samp(values, expected, alternative=alternative)
    return TTest(float(found.statistic), len(values) - 1, float(found.pvalue), tails)


def normality(values: Sequence[float]) -> Normality | None:
    """Whether values may be of a normal distribution, as a t test has it; None of too few, or of equal ones."""
    if len(values) < FEWEST_TO_FIT or not pstdev(values):
        return None
    found = stats.goodness_of_fit(
        stats.norm, values, statistic="ks", n_mc_samples=DRAWS, rng=np.random.default_rng(len(values))
    )
    return Normality(float(found.statistic), float(found.pvalue))


def group_differences(values: Mapping[str, Sequence[float]]) -> tuple[GroupDifference, ...]:
    """Each two groups of raters compared by the ranks of their values; exact where there are few and none are tied."""
    return tuple(
        GroupDifference(one, other, (len(values[one]), len(values[other])), float(found.statistic), float(found.pvalue))
        for one, other in combinations(values, 2)
        for found in [stats.mannwhitneyu(values[one], values[other])]
    )


def by_group(values: Mapping[str, float], groups: Mapping[str, str]) -> Mapping[str, Sequence[float]]:
    """The raters' values by group, of those raters who are of one."""
    found: dict[str, list[float]] = {}
    for rater, value in values.items():
        if groups.get(rater):
            found.setdefault(groups[rater], []).append(value)
    return dict(sorted(found.items()))


def two_factors(values: Sequence[float], first: Sequence[str], second: Sequence[str]) -> tuple[Effect, ...]:
    """The analysis of variance by two factors and both together, where cells may have any number of values (sums of
    squares of type II: each factor beside the other). A term without freedom is left out; nothing is found where all
    cells are without variance.

    `first` and `second` have the level of each value.
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
    """A column for each level but the first, 1 where a value has it."""
    known = sorted(set(levels))[1:]
    return np.array([[float(level == each) for each in known] for level in levels]).reshape(len(levels), len(known))


def _residual(design: FloatArray, observed: FloatArray) -> tuple[float, int]:
    """What the design leaves of the values, as a sum of squares, and its rank."""
    fitted, _residuals, rank, _values = np.linalg.lstsq(design, observed, rcond=None)
    left = observed - design @ fitted
    return float(left @ left), int(rank)


SIGNIFICANT = 0.05
POWER = 0.8

SIZES_OF_T = (0.2, 0.5, 0.8)
SIZES_OF_F = (0.1, 0.25, 0.4)


@dataclass(frozen=True, slots=True)
class Needed:
    """So many raters find an effect of this size with a probability of `POWER`."""

    size: float
    raters: int


def raters_needed(comparison: Comparison, conditions: int) -> tuple[Needed, ...]:
    """How many raters find a small, a medium and a large effect in this comparison."""
    if comparison is Comparison.MODES:
        return tuple(Needed(size, _fewest(partial(power_of_f, size, conditions))) for size in SIZES_OF_F)
    return tuple(Needed(size, _fewest(partial(power_of_t, size))) for size in SIZES_OF_T)


def power_of_t(d: float, raters: int) -> float:
    """How probably a t test of so many raters finds a mean of d deviations, at p < `SIGNIFICANT`, two-tailed."""
    freedom, shift = raters - 1, d * raters**0.5
    least = stats.t.ppf(1 - SIGNIFICANT / 2, freedom)
    return float(stats.nct.sf(least, freedom, shift) + stats.nct.cdf(-least, freedom, shift))


def power_of_f(f: float, conditions: int, raters: int) -> float:
    """How probably a one-way analysis of variance of so many raters finds means that deviate by f."""
    between, within = conditions - 1, conditions * (raters - 1)
    least = stats.f.ppf(1 - SIGNIFICANT, between, within)
    return float(stats.ncf.sf(least, between, within, f * f * conditions * raters))


def plan_told(comparison: Comparison, conditions: int) -> str:
    """A sentence for whoever makes a study."""
    name = "f" if comparison is Comparison.MODES else "d"
    small, medium, large = raters_needed(comparison, conditions)
    sizes = [f"{each.raters} if {told} ({each.size:g})" for each, told in ((medium, "medium"), (small, "small"))]
    take = f"take {large.raters} raters if it is large ({name} = {large.size:g}), {', '.join(sizes)}"
    return f"to find an effect at p < {SIGNIFICANT:g} in {100 * POWER:.0f} of 100 studies, {take}"


def _fewest(power: Callable[[int], float]) -> int:
    high = 2
    while power(high) < POWER:  # doubled, since distributions lose their digits where power is nearly 1
        high *= 2
    low = high // 2
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if power(middle) >= POWER else (middle + 1, high)
    return low
