"""Compiles one checked rule: separates computations done while matching from those that depend on annotations, and
plans the matching."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from ..knowledge import Index, Origin
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
from .conclusions import Assert, Choose, Head, LateComputations, Offer
from .planning import Plans, SlotLayout, plans, variables_of
from .steps import Step


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
