"""Compiles one checked rule: separates computations done while matching from those that depend on annotations, plans
the matching, and makes the rule's conclusions: facts are asserted, with claims for their annotations, or choices made.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from ...model import Argument, Fact
from ..knowledge import (
    AlternativeCalls,
    Call,
    Choice,
    Claim,
    Environment,
    Index,
    Knowledge,
    Origin,
    Reason,
)
from ..language.arithmetic import ComputationError
from ..language.tree import (
    Atom,
    ChooseClause,
    Computation,
    Constant,
    Expression,
    Pattern,
    RuleFile,
    RuleTree,
    SourcePosition,
    Variable,
    WeightedCalls,
)
from .planning import Plans, SlotLayout, plans, variables_of
from .steps import Evaluate, Step


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
                    raise self.origin.error(f"more than {knowledge.limits.facts} facts; is a computation endless?")
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


def compiled(rule: RuleTree, file: RuleFile, annotated: Mapping[str, bool], indexes: dict[Index, int]) -> Plans:
    """The plans of a checked rule; `annotated` tells which predicates have annotations, `indexes` assigns numbers to
    indexes."""
    layout = SlotLayout(annotated, partial(_locate, file, rule.name))
    compiler = _Compiler(rule, layout, [part for part in rule.statements if isinstance(part, Computation)])
    last = compiler.last_step()
    late = late_computations(compiler.computations, annotation_variables(rule, annotated))
    early = [part for part in compiler.computations if part not in late]
    return plans(rule, layout, indexes, computed=early, last=last)


def annotation_variables(rule: RuleTree, annotated: Mapping[str, bool]) -> dict[str, int]:
    """The variables bound to annotations, with the index of the positive pattern that binds each."""
    joins = [part.fact for part in rule.statements if isinstance(part, Pattern) and not part.absent]
    return {
        atom.arguments[-1].name: number
        for number, atom in enumerate(joins)
        if annotated[atom.name] and isinstance(atom.arguments[-1], Variable)
    }


def late_computations(computations: Sequence[Computation], annotations: Mapping[str, int]) -> tuple[Computation, ...]:
    """The computations that depend on annotations, directly or indirectly, in order of dependence."""
    late = set(annotations)
    while more := {part.variable.name for part in computations if variables_of(part.expression) & late} - late:
        late |= more
    waiting = [part for part in computations if part.variable.name in late]
    ordered: list[Computation] = []
    while waiting:
        unmade = {part.variable.name for part in waiting}
        ready = [part for part in waiting if not variables_of(part.expression) & unmade] or waiting
        ordered += ready
        waiting = [part for part in waiting if part not in ready]
    return tuple(ordered)


def _locate(file: RuleFile, rule: str, place: SourcePosition) -> Origin:
    return Origin(file.path, place.line, place.column, file.lines[place.line - 1], rule)


@dataclass(slots=True)
class _Compiler:
    """Builds the last step of a rule. Computations in its arguments are added to `computations`, hidden ones last."""

    rule: RuleTree
    layout: SlotLayout
    computations: list[Computation]

    def last_step(self) -> Step:
        [concluded] = self.rule.conclusions
        origin = self.layout.locate(self.rule.place)
        joins = sum(isinstance(part, Pattern) and not part.absent for part in self.rule.statements)
        supports = tuple(map(self.layout.fact, range(joins)))
        if isinstance(concluded, ChooseClause):
            offers = tuple(map(self._offer, concluded.alternatives))
            return Choose(offers, self._annotated(), supports, origin)
        slots = [tuple(map(self._slot, atom.arguments)) for atom in concluded.facts]
        annotated = self._annotated()
        heads = tuple(self._head(atom, of, annotated) for atom, of in zip(concluded.facts, slots, strict=True))
        return Assert(heads, annotated, supports, origin)

    def _head(self, atom: Atom, slots: tuple[int, ...], annotated: LateComputations) -> Head:
        if not self.layout.annotated[atom.name]:
            return Head(atom.name, slots, annotation=None, late=False)
        return Head(atom.name, slots[:-1], annotation=slots[-1], late=slots[-1] in annotated.fills)

    def _offer(self, alternative: WeightedCalls) -> Offer:
        guards = tuple((self.layout.test(guard), self.layout.locate(guard.place)) for guard in alternative.guards)
        calls = tuple((call.name, tuple(map(self._slot, call.arguments))) for call in alternative.calls)
        return Offer(alternative.weight, guards, calls)

    def _slot(self, argument: Expression) -> int:
        """The slot of an argument of the conclusion; a computed one gets a variable name that is not valid in rule
        files."""
        if isinstance(argument, Variable):
            return self.layout.variable(argument.name)
        if isinstance(argument, Constant):
            return self.layout.constant(argument.value)
        hidden = Variable(f"({len(self.computations)})", argument.place)
        self.computations.append(Computation(hidden, argument))
        return self.layout.variable(hidden.name)

    def _annotated(self) -> LateComputations:
        binding = annotation_variables(self.rule, self.layout.annotated)
        late = late_computations(self.computations, binding)
        layout = self.layout
        return LateComputations(
            reads=tuple((layout.variable(name), layout.fact(number)) for name, number in binding.items()),
            computations=tuple(
                (
                    layout.variable(part.variable.name),
                    layout.evaluator(part.expression),
                    layout.locate(part.variable.place),
                )
                for part in late
            ),
        )
