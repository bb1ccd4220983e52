"""Loads rule files into an immutable program: checked, stratified, with all joins planned.

An omitted annotation of an asserted fact counts as 0, so that any other rule's claim prevails. Two classes of functions
may be written as the paper prints them (`PRINTED`; paper, Figure 3).
"""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from ...errors import AuthoringError
from ...model import CallableNames
from ..knowledge import Beginning, Index
from ..language.tree import Assertion, Atom, Block, ChooseClause, Constant, Pattern, PredicateTree, RuleFile, RuleTree
from .planning import MatchPlan
from .stratification import asserted, feeding, strata


@dataclass(frozen=True, slots=True)
class FactMention:
    """A fact as written in a rule: `arguments` are source terms ("negation", "$start", "modal|mental", "_")."""

    predicate: str
    arguments: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule as its author sees it. `kind` is "assert" or "choose", `comment` the comment lines directly above it,
    `line` that of the rule's name, `calls` the behaviours of a choose-rule without duplicates, `tree` its syntax tree.
    """

    name: str
    kind: str
    path: Path
    line: int
    comment: str
    source: str
    joins: tuple[FactMention, ...]
    asserts: tuple[FactMention, ...]
    calls: tuple[str, ...]
    tree: RuleTree


@dataclass(frozen=True, slots=True)
class Predicate:
    """A declared predicate; `parameters` without the annotation, whose name is `annotation` ("" if there is none)."""

    name: str
    parameters: tuple[str, ...]
    annotation: str
    path: Path
    line: int
    comment: str


@dataclass(frozen=True, slots=True)
class Stratum:
    """Rules that run together: `first` once on all facts, then `later` on the facts that each round added.

    `waiting` maps what a plan may begin from (`MatchPlan.beginnings`) to the numbers of the plans in `later`.
    """

    first: tuple[MatchPlan, ...]
    later: tuple[MatchPlan, ...]
    waiting: Mapping[Beginning, tuple[int, ...]]

    @classmethod
    def of(cls, first: Iterable[MatchPlan], later: Sequence[MatchPlan]) -> "Stratum":
        waiting: defaultdict[Beginning, list[int]] = defaultdict(list)
        for number, plan in enumerate(later):
            for beginning in plan.beginnings:
                waiting[beginning].append(number)
        filed = {beginning: tuple(numbers) for beginning, numbers in waiting.items()}
        return cls(tuple(first), tuple(later), MappingProxyType(filed))

    def due(self, brought: Iterable[Beginning]) -> Iterator[MatchPlan]:
        """The later plans for which there are new facts, in the order of the rules."""
        numbers = {number for beginning in brought for number in self.waiting.get(beginning, ())}
        return (self.later[number] for number in sorted(numbers))


@dataclass(frozen=True, slots=True)
class Program:
    """Compiled rules (`understudy.rules.chaining.chainer.derive`); immutable and thread-safe."""

    rules: tuple[Rule, ...]
    predicates: Mapping[str, Predicate]
    strata: tuple[Stratum, ...]
    choosers: tuple[MatchPlan, ...]
    indexes: tuple[Index, ...]

    @property
    def argument_counts(self) -> Mapping[str, int]:
        """The number of arguments of each predicate."""
        return {name: len(predicate.parameters) for name, predicate in self.predicates.items()}


def load_program(
    paths: Iterable[Path],
    *,
    behaviors: CallableNames | None = None,
    printed: Mapping[str, str] = MappingProxyType({}),
) -> Program:
    """The program of these files; `behaviors` are the names that choose-rules may call (None: any), `printed`
    other names of classes of functions.

    Raises AuthoringError with all mistakes of all files, in the order of the files and their lines.
    """
    from ..language.parsing import read_rules  # with `check` imported late: compiled rules need neither, nor lark
    from .checking import check

    readings = [read_rules(path) for path in paths]
    files = with_annotations(with_known_classes([file for file, _ in readings], printed))
    found = [mistake for _, mistakes in readings for mistake in mistakes]
    found += check(files, behaviors)
    if found:
        order = {file.path: number for number, file in enumerate(files)}
        raise AuthoringError(tuple(sorted(found, key=lambda m: (order[m.path], m.line, m.column))))
    return _assembled(files)


def _assembled(files: tuple[RuleFile, ...]) -> Program:
    from .compiling import compiled

    blocks = [(file, block) for file in files for block in file.blocks]
    predicates = {
        block.tree.name: _predicate(file, block, block.tree)
        for file, block in blocks
        if isinstance(block.tree, PredicateTree)
    }
    rules = [(file, block, block.tree) for file, block in blocks if isinstance(block.tree, RuleTree)]
    trees = [tree for _, _, tree in rules]
    annotated = {name: bool(predicate.annotation) for name, predicate in predicates.items()}
    indexes: dict[Index, int] = {}
    fed = feeding(trees, annotated)
    plans = [compiled(tree, file, annotated, indexes) for file, _, tree in rules]
    asserting = [number for number, tree in enumerate(trees) if asserted(tree)]
    numbers = strata(fed)
    levels = [[number for number in asserting if numbers[number] == level] for level in sorted(set(numbers))]
    return Program(
        rules=tuple(_rule(file, block, tree) for file, block, tree in rules),
        predicates=MappingProxyType(predicates),
        strata=tuple(
            Stratum.of(
                first=[plans[number].from_all for number in level],
                later=[plan for number in level if fed.joined[number] for plan in plans[number].from_recent],
            )
            for level in levels
        ),
        choosers=tuple(plan.from_all for plan, tree in zip(plans, trees, strict=True) if not asserted(tree)),
        indexes=tuple(indexes),
    )


def _predicate(file: RuleFile, block: Block, tree: PredicateTree) -> Predicate:
    return Predicate(
        name=tree.name,
        parameters=tuple(parameter.name for parameter in tree.parameters if not parameter.merged),
        annotation=next((parameter.name for parameter in tree.parameters if parameter.merged), ""),
        path=file.path,
        line=tree.place.line,
        comment=block.comment,
    )


def _rule(file: RuleFile, block: Block, tree: RuleTree) -> Rule:
    joins = (part.fact for part in tree.statements if isinstance(part, Pattern) and not part.absent)
    calls = [
        call.name
        for part in tree.conclusions
        if isinstance(part, ChooseClause)
        for alternative in part.alternatives
        for call in alternative.calls
    ]
    return Rule(
        name=tree.name,
        kind="assert" if asserted(tree) else "choose",
        path=file.path,
        line=tree.place.line,
        comment=block.comment,
        source=block.source,
        joins=tuple(map(_mention, joins)),
        asserts=tuple(map(_mention, asserted(tree))),
        calls=tuple(dict.fromkeys(calls)),
        tree=tree,
    )


def _mention(atom: Atom) -> FactMention:
    return FactMention(atom.name, tuple(map(str, atom.arguments)))


OMITTED = 0


def with_annotations(files: Sequence[RuleFile]) -> tuple[RuleFile, ...]:
    """The files, with an annotation in every asserted fact of an annotated predicate."""
    annotated = {
        block.tree.name: len(block.tree.parameters)
        for file in files
        for block in file.blocks
        if isinstance(block.tree, PredicateTree) and any(parameter.merged for parameter in block.tree.parameters)
    }
    lacking = frozenset((name, length - 1) for name, length in annotated.items())
    return tuple(replace(file, blocks=tuple(_filled_block(block, lacking) for block in file.blocks)) for file in files)


def _filled_block(block: Block, lacking: Collection[tuple[str, int]]) -> Block:
    if not isinstance(block.tree, RuleTree):
        return block
    conclusions = tuple(
        replace(part, facts=tuple(_filled(atom, lacking) for atom in part.facts))
        if isinstance(part, Assertion)
        else part
        for part in block.tree.conclusions
    )
    return replace(block, tree=replace(block.tree, conclusions=conclusions))


def _filled(atom: Atom, lacking: Collection[tuple[str, int]]) -> Atom:
    if (atom.name, len(atom.arguments)) not in lacking:
        return atom
    return replace(atom, arguments=(*atom.arguments, Constant(OMITTED, atom.place)))


PRINTED: Mapping[str, str] = MappingProxyType({"quantifier": "quantification", "comparative": "comparison"})
"""The class that is meant, by the name in the figure."""


def with_known_classes(files: Iterable[RuleFile], printed: Mapping[str, str]) -> list[RuleFile]:
    """The files with functions of printed classes as functions of the classes that are meant."""
    return [replace(file, blocks=tuple(_block(block, printed) for block in file.blocks)) for file in files]


def _block(block: Block, printed: Mapping[str, str]) -> Block:
    tree = block.tree
    if not isinstance(tree, RuleTree):
        return block
    statements = tuple(
        replace(part, fact=_atom(part.fact, printed)) if isinstance(part, Pattern) else part for part in tree.statements
    )
    conclusions = tuple(
        replace(part, facts=tuple(_atom(fact, printed) for fact in part.facts)) if isinstance(part, Assertion) else part
        for part in tree.conclusions
    )
    return replace(block, tree=replace(tree, statements=statements, conclusions=conclusions))


def _atom(atom: Atom, printed: Mapping[str, str]) -> Atom:
    kind = atom.arguments[0] if atom.name == "fcn" and atom.arguments else None
    if isinstance(kind, Constant) and kind.value in printed:
        return replace(atom, arguments=(replace(kind, value=printed[str(kind.value)]), *atom.arguments[1:]))
    return atom
