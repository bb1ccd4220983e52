"""Finds the mistakes of single rules, given the declarations.

Annotations must not determine which facts exist, since they are computed afterwards (`chaining/chainer.py`): a variable
bound to an annotation, and every variable computed from one, may only occur in asserted annotations and in calls of
behaviours.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from ...errors import did_you_mean
from ...model import CallableNames
from ..language.arithmetic import BUILTINS, is_ordering
from ..language.tree import (
    ALWAYS,
    NEVER,
    Alternatives,
    ArithmeticOperation,
    Assertion,
    Atom,
    ChooseClause,
    Computation,
    Constant,
    Expression,
    Guard,
    Pattern,
    PredicateTree,
    RuleTree,
    SourcePosition,
    Variable,
    WeightedCalls,
    Wildcard,
)
from .compiling import annotation_variables, late_computations
from .planning import variables_of
from .stratification import asserted

Located = tuple[SourcePosition, str]

MOST_STATEMENTS = 50
"""The maximum depth of a plan; a longer rule would be unreadable anyway."""


@dataclass(frozen=True, slots=True)
class Declarations:
    """The declarations that rules can refer to. Those in `unread` exist but could not be parsed and are not checked.
    `annotated` tells whether each predicate's last argument is an annotation. `behaviors` may be chosen."""

    predicates: Mapping[str, PredicateTree]
    annotated: Mapping[str, bool]
    unread: frozenset[str]
    behaviors: CallableNames | None

    def facts_of(self, rule: RuleTree) -> tuple[Atom, ...]:
        """All facts that a rule joins, excludes or asserts."""
        return (*(part.fact for part in rule.statements if isinstance(part, Pattern)), *asserted(rule))


def rule_mistakes(rule: RuleTree, declared: Declarations) -> Iterator[Located]:
    """All mistakes in `rule`; those of its annotations only if its facts are correct, since they determine what is
    one."""
    yield from _parts(rule)
    yield from _behaviors(rule, declared)
    for expression in _expressions(rule):
        yield from _values(expression)
    for guard in _guards(rule):
        yield from _comparable(guard)
    yield from _unbound(rule)
    unsound = [mistake for atom in declared.facts_of(rule) for mistake in _fact(atom, declared)]
    yield from unsound
    if unsound or any(atom.name in declared.unread for atom in declared.facts_of(rule)):
        return
    for pattern in _patterns(rule):
        yield from _pattern(pattern, declared)
    yield from _annotations(rule, declared)


def _parts(rule: RuleTree) -> Iterator[Located]:
    """Missing or superfluous parts."""
    if not any(isinstance(part, Pattern) and not part.absent for part in rule.statements):
        yield rule.place, f"rule {rule.name} joins no fact: `foreach` needs one that is not under `unless`"
    if len(rule.statements) > MOST_STATEMENTS:
        yield rule.place, f"rule {rule.name} has more than {MOST_STATEMENTS} statements; make it several rules"
    if not rule.conclusions:
        yield rule.place, f"rule {rule.name} concludes nothing: it must end in `assert` or in `choose`"
    for part in rule.conclusions[1:]:
        yield part.place, f"rule {rule.name} has concluded already: one `assert` or one `choose` ends a rule"
    yield from _conclusions(rule)


def _conclusions(rule: RuleTree) -> Iterator[Located]:
    for part in rule.conclusions:
        if isinstance(part, Assertion) and not part.facts:
            yield part.place, "expected a fact to assert below `assert`"
        if isinstance(part, ChooseClause) and not part.alternatives:
            yield part.place, "expected an alternative below `choose`: `weight NUMBER`, and behaviours below that"
    for alternative in _alternatives(rule):
        if alternative.weight <= 0 and alternative.weight != NEVER:
            yield alternative.place, f"the weight is {alternative.weight:g}; it must be greater than 0"
        if not alternative.calls:
            yield (
                alternative.place,
                f"expected a behaviour below `{alternative.keyword}`, such as small_nod($start, $end)",
            )


def _behaviors(rule: RuleTree, declared: Declarations) -> Iterator[Located]:
    names = declared.behaviors
    if names is None:
        return
    demanded = {ALWAYS: names.demandable, NEVER: names.bannable}
    for alternative in _alternatives(rule):
        known = names.behaviors | demanded.get(alternative.weight, frozenset())
        for call in alternative.calls:
            if call.name not in known:
                yield call.place, _unknown(call.name, known, names)


def _unknown(name: str, known: frozenset[str], names: CallableNames) -> str:
    """Why this may not be called there."""
    if name in names.demandable:
        return f"{name} is no behaviour of the table; lexemes and families stand below `always` and `never`"
    if name in names.bannable:
        return f"{name} does not say which movement; it stands below `never`"
    return f"unknown behaviour {name}{did_you_mean(name, known)}"


def _fact(atom: Atom, declared: Declarations) -> Iterator[Located]:
    """Mistakes in a fact's predicate and arity."""
    if atom.name in declared.unread:
        return
    if atom.name not in declared.predicates:
        hint = "; a function stands in a computation: $x = ..." if atom.name in BUILTINS else ""
        yield atom.place, f"unknown predicate {atom.name}{did_you_mean(atom.name, declared.predicates) or hint}"
        return
    parameters = [parameter.name for parameter in declared.predicates[atom.name].parameters]
    if len(atom.arguments) != len(parameters):
        yield (
            atom.place,
            f"{atom.name} takes {len(parameters)} arguments ({', '.join(parameters)}), not {len(atom.arguments)}",
        )


def _pattern(pattern: Pattern, declared: Declarations) -> Iterator[Located]:
    """Mistakes in a pattern's arguments."""
    for argument in pattern.fact.arguments:
        if isinstance(argument, ArithmeticOperation | Atom):
            yield argument.place, "a pattern computes nothing; compute on a line of its own: $x = ..."
    if not declared.annotated[pattern.fact.name]:
        return
    annotation = pattern.fact.arguments[-1]
    name = declared.predicates[pattern.fact.name].parameters[-1].name
    if pattern.absent and not isinstance(annotation, Wildcard):
        yield annotation.place, f"the annotation {name} cannot be tested: write `_` here"
    elif isinstance(annotation, Constant | Alternatives):
        yield annotation.place, f"the annotation {name} cannot be tested: write a $variable or `_` here"


def _values(expression: Expression) -> Iterator[Located]:
    """Mistakes in an expression that is evaluated."""
    if isinstance(expression, Wildcard | Alternatives):
        yield expression.place, f"`{expression}` only stands in patterns; here one value is wanted"
    elif isinstance(expression, ArithmeticOperation):
        for part in (expression.left, expression.right):
            yield from _number(part, expression.operator)
    elif isinstance(expression, Atom):
        yield from _function(expression)
        for part in expression.arguments:
            yield from _number(part, expression.name)


def _function(call: Atom) -> Iterator[Located]:
    builtin = BUILTINS.get(call.name)
    if builtin is None:
        yield call.place, f"unknown function {call.name}{did_you_mean(call.name, BUILTINS)}"
    elif not builtin.accepts(len(call.arguments)):
        yield call.place, f"{call.name} takes {builtin.takes}, not {len(call.arguments)}"


def _number(expression: Expression, wanted_by: str) -> Iterator[Located]:
    if isinstance(expression, Constant) and isinstance(expression.value, str):
        yield expression.place, f"`{wanted_by}` takes numbers, and {expression} is a text"
    yield from _values(expression)


def _comparable(guard: Guard) -> Iterator[Located]:
    """Type mistakes in a guard, as far as they are evident."""
    kinds = [_kind(guard.left), _kind(guard.right)]
    if is_ordering(guard.operator):
        for side, kind in zip((guard.left, guard.right), kinds, strict=True):
            if kind == "text":
                yield side.place, f"`{guard.operator}` takes numbers, and {side} is a text"
    elif set(kinds) == {"text", "number"}:
        yield guard.place, f"a text and a number are never equal: {guard.left} {guard.operator} {guard.right}"


def _kind(expression: Expression) -> str:
    if isinstance(expression, Constant):
        return "text" if isinstance(expression.value, str) else "number"
    return "number" if isinstance(expression, ArithmeticOperation | Atom) else ""


def _unbound(rule: RuleTree) -> Iterator[Located]:
    """Variables that are used without being bound."""
    bound = _bound(rule)
    for variable in _used(rule):
        if variable.name not in bound:
            hint = did_you_mean(variable.name, bound) or "; a fact joined in `foreach`, or `=`, must give it one"
            yield variable.place, f"${variable.name} has no value{hint}"


def _bound(rule: RuleTree) -> set[str]:
    bound = {
        argument.name
        for pattern in _patterns(rule)
        if not pattern.absent
        for argument in pattern.fact.arguments
        if isinstance(argument, Variable)
    }
    computations = [part for part in rule.statements if isinstance(part, Computation)]
    while ready := [part for part in computations if variables_of(part.expression) <= bound]:
        bound |= {part.variable.name for part in ready}
        computations = [part for part in computations if part not in ready]
    return bound


def _annotations(rule: RuleTree, declared: Declarations) -> Iterator[Located]:
    """Annotations, and values computed from them, where they would determine which facts exist."""
    binding = annotation_variables(rule, declared.annotated)
    computations = [part for part in rule.statements if isinstance(part, Computation)]
    tainted = binding.keys() | {part.variable.name for part in late_computations(computations, binding)}
    for expression in _deciding(rule, declared):
        for variable in _variables(expression):
            if variable.name in tainted:
                yield variable.place, f"${variable.name} comes from an annotation, which may not decide what holds"
    annotating = [
        pattern.fact.arguments[-1]
        for pattern in _patterns(rule)
        if declared.annotated[pattern.fact.name] and not pattern.absent
    ]
    computed = [part.variable for part in computations]
    names = Counter(argument.name for argument in annotating if isinstance(argument, Variable))
    names.update({variable.name for variable in computed})
    for value in (*annotating, *computed):
        if isinstance(value, Variable) and names[value.name] > 1 and value.name in tainted:
            yield value.place, f"${value.name} has a value already, and an annotation cannot be compared with it"
    for name, count in Counter(variable.name for variable in computed).items():
        if count > 1:
            place = next(variable.place for variable in reversed(computed) if variable.name == name)
            yield place, f"${name} is computed twice; compare with `==`"


def _deciding(rule: RuleTree, declared: Declarations) -> Iterator[Expression]:
    """The expressions that determine which facts and choices exist."""
    for guard in _guards(rule):
        yield guard.left
        yield guard.right
    for atom in declared.facts_of(rule):
        yield from atom.arguments[:-1] if declared.annotated[atom.name] else atom.arguments


def _expressions(rule: RuleTree) -> Iterator[Expression]:
    """The expressions that are evaluated: all but the arguments of patterns."""
    for part in rule.statements:
        if isinstance(part, Computation):
            yield part.expression
    for guard in _guards(rule):
        yield guard.left
        yield guard.right
    for atom in asserted(rule):
        yield from atom.arguments
    for alternative in _alternatives(rule):
        for call in alternative.calls:
            yield from call.arguments


def _used(rule: RuleTree) -> Iterator[Variable]:
    for expression in _expressions(rule):
        yield from _variables(expression)
    for pattern in _patterns(rule):
        if pattern.absent:
            yield from _variables(pattern.fact)


def _variables(expression: Expression) -> Iterator[Variable]:
    if isinstance(expression, Variable):
        yield expression
    elif isinstance(expression, ArithmeticOperation):
        yield from _variables(expression.left)
        yield from _variables(expression.right)
    elif isinstance(expression, Atom):
        for argument in expression.arguments:
            yield from _variables(argument)


def _patterns(rule: RuleTree) -> Iterable[Pattern]:
    return [part for part in rule.statements if isinstance(part, Pattern)]


def _guards(rule: RuleTree) -> Iterator[Guard]:
    yield from (part for part in rule.statements if isinstance(part, Guard))
    for alternative in _alternatives(rule):
        yield from alternative.guards


def _alternatives(rule: RuleTree) -> Iterator[WeightedCalls]:
    for part in rule.conclusions:
        if isinstance(part, ChooseClause):
            yield from part.alternatives
