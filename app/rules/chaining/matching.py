"""Matches one rule against a complete set of facts, optionally with a few unmet statements, to explain rules to
authors.

Used by `tracing.py`, not for derivation. Once everything is derived, a rule matches exactly where it has fired:
`unless` excludes nothing that was derived after the rule ran (`stratification.py`). Computations on annotations do not
affect matching and are ignored.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import TypeAlias

from ...model import Argument, Fact
from ..language.arithmetic import ComputationError, apply_builtin, apply_operation, compare
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
    Statement,
    Variable,
)
from ..program.planning import variables_of

Bindings: TypeAlias = Mapping[str, Argument]


@dataclass(frozen=True, slots=True)
class FactBase:
    """Facts by predicate, and by predicate, position and argument. Facts have no annotation, patterns may have one."""

    filed: Mapping[object, Sequence[Fact]]

    @classmethod
    def of(cls, facts: Iterable[Fact]) -> "FactBase":
        filed: defaultdict[object, list[Fact]] = defaultdict(list)
        for fact in facts:
            filed[fact.predicate].append(fact)
            for position, argument in enumerate(fact.arguments):
                filed[fact.predicate, position, argument].append(fact)
        return cls(MappingProxyType(dict(filed)))

    def fitting(self, atom: Atom, bindings: Bindings) -> Iterator[tuple[Fact, Bindings]]:
        """The facts that match a pattern under these bindings, each with the resulting bindings."""
        for fact in self.candidates(atom, bindings):
            extended = _unified(atom, fact, bindings)
            if extended is not None:
                yield fact, extended

    def candidates(self, atom: Atom, bindings: Bindings) -> Sequence[Fact]:
        """A small set of facts that includes all that match the pattern."""
        fewest = self.filed.get(atom.name, ())
        for position, argument in enumerate(atom.arguments):
            value = _known(argument, bindings)
            if value is not None and fewest and position < len(fewest[0].arguments):
                fewest = min(fewest, self.filed.get((atom.name, position, value), ()), key=len)
        return fewest


@dataclass(frozen=True, slots=True)
class Match:
    """One match of a rule: the facts joined, by the index of the pattern; `unmet` are statements that do not hold."""

    joined: Mapping[int, Fact]
    bindings: Bindings
    unmet: tuple[Statement, ...]


def matches(rule: RuleTree, facts: FactBase, *, most_unmet: int = 0) -> Iterator[Match]:
    """All matches of the rule in which up to `most_unmet` of its statements may fail.

    A pattern counts as unmet only if no fact matches it; computations cannot be unmet.
    """
    joins = tuple(part for part in rule.statements if isinstance(part, Pattern) and not part.absent)
    conditions = tuple(part for part in rule.statements if part not in joins)
    yield from _continued(_State({}, {}, tuple(enumerate(joins)), conditions, ()), facts, most_unmet)


def substitute(expression: Expression, bindings: Bindings) -> Expression:
    """The expression with its bound variables replaced by their values."""
    if isinstance(expression, Variable):
        value = bindings.get(expression.name)
        return expression if value is None else Constant(value, expression.place)
    if isinstance(expression, ArithmeticOperation):
        left, right = substitute(expression.left, bindings), substitute(expression.right, bindings)
        return replace(expression, left=left, right=right)
    if isinstance(expression, Atom):
        return replace(expression, arguments=tuple(substitute(part, bindings) for part in expression.arguments))
    return expression


@dataclass(frozen=True, slots=True)
class _State:
    bindings: Bindings
    joined: Mapping[int, Fact]
    patterns: tuple[tuple[int, Pattern], ...]
    conditions: tuple[Statement, ...]
    unmet: tuple[Statement, ...]


def _continued(state: _State, facts: FactBase, most_unmet: int) -> Iterator[Match]:
    decided = _decided(state, facts)
    if decided is None or len(decided.unmet) > most_unmet:
        return
    if not decided.patterns:
        if not any(_is_there(part, decided.bindings, facts) for part in decided.unmet):
            yield Match(decided.joined, decided.bindings, decided.unmet)
        return
    chosen = min(decided.patterns, key=lambda pattern: len(facts.candidates(pattern[1].fact, decided.bindings)))
    number, pattern = chosen
    left = replace(decided, patterns=tuple(each for each in decided.patterns if each is not chosen))
    for fact, bindings in facts.fitting(pattern.fact, decided.bindings):
        yield from _continued(replace(left, bindings=bindings, joined={**left.joined, number: fact}), facts, most_unmet)
    yield from _continued(replace(left, unmet=(*left.unmet, pattern)), facts, most_unmet)


def _decided(state: _State, facts: FactBase) -> _State | None:
    """The state after all computations and conditions whose variables are bound; None if a computation is undefined.

    Conditions on variables of an unmet pattern stay undecided and do not prevent the match.
    """
    position = 0
    while position < len(state.conditions):
        condition = state.conditions[position]
        if _inputs(condition) - state.bindings.keys():
            position += 1
            continue
        rest = state.conditions[:position] + state.conditions[position + 1 :]
        try:
            state = _with_condition(replace(state, conditions=rest), condition, facts)
        except ComputationError:
            return None
        position = 0
    return state


def _with_condition(state: _State, condition: Statement, facts: FactBase) -> _State:
    if isinstance(condition, Computation):
        value, name = _value(condition.expression, state.bindings), condition.variable.name
        holds = state.bindings.get(name, value) == value
        state = replace(state, bindings={name: value, **state.bindings})
    elif isinstance(condition, Guard):
        left, right = _value(condition.left, state.bindings), _value(condition.right, state.bindings)
        holds = compare(condition.operator, left, right)
    else:
        holds = next(facts.fitting(condition.fact, state.bindings), None) is None
    return state if holds else replace(state, unmet=(*state.unmet, condition))


def _is_there(unmet: Statement, bindings: Bindings, facts: FactBase) -> bool:
    """Whether the statement is a pattern that a fact matches after all: then that fact leads to a match, or to what is
    unmet."""
    if not isinstance(unmet, Pattern) or unmet.absent:
        return False
    return next(facts.fitting(unmet.fact, bindings), None) is not None


def _inputs(condition: Statement) -> frozenset[str]:
    if isinstance(condition, Pattern):
        return variables_of(condition.fact)
    if isinstance(condition, Guard):
        return variables_of(condition.left) | variables_of(condition.right)
    return variables_of(condition.expression)


def _unified(atom: Atom, fact: Fact, bindings: Bindings) -> Bindings | None:
    found = dict(bindings)
    for argument, value in zip(atom.arguments, fact.arguments, strict=False):  # patterns may have an annotation
        if isinstance(argument, Alternatives):
            fits = value in argument.values
        elif isinstance(argument, Variable):
            fits = found.setdefault(argument.name, value) == value
        else:
            fits = not isinstance(argument, Constant) or argument.value == value
        if not fits:
            return None
    return found


def _known(argument: Expression, bindings: Bindings) -> Argument | None:
    if isinstance(argument, Variable):
        return bindings.get(argument.name)
    return argument.value if isinstance(argument, Constant) else None


def _value(expression: Expression, bindings: Bindings) -> Argument:
    if isinstance(expression, Variable):
        return bindings[expression.name]
    if isinstance(expression, ArithmeticOperation):
        return apply_operation(
            expression.operator, _value(expression.left, bindings), _value(expression.right, bindings)
        )
    if isinstance(expression, Atom):
        return apply_builtin(expression.name, [_value(part, bindings) for part in expression.arguments])
    assert isinstance(expression, Constant)
    return expression.value
