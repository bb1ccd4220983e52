"""Forward chaining: from given facts and a program to all facts that follow, each with the reason it is there (§3.3).

Facts are found in rounds (semi-naive evaluation). In a stratum's first round every rule runs once on all facts, in
later rounds only on what the round before brought. What a round finds is seen from the next round on, so the rounds,
and with them the first derivation of each fact, do not depend on anything but the program and the set of given facts:
the reason kept is of the earliest round and, within it, of the first rule in the order of the program. Annotations
are computed when all facts are known (`annotations.py`), and choose-rules run last.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from ..knowledge import Alternative, Call, Choice, Fact, Knowledge, Limits, Reason
from ..language.tree import Argument
from ..program.program import Program, Stratum
from .annotations import annotate

__all__ = ["Alternative", "Argument", "Call", "Choice", "Derivation", "Fact", "Limits", "Reason", "derive"]


@dataclass(frozen=True, slots=True)
class Derivation:
    """All that follows: the facts in order of derivation, given ones first, and the choices in order of the rules."""

    facts: tuple[Fact, ...]
    choices: tuple[Choice, ...]
    annotations: Mapping[Fact, float]
    reasons: Mapping[Fact, Reason]

    def annotation(self, fact: Fact) -> float | None:
        """The merged annotation of a fact; None when its predicate has none, or the fact is not known."""
        return self.annotations.get(fact)

    def reason(self, fact: Fact) -> Reason | None:
        """The first derivation of a fact; None when it was given, or is not known."""
        return self.reasons.get(fact)

    def grounds(self, fact: Fact) -> tuple[Fact, ...]:
        """The given facts at the bottom of the first derivation of `fact`, each once, in the order they are met."""
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
    """Everything that follows from `given`; given facts of annotated predicates have the annotation given, or 0.

    Raises AuthoringError, naming the rule, when it goes beyond the limits or computes what cannot be computed;
    ValueError when a given fact is none of the declared predicates'.
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
    """Run the rules of a stratum until nothing follows any more."""
    for plan in stratum.first:
        plan.run(knowledge)
    rounds = 1
    while knowledge.end_round() and stratum.later:
        if rounds == knowledge.limits.rounds:
            raise knowledge.blamed().error(f"facts still follow after {rounds} rounds; does it compute ever new ones?")
        for plan in stratum.later:
            plan.run(knowledge)
        rounds += 1
