"""Plans the matching of a checked rule: the order of its patterns, determined once when rules are loaded.

A plan starts from all facts or, in one plan per pattern, from the facts that the last round added for that pattern; it
continues with the pattern that has most arguments bound. Computations, guards and `unless` are evaluated as soon as
their variables are bound. Annotations are left out: they are computed when all facts are known (`chaining/chainer.py`).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial

from ...model import Argument
from ..knowledge import Beginning, Environment, Index, Knowledge, Origin, Pick, pick
from ..language.arithmetic import apply_builtin, apply_operation, compare
from ..language.tree import (
    Alternatives,
    ArithmeticOperation,
    Atom,
    Computation,
    Constant,
    Expression,
    Guard,
    Pattern,
    RuleTree,
    SourcePosition,
    Statement,
    Variable,
)
from .steps import Absent, Compute, Evaluate, Join, JoinBetween, JoinRecent, Shape, Step, Test

_MIRRORED = {"<": ">", ">": "<", "=": "=", "!": "!"}
"""The operators with sides exchanged, by first character."""

_INVERSE = {"+": "-", "-": "+"}


@dataclass(frozen=True, slots=True)
class MatchPlan:
    """One way to match a rule: `template` is the initial environment.

    A plan that starts from new facts only needs to run if the last round added facts under one of `beginnings`.
    """

    template: tuple[object, ...]
    begin: Step
    beginnings: tuple[Beginning, ...] = ()

    def run(self, knowledge: Knowledge) -> None:
        """Find all matches of the rule, and draw its conclusions."""
        self.begin.run(knowledge, list(self.template))


@dataclass(frozen=True, slots=True)
class Plans:
    """The plans of one rule: from all facts, and, one per pattern, from the facts that are new to it."""

    from_all: MatchPlan
    from_recent: tuple[MatchPlan, ...]


@dataclass(slots=True)
class SlotLayout:
    """Assigns slots to the constants, variables and facts of one rule, and compiles its expressions to functions.

    `annotated` tells which predicates have an annotation as their last argument.
    """

    annotated: Mapping[str, bool]
    locate: Callable[[SourcePosition], Origin]
    template: list[object] = field(default_factory=list)
    _slots: dict[object, int] = field(default_factory=dict)

    def slot(self, key: object, value: object = None) -> int:
        """The slot of `key`, created on first use with `value` in the template."""
        if key not in self._slots:
            self._slots[key] = len(self.template)
            self.template.append(value)
        return self._slots[key]

    def variable(self, name: str) -> int:
        return self.slot(("variable", name))

    def constant(self, value: Argument) -> int:
        return self.slot(("constant", type(value), value), value)

    def fact(self, pattern: int) -> int:
        """The slot of the fact joined by the rule's `pattern`-th positive pattern."""
        return self.slot(("fact", pattern))

    def identity(self, atom: Atom) -> tuple[Expression, ...]:
        """The arguments of an atom without its annotation."""
        return atom.arguments[:-1] if self.annotated[atom.name] else atom.arguments

    def evaluator(self, expression: Expression) -> Evaluate:
        """The expression as a function of the environment, which may raise ComputationError."""
        if isinstance(expression, Variable):
            return pick((self.variable(expression.name),))
        if isinstance(expression, Constant):
            return pick((self.constant(expression.value),))
        if isinstance(expression, ArithmeticOperation):
            left, right = self.evaluator(expression.left), self.evaluator(expression.right)
            return partial(_operation, expression.operator, left, right)
        if isinstance(expression, Atom):
            return partial(_builtin, expression.name, tuple(self.evaluator(part) for part in expression.arguments))
        raise AssertionError(f"unchecked: {expression} has no value")

    def test(self, guard: Guard) -> Callable[[Environment], bool]:
        """The guard as a function of the environment, which may raise ComputationError."""
        return partial(_comparison, guard.operator, self.evaluator(guard.left), self.evaluator(guard.right))


def plans(
    rule: RuleTree, layout: SlotLayout, indexes: dict[Index, int], *, computed: Sequence[Computation], last: Step
) -> Plans:
    """The plans of a checked rule, each ending in `last`; indexes they need are assigned numbers in `indexes`.

    `computed` are the computations to include: the rule's own except those on annotations, and those in the
    conclusion's arguments.
    """
    joins = [part for part in rule.statements if isinstance(part, Pattern) and not part.absent]
    conditions: list[Statement] = [*computed, *(part for part in rule.statements if isinstance(part, Guard))]
    conditions += [part for part in rule.statements if isinstance(part, Pattern) and part.absent]
    planner = _Planner(layout, indexes, joins, last)
    numbers = tuple(range(len(joins)))
    from_all = planner.rest(frozenset(), numbers, tuple(conditions))
    from_recent = tuple(
        (planner.beginning(number, numbers, tuple(conditions)), planner.beginnings(number)) for number in numbers
    )
    template = tuple(layout.template)
    return Plans(MatchPlan(template, from_all), tuple(MatchPlan(template, *each) for each in from_recent))


def variables_of(expression: Expression) -> frozenset[str]:
    """The names of the variables in an expression."""
    if isinstance(expression, Variable):
        return frozenset({expression.name})
    if isinstance(expression, ArithmeticOperation):
        return variables_of(expression.left) | variables_of(expression.right)
    if isinstance(expression, Atom):
        return frozenset().union(*map(variables_of, expression.arguments))
    return frozenset()


@dataclass(frozen=True, slots=True)
class _Planner:
    layout: SlotLayout
    indexes: dict[Index, int]
    joins: Sequence[Pattern]
    last: Step

    def rest(self, bound: frozenset[str], joins: tuple[int, ...], conditions: tuple[Statement, ...]) -> Step:
        """The remaining steps when the variables in `bound` have values."""
        for position, condition in enumerate(conditions):
            if self._inputs(condition) <= bound:
                return self._condition(condition, bound, joins, conditions[:position] + conditions[position + 1 :])
        if not joins:
            return self.last
        chosen = max(joins, key=lambda number: (self._known(number, bound), -number))
        left = tuple(number for number in joins if number != chosen)
        return self._join(chosen, bound, left, conditions)

    def beginning(self, chosen: int, joins: tuple[int, ...], conditions: tuple[Statement, ...]) -> Step:
        """The plan that starts from the facts new to the pattern `chosen`."""
        atom = self.joins[chosen].fact
        arguments = self.layout.identity(atom)
        then = self.rest(_bound_by(arguments), tuple(number for number in joins if number != chosen), conditions)
        first = arguments[0].value if arguments and isinstance(arguments[0], Constant) else None
        return JoinRecent((atom.name, first), self._shape(chosen, frozenset(), keyed=False), then)

    def beginnings(self, chosen: int) -> tuple[Beginning, ...]:
        """The keys under which a round must have added facts for the pattern `chosen` to have new matches."""
        atom = self.joins[chosen].fact
        first = next(iter(self.layout.identity(atom)), None)
        values = first.values if isinstance(first, Alternatives) else ()
        values = (first.value,) if isinstance(first, Constant) else values
        return tuple((atom.name, value) for value in values) or ((atom.name, None),)

    def _join(
        self, chosen: int, bound: frozenset[str], joins: tuple[int, ...], conditions: tuple[Statement, ...]
    ) -> Step:
        atom = self.joins[chosen].fact
        arguments = self.layout.identity(atom)
        index, key = self._lookup(atom, bound)
        then = self.rest(bound | _bound_by(arguments), joins, conditions)
        shape = self._shape(chosen, bound, keyed=True)
        for position, argument in enumerate(arguments):
            if isinstance(argument, Variable) and argument.name not in bound:
                limits = _limits(argument.name, conditions, bound)
                if limits is not None:
                    least, most = map(self.layout.evaluator, limits)
                    return JoinBetween(index, key, position, least, most, shape, then)
        return Join(index, key, shape, then)

    def _condition(
        self, condition: Statement, bound: frozenset[str], joins: tuple[int, ...], conditions: tuple[Statement, ...]
    ) -> Step:
        if isinstance(condition, Pattern):
            index, key = self._lookup(condition.fact, bound)
            return Absent(index, key, _among(self.layout.identity(condition.fact)), self.rest(bound, joins, conditions))
        if isinstance(condition, Guard):
            origin = self.layout.locate(condition.place)
            return Test(self.layout.test(condition), origin, self.rest(bound, joins, conditions))
        name, origin = condition.variable.name, self.layout.locate(condition.variable.place)
        if name in bound:
            equal = Guard("==", condition.variable, condition.expression, condition.variable.place)
            return Test(self.layout.test(equal), origin, self.rest(bound, joins, conditions))
        then = self.rest(bound | {name}, joins, conditions)
        return Compute(self.layout.variable(name), self.layout.evaluator(condition.expression), origin, then)

    def _inputs(self, condition: Statement) -> frozenset[str]:
        if isinstance(condition, Pattern):
            return _bound_by(self.layout.identity(condition.fact))
        if isinstance(condition, Guard):
            return variables_of(condition.left) | variables_of(condition.right)
        return variables_of(condition.expression)

    def _known(self, number: int, bound: frozenset[str]) -> float:
        """The selectivity of a pattern: its constants and bound variables, alternatives counting half."""
        arguments = self.layout.identity(self.joins[number].fact)
        return len(_keyed(arguments, bound)) + 0.5 * len(_among(arguments))

    def _lookup(self, atom: Atom, bound: frozenset[str]) -> tuple[int, Pick]:
        """The index by the bound arguments of `atom`, and the function that picks the key from the environment."""
        arguments = self.layout.identity(atom)
        positions = _keyed(arguments, bound)
        index = self.indexes.setdefault(Index(atom.name, positions), len(self.indexes))
        return index, pick(tuple(self._slot(arguments[position]) for position in positions))

    def _shape(self, number: int, bound: frozenset[str], *, keyed: bool) -> Shape:
        """The remaining conditions on a fact; with `keyed` the index covers the bound arguments."""
        arguments = self.layout.identity(self.joins[number].fact)
        binds: dict[str, tuple[int, int]] = {}
        equal: list[tuple[int, int]] = []
        for position, argument in enumerate(arguments):
            known = isinstance(argument, Constant) or (isinstance(argument, Variable) and argument.name in bound)
            if isinstance(argument, Variable) and not known and argument.name not in binds:
                binds[argument.name] = (self._slot(argument), position)
            elif isinstance(argument, Variable | Constant) and not (known and keyed):
                equal.append((self._slot(argument), position))
        return Shape(tuple(binds.values()), tuple(equal), _among(arguments), self.layout.fact(number))

    def _slot(self, argument: Expression) -> int:
        if isinstance(argument, Variable):
            return self.layout.variable(argument.name)
        if isinstance(argument, Constant):
            return self.layout.constant(argument.value)
        raise AssertionError(f"unchecked: {argument} in a pattern")


def _bound_by(arguments: Sequence[Expression]) -> frozenset[str]:
    return frozenset(argument.name for argument in arguments if isinstance(argument, Variable))


def _keyed(arguments: Sequence[Expression], bound: frozenset[str]) -> tuple[int, ...]:
    return tuple(
        position
        for position, argument in enumerate(arguments)
        if isinstance(argument, Constant) or (isinstance(argument, Variable) and argument.name in bound)
    )


def _among(arguments: Sequence[Expression]) -> tuple[tuple[int, frozenset[Argument]], ...]:
    return tuple(
        (position, frozenset(argument.values))
        for position, argument in enumerate(arguments)
        if isinstance(argument, Alternatives)
    )


def _limits(
    variable: str, conditions: Sequence[Statement], bound: frozenset[str]
) -> tuple[Expression, Expression] | None:
    """The lower and upper bound that guards put on a variable, given bound variables; None unless there are both."""
    limits: dict[str, Expression] = {}
    for guard in (part for part in conditions if isinstance(part, Guard)):
        for side, other, mirrored in ((guard.left, guard.right, False), (guard.right, guard.left, True)):
            alone, limit = _moved(side, other)
            if isinstance(alone, Variable) and alone.name == variable and variables_of(limit) <= bound:
                limits.setdefault(_MIRRORED[guard.operator[0]] if mirrored else guard.operator[0], limit)
    return (limits[">"], limits["<"]) if limits.keys() >= {"<", ">"} else None


def _moved(side: Expression, other: Expression) -> tuple[Expression, Expression]:
    """The sides of a guard, with a whole number added to or subtracted from this side moved to the other."""
    if not isinstance(side, ArithmeticOperation) or side.operator not in _INVERSE:
        return side, other
    if isinstance(side.right, Constant) and isinstance(side.right.value, int):
        return side.left, ArithmeticOperation(_INVERSE[side.operator], other, side.right, side.place)
    return side, other


def _operation(sign: str, left: Evaluate, right: Evaluate, environment: Environment) -> Argument:
    return apply_operation(sign, left(environment), right(environment))


def _builtin(name: str, arguments: tuple[Evaluate, ...], environment: Environment) -> Argument:
    return apply_builtin(name, [argument(environment) for argument in arguments])


def _comparison(sign: str, left: Evaluate, right: Evaluate, environment: Environment) -> bool:
    return compare(sign, left(environment), right(environment))
