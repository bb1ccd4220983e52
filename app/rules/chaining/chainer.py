"""Forward chaining: derives all facts that follow from given facts and a program, each with its reason (§3.3).

Facts are derived in rounds (semi-naive evaluation). In a stratum's first round every rule runs once on all facts, in
later rounds only on the facts added in the round before. Facts become visible in the round after they were derived, so
the rounds, and with them the first derivation of each fact, depend only on the program and the set of given facts: the
recorded reason is that of the earliest round and, within it, of the first rule in the order of the program. Annotations
are computed when all facts are known, and choose-rules run last.

Annotations do not depend on the order in which rules ran.

Every match of a rule *claims* an annotation for the fact it asserts; the highest claim counts. A claim that depends on
other facts' annotations is evaluated when these are final: facts are processed in order of dependence. Facts whose
claims depend on each other cyclically (a *knot*; the smallest is a fact raised by a rule that joins it) have no such
order. In a knot, claims that do not depend on the knot are evaluated first; then, in rounds, every claim whose facts
have values by then, each claim once, all claims of a round with the values before the round. So a rule that raises the
annotation of a fact it joins does so once, from the value without that rule; two such rules on one fact raise it to the
higher of both, not twice.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from ...model import Argument, Fact
from ..knowledge import AlternativeCalls, Call, Choice, Claim, Knowledge, Limits, Reason
from ..program.loading import Program, Stratum


@dataclass(frozen=True, slots=True)
class Derivation:
    """The result: facts in order of derivation, given ones first, and choices in the order of the rules."""

    facts: tuple[Fact, ...]
    choices: tuple[Choice, ...]
    annotations: Mapping[Fact, float]
    reasons: Mapping[Fact, Reason]

    def annotation(self, fact: Fact) -> float | None:
        """The merged annotation of a fact; None if its predicate has none, or the fact is unknown."""
        return self.annotations.get(fact)

    def reason(self, fact: Fact) -> Reason | None:
        """The first derivation of a fact; None if it was given, or is unknown."""
        return self.reasons.get(fact)


def derive(
    program: Program,
    given: Iterable[Fact],
    *,
    annotations: Mapping[Fact, float] = MappingProxyType({}),
    limits: Limits = Limits(),  # noqa: B008  # frozen
) -> Derivation:
    """Everything that follows from `given`; given facts of annotated predicates have their annotation in `annotations`,
    or 0.

    Raises AuthoringError, naming the rule, if the limits are exceeded or a computation is undefined; ValueError if a
    given fact's predicate is not declared.
    """
    facts = list(given)
    _refuse_undeclared(program, facts)
    knowledge = Knowledge(program.indexes, limits)
    knowledge.give(facts)
    annotated = (fact for fact in facts if program.predicates[fact.predicate].annotation)
    knowledge.annotations.update((fact, annotations.get(fact, 0.0)) for fact in annotated)
    for stratum in program.strata:
        _close(stratum, knowledge)
    annotate(knowledge.claims, knowledge.annotations)
    for plan in program.choosers:
        plan.run(knowledge)
    return Derivation(
        facts=tuple(knowledge.facts),
        choices=tuple(knowledge.choices),
        annotations=MappingProxyType(knowledge.annotations),
        reasons=MappingProxyType(knowledge.reasons),
    )


def _refuse_undeclared(program: Program, facts: Iterable[Fact]) -> None:
    arities = {name: len(predicate.parameters) for name, predicate in program.predicates.items()}
    for fact in facts:
        if arities.get(fact.predicate) != len(fact.arguments):
            raise ValueError(f"given fact {fact}: no such predicate is declared")


def _close(stratum: Stratum, knowledge: Knowledge) -> None:
    """Run the rules of a stratum to a fixed point."""
    for plan in stratum.first:
        plan.run(knowledge)
    rounds = 1
    while knowledge.end_round() and stratum.later:
        if rounds == knowledge.limits.rounds:
            raise knowledge.blamed().error(f"new facts still follow after {rounds} rounds; is a computation endless?")
        for plan in stratum.due(knowledge.recent):
            plan.run(knowledge)
        rounds += 1


def annotate(claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    """Add to `annotations`, which contains given values and unconditional claims, the values that result from
    `claims`."""
    claims_on: defaultdict[Fact, list[Claim]] = defaultdict(list)
    for claim in claims:
        claims_on[claim.fact].append(claim)
    for knot in _knots(claims_on):
        _settle(set(knot), [claim for fact in knot for claim in claims_on[fact]], annotations)


def _settle(knot: set[Fact], claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    entering, waiting = _parted(claims, lambda claim: knot.isdisjoint(claim.reads))
    _make(entering, annotations)
    while waiting:
        ready, waiting = _parted(waiting, lambda claim: all(fact in annotations for fact in claim.reads))
        _make(ready, annotations)


def _parted(claims: Sequence[Claim], holds: Callable[[Claim], bool]) -> tuple[list[Claim], list[Claim]]:
    """The claims that satisfy the condition, and the others."""
    parts: tuple[list[Claim], list[Claim]] = ([], [])
    for claim in claims:
        parts[not holds(claim)].append(claim)
    return parts


def _make(claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    """Evaluate these claims at once: none sees the result of another."""
    claimed = [(claim.fact, claim.value(annotations)) for claim in claims]
    for fact, value in claimed:
        if fact not in annotations or value > annotations[fact]:
            annotations[fact] = value


def _knots(claims_on: Mapping[Fact, Sequence[Claim]]) -> Iterator[list[Fact]]:
    """The strongly connected components of the dependence between facts, dependencies first (Tarjan's algorithm)."""
    search = _Search(claims_on)
    for root in claims_on:
        if root in search.number:
            continue
        ways = [(root, search.enter(root))]
        while ways:
            fact, reads = ways[-1]
            onward = next(reads, None)
            if onward is None:
                ways.pop()
                if ways:
                    search.lower(ways[-1][0], search.low[fact])
                if search.low[fact] == search.number[fact]:
                    yield search.leave(fact)
            elif onward not in search.number:
                ways.append((onward, search.enter(onward)))
            elif onward in search.open:
                search.lower(fact, search.number[onward])


@dataclass(slots=True)
class _Search:
    """The state of Tarjan's search: visit numbers, lowest number reachable from each, and the stack of open facts."""

    claims_on: Mapping[Fact, Sequence[Claim]]
    number: dict[Fact, int] = field(default_factory=dict)
    low: dict[Fact, int] = field(default_factory=dict)
    open: dict[Fact, None] = field(default_factory=dict)

    def enter(self, fact: Fact) -> Iterator[Fact]:
        """Number the fact; yields the facts it depends on that have claims and are still to be visited."""
        self.number[fact] = self.low[fact] = len(self.number)
        self.open[fact] = None
        return iter([read for claim in self.claims_on[fact] for read in claim.reads if read in self.claims_on])

    def lower(self, fact: Fact, number: int) -> None:
        self.low[fact] = min(self.low[fact], number)

    def leave(self, root: Fact) -> list[Fact]:
        """The knot whose first fact is `root`."""
        knot = []
        while root in self.open:
            knot.append(self.open.popitem()[0])
        return knot


__all__ = ["AlternativeCalls", "Argument", "Call", "Choice", "Derivation", "Fact", "Limits", "Reason", "derive"]
