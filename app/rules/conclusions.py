"""What happens where a rule holds: facts are asserted, with what they claim for their annotation, or choices offered."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

from app.rules.arithmetic import ComputationError
from app.rules.knowledge import Claim, Environment, Fact, Knowledge, Origin, Reason
from app.rules.steps import Evaluate
from app.rules.tree import Argument


@dataclass(frozen=True, slots=True)
class Call:
    """A behaviour, and what it is asked to span or show."""

    name: str
    arguments: tuple[Argument, ...]


@dataclass(frozen=True, slots=True)
class Alternative:
    """Behaviours to be shown together; how often, is `weight` over the sum of the alternatives' weights."""

    weight: float
    calls: tuple[Call, ...]


@dataclass(frozen=True, slots=True)
class Choice:
    """What a choose-rule offers where it holds: the alternatives whose guard holds, and the facts it joined."""

    rule: str
    path: Path
    line: int
    supports: tuple[Fact, ...]
    alternatives: tuple[Alternative, ...]


@dataclass(frozen=True, slots=True)
class Annotated:
    """What a rule computes from annotations, once they are final.

    `reads` are (variable's slot, joined fact's slot), `computations` (slot, expression, place) in order.
    """

    reads: tuple[tuple[int, int], ...]
    computations: tuple[tuple[int, Evaluate, Origin], ...]

    def fill(self, environment: Environment, annotations: dict[Fact, float]) -> None:
        """Put the annotations and what is computed from them into their slots."""
        for slot, fact in self.reads:
            environment[slot] = annotations[environment[fact]]
        for slot, evaluate, origin in self.computations:
            environment[slot] = _evaluated(evaluate, environment, origin)


@dataclass(frozen=True, slots=True)
class Head:
    """A fact to assert: slots of its arguments, and the expression that claims its annotation, if it has one."""

    predicate: str
    slots: tuple[int, ...]
    annotation: Evaluate | None


@dataclass(frozen=True, slots=True)
class Assert:
    """The last step of an assert-rule."""

    heads: tuple[Head, ...]
    annotated: Annotated
    supports: tuple[int, ...]
    origin: Origin

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        for head in self.heads:
            fact, new = knowledge.add(head.predicate, tuple([environment[slot] for slot in head.slots]))
            if new:
                supports = tuple(environment[slot] for slot in self.supports)
                knowledge.reasons[fact] = Reason(self.origin, supports)
                if len(knowledge.facts) > knowledge.limits.facts:
                    raise self.origin.error(f"more than {knowledge.limits.facts} facts; does it compute ever new ones?")
            if head.annotation is not None:
                reads = tuple(environment[slot] for _, slot in self.annotated.reads)
                knowledge.claims.append(Claim(fact, reads, self._claim(head.annotation, environment.copy())))

    def _claim(self, annotation: Evaluate, environment: Environment) -> Callable[[dict[Fact, float]], float]:
        def claimed(annotations: dict[Fact, float]) -> float:
            self.annotated.fill(environment, annotations)
            value = _evaluated(annotation, environment, self.origin)
            if isinstance(value, str):
                raise self.origin.error(f"an annotation is a number, and {value!r} is a text")
            return value

        return claimed


_Guards: TypeAlias = tuple[tuple[Callable[[Environment], bool], Origin], ...]


@dataclass(frozen=True, slots=True)
class Offer:
    """An alternative of a choose-rule: its weight, its guards and the behaviours it calls."""

    weight: float
    guards: _Guards
    calls: tuple[tuple[str, tuple[Evaluate, ...]], ...]

    def stands(self, environment: Environment) -> bool:
        """Whether every guard holds."""
        return all(_evaluated(holds, environment, origin) for holds, origin in self.guards)


@dataclass(frozen=True, slots=True)
class Choose:
    """The last step of a choose-rule; where no alternative's guards hold there is no choice."""

    offers: tuple[Offer, ...]
    annotated: Annotated
    supports: tuple[int, ...]
    origin: Origin

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        self.annotated.fill(environment, knowledge.annotations)
        alternatives = tuple(
            Alternative(
                offer.weight,
                tuple(
                    Call(name, tuple(_evaluated(argument, environment, self.origin) for argument in arguments))
                    for name, arguments in offer.calls
                ),
            )
            for offer in self.offers
            if offer.stands(environment)
        )
        if alternatives:
            supports = tuple(environment[slot] for slot in self.supports)
            knowledge.choices.append(
                Choice(self.origin.rule, self.origin.path, self.origin.line, supports, alternatives)
            )


def _evaluated(evaluate: Evaluate, environment: Environment, origin: Origin) -> Argument:
    try:
        return evaluate(environment)
    except ComputationError as error:
        raise origin.error(str(error)) from None
