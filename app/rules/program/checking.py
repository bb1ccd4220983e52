"""Finds the semantic mistakes of rule files, each with its place.

`rule_checks.py` checks single rules; here are the checks across rules: duplicate names, and rules whose `unless`
depends on their own conclusions.
"""

from collections.abc import Iterator, Sequence

from ...errors import Mistake
from ...model import CallableNames
from ..language.tree import PredicateTree, RuleFile, RuleTree
from .rule_checks import Declarations, Located, rule_mistakes
from .stratification import cycles, feeding

_Declaration = tuple[RuleFile, PredicateTree]
_Rule = tuple[RuleFile, RuleTree]


def check(files: Sequence[RuleFile], behaviors: CallableNames | None) -> Iterator[Mistake]:
    """All mistakes in `files`, in no particular order; `behaviors` may be called by choose-rules (None: any)."""
    blocks = [(file, block.tree) for file in files for block in file.blocks]
    declarations = [(file, tree) for file, tree in blocks if isinstance(tree, PredicateTree)]
    rules = [(file, tree) for file, tree in blocks if isinstance(tree, RuleTree)]
    for file, predicate in declarations:
        yield from _located(file, _parameter_mistakes(predicate))
    yield from _said_twice("predicate", declarations)
    yield from _said_twice("rule", rules)
    declared = _declared(files, declarations, behaviors)
    sound = []
    for file, rule in rules:
        found = list(rule_mistakes(rule, declared))
        yield from _located(file, found)
        if not found and not any(atom.name in declared.unread for atom in declared.facts_of(rule)):
            sound.append((file, rule))
    yield from _negation_cycles(sound, declared)


def _declared(
    files: Sequence[RuleFile], declarations: Sequence[_Declaration], behaviors: CallableNames | None
) -> Declarations:
    predicates: dict[str, PredicateTree] = {}
    for _, predicate in declarations:
        predicates.setdefault(predicate.name, predicate)
    annotated = {
        name: bool(predicate.parameters) and predicate.parameters[-1].merged for name, predicate in predicates.items()
    }
    unread = frozenset(name for file in files for name in file.unread) - predicates.keys()
    return Declarations(predicates, annotated, unread, behaviors)


def _parameter_mistakes(predicate: PredicateTree) -> Iterator[Located]:
    names: set[str] = set()
    for position, parameter in enumerate(predicate.parameters, start=1):
        if parameter.name in names:
            yield parameter.place, f"{predicate.name} has two parameters called {parameter.name}"
        if parameter.merged and position < len(predicate.parameters):
            yield parameter.place, "the parameter marked `max` is the annotation, and must be the only one and the last"
        names.add(parameter.name)


def _said_twice(kind: str, blocks: Sequence[_Declaration] | Sequence[_Rule]) -> Iterator[Mistake]:
    first: dict[str, tuple[RuleFile, PredicateTree | RuleTree]] = {}
    for file, tree in blocks:
        if tree.name not in first:
            first[tree.name] = (file, tree)
            continue
        other_file, other = first[tree.name]
        for here, one, there, two in ((file, tree, other_file, other), (other_file, other, file, tree)):
            message = f"{kind} {one.name} is also at {there.path}:{two.place.line}; names must be unique"
            yield from _located(here, [(one.place, message)])


def _negation_cycles(rules: Sequence[_Rule], declared: Declarations) -> Iterator[Mistake]:
    for cycle in cycles(feeding([rule for _, rule in rules], declared.annotated)):
        file, first = rules[cycle.rules[0]]
        way = " → ".join(rules[number][1].name for number in (*cycle.rules, cycle.rules[0]))
        message = (
            f"rule {first.name} excludes {cycle.unless.fact}, which depends on what the rule itself asserts "
            f"({way}); no order of the rules settles that"
        )
        yield from _located(file, [(cycle.unless.fact.place, message)])


def _located(file: RuleFile, found: "Iterator[Located] | list[Located]") -> Iterator[Mistake]:
    for place, message in found:
        yield Mistake(file.path, place.line, place.column, message, file.lines[place.line - 1])
