"""The steps by which a rule is matched: each does its part with the environment and hands on to the next.

Every value a step needs lies in a slot of the environment, constants too, so that keys and arguments are picked with
one `itemgetter`. Steps are immutable; what changes is the environment and the `Knowledge`.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeAlias

from ..knowledge import Environment, Fact, Knowledge, Origin, Pick
from ..language.arithmetic import ComputationError
from ..language.tree import Argument

Evaluate: TypeAlias = Callable[[Environment], Argument]


class Step(Protocol):
    """One step of a plan."""

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        """Go on from here, once for every way in which this step can be taken."""


@dataclass(frozen=True, slots=True)
class Shape:
    """What a fact must look like to match a pattern, and what it then says.

    `binds` are (slot, position) of variables it gives a value, `equal` (slot, position) where it must repeat what a
    slot holds, `among` (position, values) where alternatives stand, `slot` where the fact itself goes.
    """

    binds: tuple[tuple[int, int], ...]
    equal: tuple[tuple[int, int], ...]
    among: tuple[tuple[int, frozenset[Argument]], ...]
    slot: int

    def each(self, facts: Sequence[Fact], then: Step, knowledge: Knowledge, environment: Environment) -> None:
        """Run `then` for every one of the facts that has this shape."""
        for fact in facts:
            arguments = fact.arguments
            for position, values in self.among:
                if arguments[position] not in values:
                    break
            else:
                for slot, position in self.binds:
                    environment[slot] = arguments[position]
                for slot, position in self.equal:
                    if environment[slot] != arguments[position]:
                        break
                else:
                    environment[self.slot] = fact
                    then.run(knowledge, environment)


@dataclass(frozen=True, slots=True)
class Join:
    """For every fact that the index holds under the key and that has the shape."""

    index: int
    key: Pick
    shape: Shape
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        facts = knowledge.filed[self.index].get(self.key(environment))
        if facts:
            self.shape.each(facts, self.then, knowledge, environment)


@dataclass(frozen=True, slots=True)
class JoinRecent:
    """For every fact of the last round that has the shape: where a rule begins from what is new.

    `beginning` is the predicate and, where it is a constant, the first argument.
    """

    beginning: tuple[str, Argument | None]
    shape: Shape
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        facts = knowledge.recent.get(self.beginning)
        if facts:
            self.shape.each(facts, self.then, knowledge, environment)


@dataclass(frozen=True, slots=True)
class Absent:
    """Only if the index holds no fact under the key that has one of the alternatives' values."""

    index: int
    key: Pick
    among: tuple[tuple[int, frozenset[Argument]], ...]
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        facts = knowledge.filed[self.index].get(self.key(environment), ())
        for fact in facts:
            if all(fact.arguments[position] in values for position, values in self.among):
                return
        self.then.run(knowledge, environment)


@dataclass(frozen=True, slots=True)
class Compute:
    """Put the value of an expression into a slot."""

    slot: int
    evaluate: Evaluate
    origin: Origin
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        try:
            environment[self.slot] = self.evaluate(environment)
        except ComputationError as error:
            raise self.origin.error(str(error)) from None
        self.then.run(knowledge, environment)


@dataclass(frozen=True, slots=True)
class Test:
    """Only if the guard holds."""

    holds: Callable[[Environment], bool]
    origin: Origin
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        try:
            holds = self.holds(environment)
        except ComputationError as error:
            raise self.origin.error(str(error)) from None
        if holds:
            self.then.run(knowledge, environment)
