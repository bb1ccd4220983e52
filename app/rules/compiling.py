"""Compiles one checked rule: splits what can be known while matching from what waits for annotations, and plans it."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

from app.rules.conclusions import Annotated, Assert, Choose, Head, Offer
from app.rules.knowledge import Index, Origin
from app.rules.planning import Layout, Plans, plans, variables_of
from app.rules.steps import Step
from app.rules.tree import (
    Atom,
    Choice,
    Computation,
    Expression,
    Pattern,
    Place,
    RuleFile,
    RuleTree,
    Variable,
    WeightedCalls,
)


def compiled(rule: RuleTree, file: RuleFile, annotated: Mapping[str, bool], indexes: dict[Index, int]) -> Plans:
    """The plans of a checked rule; `annotated` tells the predicates with annotation, `indexes` numbers the indexes."""
    layout = Layout(annotated, partial(_locate, file, rule.name))
    compiler = _Compiler(rule, layout, annotated)
    last = compiler.conclusion()
    return plans(rule, layout, indexes, computed=compiler.computed, last=last)


def annotation_variables(rule: RuleTree, annotated: Mapping[str, bool]) -> dict[str, int]:
    """The variables that patterns bind to annotations, with the number of the positive pattern that binds each."""
    joins = [part.fact for part in rule.statements if isinstance(part, Pattern) and not part.absent]
    return {
        atom.arguments[-1].name: number
        for number, atom in enumerate(joins)
        if annotated[atom.name] and isinstance(atom.arguments[-1], Variable)
    }


def after_annotations(rule: RuleTree, annotations: Mapping[str, int]) -> tuple[Computation, ...]:
    """The computations that read annotations, directly or through one another, in the order to take them."""
    tainted = set(annotations)
    waiting = [part for part in rule.statements if isinstance(part, Computation)]
    ordered: list[Computation] = []
    while reading := [part for part in waiting if variables_of(part.expression) & tainted]:
        ordered += reading
        tainted |= {part.variable.name for part in reading}
        waiting = [part for part in waiting if part not in reading]
    return _in_order_of_use(ordered)


def _in_order_of_use(computations: list[Computation]) -> tuple[Computation, ...]:
    """Each after those whose results it reads."""
    ordered: list[Computation] = []
    waiting = computations
    while waiting:
        open_names = {part.variable.name for part in waiting}
        free = [part for part in waiting if not variables_of(part.expression) & open_names]
        ordered += free or waiting
        waiting = [part for part in waiting if part not in free] if free else []
    return tuple(ordered)


def _locate(file: RuleFile, rule: str, place: Place) -> Origin:
    return Origin(file.path, place.line, place.column, file.lines[place.line - 1], rule)


@dataclass(slots=True)
class _Compiler:
    rule: RuleTree
    layout: Layout
    annotated: Mapping[str, bool]
    computed: tuple[Computation, ...] = ()

    def conclusion(self) -> Step:
        """The last step; what it needs computed before is added to `computed`."""
        annotations = annotation_variables(self.rule, self.annotated)
        late = after_annotations(self.rule, annotations)
        self.computed = tuple(
            part for part in self.rule.statements if isinstance(part, Computation) and part not in late
        )
        waiting = Annotated(
            tuple((self.layout.variable(name), self.layout.fact(number)) for name, number in annotations.items()),
            tuple(
                (
                    self.layout.variable(part.variable.name),
                    self.layout.evaluator(part.expression),
                    self.layout.locate(part.variable.place),
                )
                for part in late
            ),
        )
        joins = sum(isinstance(part, Pattern) and not part.absent for part in self.rule.statements)
        supports = tuple(self.layout.fact(number) for number in range(joins))
        origin = self.layout.locate(self.rule.place)
        [concluded] = self.rule.conclusions
        if isinstance(concluded, Choice):
            return Choose(tuple(map(self._offer, concluded.alternatives)), waiting, supports, origin)
        return Assert(tuple(map(self._head, concluded.facts)), waiting, supports, origin)

    def _head(self, atom: Atom) -> Head:
        slots = tuple(self._argument(argument) for argument in self.layout.identity(atom))
        annotation = self.layout.evaluator(atom.arguments[-1]) if self.annotated[atom.name] else None
        return Head(atom.name, slots, annotation)

    def _argument(self, argument: Expression) -> int:
        """The slot of an asserted argument; a computed one gets a variable no author can write."""
        if isinstance(argument, Variable):
            return self.layout.variable(argument.name)
        if not variables_of(argument) and hasattr(argument, "value"):
            return self.layout.constant(argument.value)
        hidden = Variable(f"({len(self.computed)})", argument.place)
        self.computed += (Computation(hidden, argument),)
        return self.layout.variable(hidden.name)

    def _offer(self, alternative: WeightedCalls) -> Offer:
        return Offer(
            alternative.weight,
            tuple((self.layout.test(guard), self.layout.locate(guard.place)) for guard in alternative.guards),
            tuple((call.name, tuple(map(self.layout.evaluator, call.arguments))) for call in alternative.calls),
        )
