"""Forward chaining: derives all facts that follow from given facts and a program, each with its reason (§3.3).

Facts are derived in rounds (semi-naive evaluation). In a stratum's first round every rule runs once on all facts, in
later rounds only on the facts added in the round before. Facts become visible in the round after they were derived, so
the rounds, and with them the first derivation of each fact, depend only on the program and the set of given facts: the
recorded reason is that of the earliest round and, within it, of the first rule in the order of the program. Annotations
are computed when all facts are known (`annotations.py`), and choose-rules run last.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from ...model import Argument, Fact
from ..knowledge import (
    Alternative,
    Call,
    Choice,
    Knowledge,
    Limits,
    Reason,
)
from ..program.program import Program, Stratum
from .annotations import annotate

__all__ = ["Alternative", "Argument", "Call", "Choice", "Derivation", "Fact", "Limits", "Reason", "derive"]


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

    def grounds(self, fact: Fact) -> tuple[Fact, ...]:
        """The given facts on which the first derivation of `fact` rests, without duplicates, in order of traversal."""
        found: dict[Fact, None] = {}
        visited: set[Fact] = set()
        waiting = [fact]
        while waiting:
            current = waiting.pop()
            reason = self.reasons.get(current)
            if reason is None:
                found[current] = None
            elif current not in visited:
                visited.add(current)
                waiting.extend(reversed(reason.supports))
        return tuple(found)


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
            raise ValueError(f"given fact {fact}: no predicate is declared so")


def _close(stratum: Stratum, knowledge: Knowledge) -> None:
    """Run the rules of a stratum to a fixed point."""
    for plan in stratum.first:
        plan.run(knowledge)
    rounds = 1
    while knowledge.end_round() and stratum.later:
        if rounds == knowledge.limits.rounds:
            raise knowledge.blamed().error(f"facts still follow after {rounds} rounds; does it compute ever new ones?")
        for plan in stratum.due(knowledge.recent):
            plan.run(knowledge)
        rounds += 1
