"""Explains to authors which rules fired, and which nearly did and what was missing.

A rule nearly fires if all of its statements but one hold. A missing fact is only reported if the rule found a word,
entry or function that it names (`ANCHORS`), and if the fact is possible: otherwise almost every sentence is one word
short of almost every rule. Spans are boundaries between words, as in the rules.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import partial

from ...model import Fact
from ..language.tree import (
    ALWAYS,
    NEVER,
    Alternatives,
    ChooseClause,
    Computation,
    Constant,
    Expression,
    Guard,
    Pattern,
    Statement,
)
from ..program.loading import Program, Rule
from ..program.stratification import asserted
from .matching import Bindings, FactBase, Match, matches, substitute

ANCHORS = frozenset(("word", "lemma", "lexical", "fcn"))
"""Predicates whose constants tell which words a rule is about."""


class ObstacleKind(StrEnum):
    """The reason why a rule did not fire."""

    MISSING = "missing"
    EXCLUDED = "excluded by"
    UNTRUE = "not so"


@dataclass(frozen=True, slots=True)
class ShownStatement:
    """A fact or statement in the rule language with its variables' values, and the words it concerns."""

    text: str
    span: tuple[int, int] | None = None


@dataclass(frozen=True, slots=True)
class UnmetCondition:
    """A missing fact, a fact excluded by `unless`, or a comparison that does not hold."""

    lack: ObstacleKind
    said: ShownStatement


@dataclass(frozen=True, slots=True)
class RuleFiring:
    """A match of a rule: the facts it joined in the order of the rule, and what it asserts or may choose."""

    rule: Rule
    joined: tuple[ShownStatement, ...]
    concluded: tuple[ShownStatement, ...]


@dataclass(frozen=True, slots=True)
class NearMiss:
    """The facts that a rule found, and what prevented it from firing."""

    rule: Rule
    joined: tuple[ShownStatement, ...]
    obstacles: tuple[UnmetCondition, ...]


@dataclass(frozen=True, slots=True)
class RuleTrace:
    """All matches in the order of the rules, and the nearest misses of rules without a match, those that found most
    first."""

    firings: tuple[RuleFiring, ...]
    near_misses: tuple[NearMiss, ...]


def trace_rules(program: Program, facts: Iterable[Fact]) -> RuleTrace:
    """The matches of each rule with all given and derived facts, and at most one near miss of each."""
    tracer = _Tracer(program, FactBase.of(facts))
    firings: list[RuleFiring] = []
    near: list[tuple[tuple[int, int], NearMiss]] = []
    for rule in program.rules:
        found = tuple(matches(rule.tree, tracer.facts, most_unmet=1))
        fired = [tracer.firing(rule, match) for match in found if not match.unmet]
        missed = [] if fired else [match for match in found if tracer.is_near(rule, match)]
        firings += fired
        if missed:
            nearest = max(missed, key=partial(_nearness, rule))
            near.append((_nearness(rule, nearest), tracer.near_miss(rule, nearest)))
    near.sort(key=lambda ranked: ranked[0], reverse=True)
    return RuleTrace(tuple(firings), tuple(miss for _, miss in near))


def trace_rule(program: Program, rule: Rule, facts: Iterable[Fact]) -> RuleTrace:
    """All matches of one rule or, if there are none, its nearest misses, however far."""
    tracer = _Tracer(program, FactBase.of(facts))
    for most_unmet in range(len(rule.tree.statements) + 1):
        found = tuple(matches(rule.tree, tracer.facts, most_unmet=most_unmet))
        if found and most_unmet == 0:
            return RuleTrace(tuple(tracer.firing(rule, match) for match in found), ())
        if found:
            return RuleTrace((), tuple(tracer.near_miss(rule, match) for match in found))
    raise AssertionError(f"rule {rule.name} matches only with more unmet statements than it has")


def fires(rule: Rule, facts: FactBase) -> bool:
    """Whether the rule has any match."""
    return next(matches(rule.tree, facts), None) is not None


@dataclass(frozen=True, slots=True)
class _Tracer:
    program: Program
    facts: FactBase

    def firing(self, rule: Rule, match: Match) -> RuleFiring:
        return RuleFiring(rule, self._joined(match), tuple(self._concluded(rule, match.bindings)))

    def near_miss(self, rule: Rule, match: Match) -> NearMiss:
        obstacles = tuple(self._obstacle(part, match.bindings) for part in match.unmet)
        return NearMiss(rule, self._joined(match), obstacles)

    def is_near(self, rule: Rule, match: Match) -> bool:
        [unmet] = match.unmet
        if not isinstance(unmet, Pattern) or unmet.absent:
            return True
        span = self._said(unmet.fact.name, unmet.fact.arguments, match.bindings).span
        return _nearness(rule, match) > (1, 0) and (span is None or span[0] < span[1])

    def _joined(self, match: Match) -> tuple[ShownStatement, ...]:
        facts = (match.joined[number] for number in sorted(match.joined))
        return tuple(ShownStatement(str(fact), self._span(fact.predicate, fact.arguments)) for fact in facts)

    def _concluded(self, rule: Rule, bindings: Bindings) -> Iterator[ShownStatement]:
        for atom in asserted(rule.tree):
            yield self._said(atom.name, atom.arguments, bindings)
        for part in rule.tree.conclusions:
            if isinstance(part, ChooseClause):
                for offered in part.alternatives:
                    calls = " ".join(str(substitute(call, bindings)) for call in offered.calls)
                    yield ShownStatement(f"{_wanted(offered.weight)}: {calls}")

    def _obstacle(self, statement: Statement, bindings: Bindings) -> UnmetCondition:
        if isinstance(statement, Pattern) and not statement.absent:
            atom = statement.fact
            return UnmetCondition(ObstacleKind.MISSING, self._said(atom.name, atom.arguments, bindings))
        if isinstance(statement, Pattern):
            fact, _ = next(self.facts.fitting(statement.fact, bindings))
            return UnmetCondition(
                ObstacleKind.EXCLUDED, ShownStatement(str(fact), self._span(fact.predicate, fact.arguments))
            )
        return UnmetCondition(ObstacleKind.UNTRUE, ShownStatement(_compared(statement, bindings)))

    def _said(self, predicate: str, arguments: Sequence[Expression], bindings: Bindings) -> ShownStatement:
        """A fact as written in a rule, without its annotation, which is not computed here."""
        known = [substitute(part, bindings) for part in arguments][: len(self.program.predicates[predicate].parameters)]
        values = [part.value if isinstance(part, Constant) else None for part in known]
        return ShownStatement(f"{predicate}({', '.join(map(str, known))})", self._span(predicate, values))

    def _span(self, predicate: str, values: Sequence[object]) -> tuple[int, int] | None:
        """The boundaries `start` and `end` of a fact; if it has only one, those of the word there."""
        named = dict(zip(self.program.predicates[predicate].parameters, values, strict=True))
        match named.get("start"), named.get("end"):
            case int(start), int(end):
                return start, end
            case int(start), None:
                return start, start + 1
            case None, int(end):
                return end - 1, end
        return None


def _nearness(rule: Rule, match: Match) -> tuple[int, int]:
    """The number of joined patterns that name a word, an entry or a function, and the number of all joined patterns."""
    joins = [part.fact for part in rule.tree.statements if isinstance(part, Pattern) and not part.absent]
    anchors = [
        atom.name in ANCHORS and any(isinstance(part, Constant | Alternatives) for part in atom.arguments)
        for atom in (joins[number] for number in match.joined)
    ]
    return sum(anchors), len(anchors)


def _compared(statement: Guard | Computation | Pattern, bindings: Bindings) -> str:
    if isinstance(statement, Guard):
        left, sign, right = statement.left, statement.operator, statement.right
    else:
        assert isinstance(statement, Computation)
        left, sign, right = statement.variable, "=", statement.expression
    return f"{left} {sign} {right}: {substitute(left, bindings)} {sign} {substitute(right, bindings)}"


def _wanted(weight: float) -> str:
    return {ALWAYS: "always", NEVER: "never"}.get(weight, f"weight {weight:g}")
