"""The steps of matching a rule: each extends the environment and calls the next.

All values that steps need are in slots of the environment, including constants, so that keys and arguments are picked
with one `itemgetter`. Steps are immutable; only the environment and the `Knowledge` change.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeAlias

from ...model import Argument, Fact
from ..knowledge import (
    Beginning,
    Environment,
    Knowledge,
    Origin,
    Pick,
)
from ..language.arithmetic import ComputationError

FEW = 16
"""For at most this many facts, looking at all is faster than a sorted lookup."""

Evaluate: TypeAlias = Callable[[Environment], Argument]


class Step(Protocol):
    """One step of a plan."""

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        """Continue from here, once for each way in which this step can be taken."""


@dataclass(frozen=True, slots=True)
class Shape:
    """The conditions under which a fact matches a pattern, and the values it then provides.

    `binds` are (slot, position) of variables that it binds, `equal` (slot, position) of values that it must repeat,
    `among` (position, values) of alternatives, `slot` is for the fact itself.
    """

    binds: tuple[tuple[int, int], ...]
    equal: tuple[tuple[int, int], ...]
    among: tuple[tuple[int, frozenset[Argument]], ...]
    slot: int

    def each(self, facts: Sequence[Fact], then: Step, knowledge: Knowledge, environment: Environment) -> None:
        """Run `then` for each of the facts that match."""
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
    """For each fact in the index under the key that has the shape."""

    index: int
    key: Pick
    shape: Shape
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        facts = knowledge.filed[self.index].get(self.key(environment))
        if facts:
            self.shape.each(facts, self.then, knowledge, environment)


@dataclass(frozen=True, slots=True)
class JoinBetween:
    """As `Join`, if guards restrict the argument at `position` to a range of numbers: if there are many facts under the
    key, only those in the range are tried. The guards are still tested afterwards, so the range may be wider than
    theirs."""

    index: int
    key: Pick
    position: int
    least: Evaluate
    most: Evaluate
    shape: Shape
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        key = self.key(environment)
        facts = knowledge.filed[self.index].get(key)
        if facts:
            found = self._between(facts, key, knowledge, environment) if len(facts) > FEW else facts
            self.shape.each(found, self.then, knowledge, environment)

    def _between(
        self, facts: Sequence[Fact], key: object, knowledge: Knowledge, environment: Environment
    ) -> Sequence[Fact]:
        try:
            least, most = self.least(environment), self.most(environment)
        except ComputationError:  # reported by the guard's own test, if it is reached
            return facts
        return knowledge.between(self.index, key, self.position, least=least, most=most)


@dataclass(frozen=True, slots=True)
class JoinRecent:
    """For each fact of the last round that has the shape: the start of an incremental plan.

    `beginning` is the predicate and, if it is a constant, the first argument.
    """

    beginning: Beginning
    shape: Shape
    then: Step

    def run(self, knowledge: Knowledge, environment: Environment) -> None:
        facts = knowledge.recent.get(self.beginning)
        if facts:
            self.shape.each(facts, self.then, knowledge, environment)


@dataclass(frozen=True, slots=True)
class Absent:
    """Continue only if the index has no fact under the key with one of the alternatives' values."""

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
    """Continue only if the guard holds."""

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
