"""Stratification: orders rules such that an `unless` is evaluated only when all facts it depends on are known.

A rule feeds a pattern if a fact it asserts could match it: same predicate, and no position with disjoint constants. A
fact asserted exactly as it was joined only gets an annotation and feeds nothing. Strata are numbered from 0; a rule is
in the first stratum that is not before those feeding its patterns, and after those feeding its `unless`. If an `unless`
depends, through other rules, on its own rule, there is no such order.
"""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TypeAlias

from ...model import Argument
from ..language.tree import (
    Alternatives,
    Assertion,
    Atom,
    Constant,
    Expression,
    Pattern,
    RuleTree,
)

Form: TypeAlias = tuple[frozenset[Argument] | None, ...]
"""The possible values at each position of a fact; None: any."""


@dataclass(frozen=True, slots=True)
class Cycle:
    """Rules, by index, each feeding the next; the last feeds the first, through its pattern `unless`."""

    rules: tuple[int, ...]
    unless: Pattern


@dataclass(frozen=True, slots=True)
class Feeding:
    """By rule index, the rules that feed its patterns, and those that feed its `unless` patterns."""

    joined: tuple[frozenset[int], ...]
    excluded: tuple[tuple[tuple[Pattern, frozenset[int]], ...], ...]

    def into(self, rule: int) -> frozenset[int]:
        """All rules that feed `rule`, either way."""
        return self.joined[rule].union(*(feeders for _, feeders in self.excluded[rule]))


def feeding(rules: Sequence[RuleTree], annotated: Mapping[str, bool]) -> Feeding:
    """The dependencies between rules; `annotated` tells which predicates have an annotation as their last argument."""
    heads: dict[str, dict[Form, set[int]]] = defaultdict(lambda: defaultdict(set))
    for number, rule in enumerate(rules):
        for atom in asserted(rule):
            if not _only_annotates(atom, rule, annotated):
                heads[atom.name][_form(atom, annotated)].add(number)

    @cache
    def feeders_of(name: str, form: Form) -> frozenset[int]:
        matching = (numbers for head, numbers in heads[name].items() if _compatible(head, form))
        return frozenset[int]().union(*matching)

    def feeders(atom: Atom) -> frozenset[int]:
        return feeders_of(atom.name, _form(atom, annotated))

    joined, excluded = [], []
    for rule in rules:
        patterns = [part for part in rule.statements if isinstance(part, Pattern)]
        joined.append(frozenset[int]().union(*(feeders(part.fact) for part in patterns if not part.absent)))
        excluded.append(tuple((part, feeders(part.fact)) for part in patterns if part.absent))
    return Feeding(tuple(joined), tuple(excluded))


def cycles(fed: Feeding) -> Iterator[Cycle]:
    """One cycle for each `unless` that depends on its own rule."""
    for rule, excluded in enumerate(fed.excluded):
        for unless, feeders in excluded:
            if shortest := _shortest_way(fed, rule, sorted(feeders)):
                yield Cycle(shortest, unless)


def strata(fed: Feeding) -> tuple[int, ...]:
    """The stratum of each rule; there must be no cycles."""
    numbers = [0] * len(fed.joined)
    changed = True
    while changed:
        changed = False
        for rule, joined in enumerate(fed.joined):
            above = [numbers[feeder] + 1 for _, feeders in fed.excluded[rule] for feeder in feeders]
            needed = max([numbers[rule], *(numbers[feeder] for feeder in joined), *above])
            changed |= needed != numbers[rule]
            numbers[rule] = needed
    return tuple(numbers)


def asserted(rule: RuleTree) -> tuple[Atom, ...]:
    """The facts that a rule asserts."""
    return tuple(atom for part in rule.conclusions if isinstance(part, Assertion) for atom in part.facts)


def _shortest_way(fed: Feeding, start: int, ends: Sequence[int]) -> tuple[int, ...] | None:
    """The shortest chain of rules by which `start` feeds one of `ends`, both included."""
    reached: dict[int, tuple[int, ...]] = {end: (end,) for end in ends}
    border = list(ends)
    while border and start not in reached:
        border_next = []
        for rule in border:
            for feeder in sorted(fed.into(rule) - reached.keys()):
                reached[feeder] = (feeder, *reached[rule])
                border_next.append(feeder)
        border = border_next
    return reached.get(start)


def _form(atom: Atom, annotated: Mapping[str, bool]) -> Form:
    return tuple(_values(argument) for argument in _identity(atom, annotated))


def _identity(atom: Atom, annotated: Mapping[str, bool]) -> tuple[Expression, ...]:
    return atom.arguments[:-1] if annotated[atom.name] else atom.arguments


def _values(argument: Expression) -> frozenset[Argument] | None:
    if isinstance(argument, Constant):
        return frozenset({argument.value})
    return frozenset(argument.values) if isinstance(argument, Alternatives) else None


def _compatible(head: Form, pattern: Form) -> bool:
    pairs = zip(head, pattern, strict=True)
    return all(one is None or other is None or not one.isdisjoint(other) for one, other in pairs)


def _only_annotates(atom: Atom, rule: RuleTree, annotated: Mapping[str, bool]) -> bool:
    """Whether the asserted fact is one that the rule has joined."""
    said = _spoken(_identity(atom, annotated))
    return said is not None and any(
        isinstance(part, Pattern)
        and not part.absent
        and part.fact.name == atom.name
        and _spoken(_identity(part.fact, annotated)) == said
        for part in rule.statements
    )


def _spoken(arguments: Sequence[Expression]) -> tuple[object, ...] | None:
    """Variables and constants without their positions; None if there is anything else."""
    spoken = tuple(getattr(argument, "name", None) or getattr(argument, "value", None) for argument in arguments)
    return None if None in spoken or any(isinstance(argument, Atom) for argument in arguments) else spoken
