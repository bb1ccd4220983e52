"""How many raters a study needs to find a difference of a size, told before it is run.

Sizes are Cohen's: d, a mean in its standard deviations (.2 small, .5 medium, .8 large), and f, the deviation of
conditions' means in the deviation within (.1, .25, .4). Tests are those of `understudy study score`: Student's t of the
raters' own means, two-tailed, and one-way analysis of variance with a mean of each rater in each condition.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from scipy import stats

from .comparison import Comparison

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
