"""Estimates the probability tables of a profile, smoothed by Dirichlet priors.

P(x) = (C(x) + κ π(x)) / (C + κ), with a prior of mean π and strength κ in observations. A tag is smoothed by its class
and a class by all tags; the successors and the hands of a lexeme by the overall distribution. NGS specifies no
smoothing; this one has a single parameter, which `chosen_strength` selects by the likelihood of held-out data: every
fifth observation is held out in turn.
"""

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from math import log
from typing import Generic, TypeVar

from ..profile import ANY_TAG, TagHabit
from .observations import NONE, ObservedTag, level_tags

Value = TypeVar("Value", bound=Hashable)

STRENGTHS = (0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0)
FOLDS = 5
LEAST = 1e-9


def smoothed(counts: Mapping[Value, float], prior: Mapping[Value, float], strength: float) -> dict[Value, float]:
    """The probability of each value of `prior`, which sums to 1."""
    total = sum(counts.values()) + strength
    return {value: (counts.get(value, 0.0) + strength * share) / total for value, share in prior.items()}


def shares_of(counts: Mapping[Value, float]) -> dict[Value, float]:
    """The counts divided by their sum."""
    total = sum(counts.values())
    return {value: count / total for value, count in counts.items()} if total else {}


def chosen_strength(likelihood: Callable[[float], float]) -> tuple[float, float]:
    """The strength with the greatest held-out likelihood (the stronger of equals), and that likelihood."""
    scored = [(likelihood(strength), strength) for strength in STRENGTHS]
    best, strength = max(scored)
    return strength, best


def folds_of(items: Sequence[Value]) -> Iterable[tuple[Sequence[Value], Sequence[Value]]]:
    """The `FOLDS` pairs of training and held-out items; each holds out every fifth item."""
    for fold in range(FOLDS):
        held_out = [item for place, item in enumerate(items) if place % FOLDS == fold]
        if held_out and len(held_out) < len(items):
            yield [item for place, item in enumerate(items) if place % FOLDS != fold], held_out


def log_probability(probabilities: Mapping[Value, float], value: Value) -> float:
    """The logarithm of a probability, which is clipped at `LEAST`."""
    return log(max(probabilities.get(value, 0.0), LEAST))


Second = TypeVar("Second", bound=str)

FEWEST_SEEN = 3
"""A tag that occurs less often is replaced by its class."""


@dataclass(frozen=True, slots=True)
class Rows(Generic[Second]):
    """P(second∣first) by first, the strength of the prior, and the held-out log-likelihood in nats per pair."""

    rows: Mapping[str, Mapping[Second, float]]
    strength: float
    held_out: float


@dataclass(frozen=True, slots=True)
class LearntTags:
    """The distribution of lexemes for each tag, the strength of the prior, and the held-out log-likelihood in nats per
    tag; `blind` is the log-likelihood of a table that ignores the tag."""

    tags: Mapping[str, TagHabit]
    strength: float
    held_out: float
    blind: float


def rows_of(pairs: Sequence[tuple[str, Second]], prior: Mapping[Second, float]) -> Rows[Second]:
    """The conditional distributions of `pairs`, smoothed by `prior`."""
    strength, held_out = chosen_strength(partial(_pair_likelihood, pairs, prior))
    return Rows(_rows(pairs, prior, strength), strength, held_out)


def tag_table(tags: Sequence[ObservedTag]) -> LearntTags:
    """The table of lexemes by tag."""
    strength, held_out = chosen_strength(partial(_tag_likelihood, tags))
    counts = _counts(tags)
    habits = {tag: _habit(counts, tag, strength) for tag in sorted(counts) if _is_kept(counts, tag)}
    blind = [ObservedTag(ANY_TAG, each.outcome) for each in tags]
    return LearntTags(habits, strength, held_out, _tag_likelihood(blind, strength))


def _rows(
    pairs: Iterable[tuple[str, Second]], prior: Mapping[Second, float], strength: float
) -> dict[str, Mapping[Second, float]]:
    counts: dict[str, Counter[Second]] = {}
    for first, second in pairs:
        counts.setdefault(first, Counter())[second] += 1
    return {first: smoothed(counts[first], prior, strength) for first in sorted(counts)}


def _pair_likelihood(pairs: Sequence[tuple[str, Second]], prior: Mapping[Second, float], strength: float) -> float:
    likely: list[float] = []
    for fitted, held_out in folds_of(pairs):
        rows = _rows(fitted, prior, strength)
        likely += (log_probability(rows.get(first, prior), second) for first, second in held_out)
    return sum(likely) / len(likely) if likely else 0.0


def _counts(tags: Iterable[ObservedTag]) -> dict[str, dict[str, float]]:
    """The counts of lexemes, including `NONE`, for each tag, each class and `any`."""
    counts: dict[str, dict[str, float]] = {}
    for each in tags:
        for level in level_tags(each.tag):
            row = counts.setdefault(level, {})
            for lexeme, share in each.outcome.items():
                row[lexeme] = row.get(lexeme, 0.0) + share
    return counts


def _is_kept(counts: Mapping[str, Mapping[str, float]], tag: str) -> bool:
    return tag == ANY_TAG or sum(counts[tag].values()) >= FEWEST_SEEN


def _habit(counts: Mapping[str, Mapping[str, float]], tag: str, strength: float) -> TagHabit:
    outcomes = _outcomes(counts, tag, strength)
    return TagHabit(
        occurrences=round(sum(counts[tag].values())),
        lexemes={lexeme: share for lexeme, share in outcomes.items() if lexeme != NONE},
    )


def _outcomes(counts: Mapping[str, Mapping[str, float]], tag: str, strength: float) -> Mapping[str, float]:
    """P(outcome∣tag)."""
    found = shares_of(counts.get(ANY_TAG, {}))
    for level in reversed(level_tags(tag)[:-1]):
        found = smoothed(counts.get(level, {}), found, strength)
    return found


def _tag_likelihood(tags: Sequence[ObservedTag], strength: float) -> float:
    likely: list[float] = []
    for fitted, held_out in folds_of(tags):
        counts = _counts(fitted)
        outcomes = {tag: _outcomes(counts, tag, strength) for tag in {each.tag for each in held_out}}
        likely += (_outcome_likelihood(outcomes[each.tag], each.outcome) for each in held_out)
    return sum(likely) / len(likely) if likely else 0.0


def _outcome_likelihood(outcomes: Mapping[str, float], seen: Mapping[str, float]) -> float:
    return sum(share * log_probability(outcomes, name) for name, share in seen.items() if share)
