"""Probabilities from counts: smoothed by a prior worth so many observations, whose worth held-out data choose.

P(x) = (C(x) + κ π(x)) / (C + κ), a Dirichlet prior of mean π and strength κ. NGS gives no smoothing; of the usual ones
this needs one number, which `chosen_strength` takes from the likelihood of what was left out.
"""

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from math import log
from typing import TypeVar

Value = TypeVar("Value", bound=Hashable)

STRENGTHS = (0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0)
FOLDS = 5
LEAST = 1e-9


def smoothed(counts: Mapping[Value, float], prior: Mapping[Value, float], strength: float) -> dict[Value, float]:
    """The probability of each value of `prior`, which sums to 1."""
    total = sum(counts.values()) + strength
    return {value: (counts.get(value, 0.0) + strength * share) / total for value, share in prior.items()}


def shares_of(counts: Mapping[Value, float]) -> dict[Value, float]:
    """The counts as parts of their sum."""
    total = sum(counts.values())
    return {value: count / total for value, count in counts.items()} if total else {}


def chosen_strength(likelihood: Callable[[float], float]) -> tuple[float, float]:
    """Of the strengths the one with the greatest held-out likelihood, the stronger of equals, and that likelihood."""
    scored = [(likelihood(strength), strength) for strength in STRENGTHS]
    best, strength = max(scored)
    return strength, best


def folds_of(items: Sequence[Value]) -> Iterable[tuple[Sequence[Value], Sequence[Value]]]:
    """What to fit on and what is held out, `FOLDS` times: every fifth item is held out together."""
    for fold in range(FOLDS):
        held_out = [item for place, item in enumerate(items) if place % FOLDS == fold]
        if held_out and len(held_out) < len(items):
            yield [item for place, item in enumerate(items) if place % FOLDS != fold], held_out


def log_probability(probabilities: Mapping[Value, float], value: Value) -> float:
    """The logarithm; of what is impossible that of `LEAST`."""
    return log(max(probabilities.get(value, 0.0), LEAST))
