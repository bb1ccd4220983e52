"""The syntax tree of rule files, with the position of every part.

Lines and columns count from 1.
"""

from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import TypeAlias

from ...model.functions import Argument


@dataclass(frozen=True, slots=True)
class SourcePosition:
    line: int
    column: int


@dataclass(frozen=True, slots=True)
class Variable:
    """`$name`, without the dollar sign."""

    name: str
    place: SourcePosition

    def __str__(self) -> str:
        return f"${self.name}"


@dataclass(frozen=True, slots=True)
class Constant:
    value: Argument
    place: SourcePosition

    def __str__(self) -> str:
        return str(self.value)


@dataclass(frozen=True, slots=True)
class Wildcard:
    """`_`: matches anything."""

    place: SourcePosition

    def __str__(self) -> str:
        return "_"


@dataclass(frozen=True, slots=True)
class Alternatives:
    """`modal|mental`: any one of these constants."""

    values: tuple[Argument, ...]
    place: SourcePosition

    def __str__(self) -> str:
        return "|".join(map(str, self.values))


@dataclass(frozen=True, slots=True)
class ArithmeticOperation:
    """`left operator right`; the operator is one of + - * /."""

    operator: str
    left: "Expression"
    right: "Expression"
    place: SourcePosition

    def __str__(self) -> str:
        return f"{self.left} {self.operator} {self.right}"


@dataclass(frozen=True, slots=True)
class Atom:
    """`name(arguments)`: depending on its context a pattern, an assertion, a behaviour or a function call."""

    name: str
    arguments: tuple["Expression", ...]
    place: SourcePosition

    def __str__(self) -> str:
        return f"{self.name}({', '.join(map(str, self.arguments))})"


Expression: TypeAlias = Variable | Constant | Wildcard | Alternatives | ArithmeticOperation | Atom


@dataclass(frozen=True, slots=True)
class Pattern:
    """A fact that must exist or, with `absent`, must not."""

    fact: Atom
    absent: bool = False


@dataclass(frozen=True, slots=True)
class Computation:
    """`variable = expression`."""

    variable: Variable
    expression: Expression


@dataclass(frozen=True, slots=True)
class Guard:
    """`left operator right`; the operator is one of < <= > >= == !=."""

    operator: str
    left: Expression
    right: Expression
    place: SourcePosition


Statement: TypeAlias = Pattern | Computation | Guard


ALWAYS, NEVER = inf, -inf
"""The weights of what an author asks for always, and of what never comes."""


@dataclass(frozen=True, slots=True)
class WeightedCalls:
    """An alternative of a choice: `weight 2 when guard and guard`, `always` or `never`, and the behaviours below it."""

    weight: float
    guards: tuple[Guard, ...]
    calls: tuple[Atom, ...]
    place: SourcePosition

    @property
    def keyword(self) -> str:
        """How the alternative begins."""
        return {ALWAYS: "always", NEVER: "never"}.get(self.weight, "weight")


@dataclass(frozen=True, slots=True)
class Assertion:
    """The `assert` part of a rule."""

    facts: tuple[Atom, ...]
    place: SourcePosition


@dataclass(frozen=True, slots=True)
class ChooseClause:
    """The `choose` part of a rule."""

    alternatives: tuple[WeightedCalls, ...]
    place: SourcePosition


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter in a declaration; `merged` if it is marked `max`."""

    name: str
    merged: bool
    place: SourcePosition


@dataclass(frozen=True, slots=True)
class PredicateTree:
    """`predicate name(parameters)`."""

    name: str
    parameters: tuple[Parameter, ...]
    place: SourcePosition


@dataclass(frozen=True, slots=True)
class RuleTree:
    """`rule name foreach statements`, and its conclusions: in a valid rule, one assertion or one choice."""

    name: str
    statements: tuple[Statement, ...]
    conclusions: tuple[Assertion | ChooseClause, ...]
    place: SourcePosition


@dataclass(frozen=True, slots=True)
class Block:
    """A declaration or rule, the comment lines directly above it and its source."""

    tree: PredicateTree | RuleTree
    comment: str
    source: str


@dataclass(frozen=True, slots=True)
class RuleFile:
    """The readable blocks of one file, its lines to show mistakes in, and the names of unreadable blocks."""

    path: Path
    lines: tuple[str, ...] = ()
    blocks: tuple[Block, ...] = ()
    unread: frozenset[str] = frozenset()
