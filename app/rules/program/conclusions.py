"""The conclusions of rules: facts are asserted, with claims for their annotations, or choices made."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

from ...model import Argument, Fact
from ..knowledge import (
    AlternativeCalls,
    Call,
    Choice,
    Claim,
    Environment,
    Knowledge,
    Origin,
    Reason,
)
from ..language.arithmetic import ComputationError
from .steps import Evaluate


@dataclass(frozen=True, slots=True)
class LateComputations:
    """The computations of a rule that depend on final annotations.

    `reads` are (variable's slot, joined fact's slot), `computations` (slot, expression, place) in order.
    """

    reads: tuple[tuple[int, int], ...]
    computations: tuple[tuple[int, Evaluate, Origin], ...]

    @property
    def fills(self) -> frozenset[int]:
        """The slots that have no value before."""
        return frozenset((*(slot for slot, _ in self.reads), *(slot for slot, _, _ in self.computations)))

    def fill(self, environment: Environment, annotations: Mapping[Fact, float]) -> None:
        """Put the annotations and the values computed from them into their slots."""
        for slot, fact in self.reads:
            environment[slot] = annotations[environment[fact]]
        for slot, evaluate, origin in self.computations:
            try:
                environment[slot] = evaluate(environment)
            except ComputationError as error:
                raise origin.error(str(error)) from None


@dataclass(frozen=True, slots=True)
class Head:
    """A fact to assert: the slots of its arguments and of its annotation, which is `late` if it depends on
    annotations."""

    predicate: str
    slots: tuple[int, ...]
    annotation: int | None
    late: bool


@dataclass(frozen=True, slots=True)
class Assert:
    """The last step of an assert-rule."""

    heads: tuple[Head, ...]
    annotated: LateComputations
    supports: tuple[int, ...]
    origin: Origin

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        for head in self.heads:
            fact, new = knowledge.add(head.predicate, tuple([environment[slot] for slot in head.slots]))
            if new:
                knowledge.reasons[fact] = Reason(self.origin, tuple([environment[slot] for slot in self.supports]))
                if len(knowledge.facts) > knowledge.limits.facts:
                    raise self.origin.error(f"more than {knowledge.limits.facts} facts; does it compute ever new ones?")
            if head.annotation is None:
                continue
            if head.late:
                reads = tuple([environment[slot] for _, slot in self.annotated.reads])
                claimed = partial(self._claimed, head.annotation, environment.copy())
                knowledge.claims.append(Claim(fact, reads, claimed))
            else:
                knowledge.claim(fact, self._number(environment[head.annotation]))

    def _claimed(self, slot: int, environment: Environment, annotations: Mapping[Fact, float]) -> float:
        """The annotation claimed in `slot`, given the final annotations that the rule reads."""
        self.annotated.fill(environment, annotations)
        return self._number(environment[slot])

    def _number(self, value: Argument) -> float:
        if isinstance(value, str):
            raise self.origin.error(f"an annotation is a number, and {value!r} is a text")
        return value


@dataclass(frozen=True, slots=True)
class Offer:
    """An alternative of a choose-rule: its weight, its guards, and its calls with the slots of their arguments."""

    weight: float
    guards: tuple[tuple[Callable[[Environment], bool], Origin], ...]
    calls: tuple[tuple[str, tuple[int, ...]], ...]

    def is_applicable(self, environment: Environment) -> bool:
        """Whether all guards hold."""
        for holds, origin in self.guards:
            try:
                if not holds(environment):
                    return False
            except ComputationError as error:
                raise origin.error(str(error)) from None
        return True

    def to_alternative(self, environment: Environment) -> AlternativeCalls:
        calls = [Call(name, tuple([environment[slot] for slot in slots])) for name, slots in self.calls]
        return AlternativeCalls(self.weight, tuple(calls))


@dataclass(frozen=True, slots=True)
class Choose:
    """The last step of a choose-rule; without an alternative whose guards hold there is no choice."""

    offers: tuple[Offer, ...]
    annotated: LateComputations
    supports: tuple[int, ...]
    origin: Origin

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        self.annotated.fill(environment, knowledge.annotations)
        alternatives = [offer.to_alternative(environment) for offer in self.offers if offer.is_applicable(environment)]
        if alternatives:
            supports = tuple([environment[slot] for slot in self.supports])
            knowledge.choices.append(Choice(self.origin, supports, tuple(alternatives)))
