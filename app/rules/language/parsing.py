"""Parses rule files into syntax trees with positions (`tree.py`), or reports every syntax mistake with its place.

A file is split into blocks at the lines that begin with `rule` or `predicate` and at names alone above `foreach`, as
the paper prints them (Figure 3). Each block is parsed separately, so that a mistake in one does not hide those in
others. Newlines separate statements except inside parentheses.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from lark import Lark, Token, Transformer, UnexpectedInput, v_args
from lark.lark import PostLex

from ...errors import Mistake, shown
from ...files import read_source
from .arithmetic import LARGEST
from .tree import (
    ALWAYS,
    NEVER,
    Alternatives,
    ArithmeticOperation,
    Assertion,
    Atom,
    Block,
    ChooseClause,
    Computation,
    Constant,
    Expression,
    Guard,
    Parameter,
    Pattern,
    PredicateTree,
    RuleFile,
    RuleTree,
    SourcePosition,
    Statement,
    Variable,
    WeightedCalls,
    Wildcard,
)
from .wording import syntax_message

_BLOCK_START = re.compile(r"[ \t]*(rule|predicate)\b(?![ \t]*\()")
_KEYWORDS = "foreach|assert|choose|unless|weight|always|never"
_NAME_ALONE = re.compile(rf"[ \t]*(?!(?:{_KEYWORDS})\b)[A-Za-z][A-Za-z0-9_]*[ \t]*(#.*)?\r?$")
_FOREACH = re.compile(r"[ \t]*foreach\b")
_SIGNS_IN_A_LINE = 60


def read_rules(path: Path) -> tuple[RuleFile, tuple[Mistake, ...]]:
    """The parsed file at `path`, as far as it is readable, and its syntax mistakes in order."""
    text = read_source(path)
    if isinstance(text, Mistake):
        return RuleFile(path), (text,)
    return parse_rules(text, path)


def parse_rules(text: str, path: Path) -> tuple[RuleFile, tuple[Mistake, ...]]:
    """As `read_rules`, for text in memory; `path` is for messages."""
    file, mistakes = _parsed(text)
    return replace(file, path=path), tuple(replace(mistake, path=path) for mistake in mistakes)


_UNNAMED = Path()


@lru_cache(maxsize=64)
def _parsed(text: str) -> tuple[RuleFile, tuple[Mistake, ...]]:
    """A file and its mistakes, without its name.

    Cached, since when an author saves one file all others are read again as they were, from wherever they were put.
    """
    lines = tuple(line.expandtabs(1) for line in text.split("\n"))
    blocks: list[Block] = []
    unread: list[str] = []
    mistakes = [*_stray_lines(lines)]
    for cut in _cut(lines):
        tree, found = _parse_block(cut)
        mistakes += [Mistake(_UNNAMED, place.line, place.column, what, lines[place.line - 1]) for place, what in found]
        if tree is None:
            unread += cut.source.replace("(", " ").split()[1:2]
        else:
            blocks.append(Block(tree, cut.comment, cut.source))
    return RuleFile(_UNNAMED, lines, tuple(blocks), frozenset(unread)), tuple(mistakes)


_Located = tuple[SourcePosition, str]


@cache
def _grammar() -> Lark:
    return Lark.open("grammar.lark", rel_to=__file__, parser="lalr", postlex=_Lines())


def _parse_block(cut: "_Cut") -> tuple[PredicateTree | RuleTree | None, list[_Located]]:
    """The tree of a block, or None, and its mistakes."""
    text = cut.source + "\n"
    builder = _TreeBuilder(cut.first_line)
    try:
        parsed = _grammar().parse(text)
    except UnexpectedInput as error:
        line = min(max(error.line, 1), cut.source.count("\n") + 1)
        place = SourcePosition(cut.first_line + line - 1, max(error.column, 1))
        return None, [(place, syntax_message(error, text))]
    except _OverlongLineError as error:
        return None, [(builder.place(error.token), f"more than {_SIGNS_IN_A_LINE} signs in a line; compute in steps")]
    tree: PredicateTree | RuleTree = builder.transform(parsed)
    return (None, builder.mistakes) if builder.mistakes else (tree, [])


@dataclass(frozen=True, slots=True)
class _Cut:
    """The source of one block, its first line, and the comment lines directly above it."""

    first_line: int
    source: str
    comment: str


def _cut(lines: tuple[str, ...]) -> Iterator[_Cut]:
    starts = [number for number in range(len(lines)) if _starts_block(lines, number)]
    for start, end in pairwise([*starts, len(lines)]):
        above = start
        while above > 0 and lines[above - 1].lstrip().startswith("#"):
            above -= 1
        comment = "\n".join(line.strip().lstrip("#").strip() for line in lines[above:start])
        yield _Cut(start + 1, _without_trailing_comments(lines[start:end]), comment)


def _starts_block(lines: tuple[str, ...], number: int) -> bool:
    """Whether a block begins here: with a keyword, or with a rule's name alone, `foreach` being what comes next."""
    if _BLOCK_START.match(lines[number]):
        return True
    if not _NAME_ALONE.match(lines[number]):
        return False
    below = (line for line in lines[number + 1 :] if line.strip() and not line.lstrip().startswith("#"))
    before = (line for line in reversed(lines[:number]) if line.strip() and not line.lstrip().startswith("#"))
    return bool(_FOREACH.match(next(below, ""))) and next(before, "").strip() != "rule"


def _without_trailing_comments(lines: tuple[str, ...]) -> str:
    """The source of a block without blank lines and comments at its end, which belong to the next block."""
    last = max(number for number, line in enumerate(lines) if line.strip() and not line.lstrip().startswith("#"))
    return "\n".join(lines[: last + 1])


def _stray_lines(lines: tuple[str, ...]) -> Iterator[Mistake]:
    """A mistake at the first line before any block that is neither blank nor a comment."""
    for number, line in enumerate(lines, start=1):
        if _starts_block(lines, number - 1):
            return
        code = line.lstrip()
        if code and not code.startswith("#"):
            expected = "expected `rule NAME` or `predicate NAME(...)`, or a rule's name alone above `foreach`"
            yield Mistake(_UNNAMED, number, len(line) - len(code) + 1, expected, line)
            return


class _OverlongLineError(Exception):
    """A line with so many operators and parentheses that its tree would be too deep to traverse."""

    def __init__(self, token: Token) -> None:
        self.token = token


class _Lines(PostLex):
    """Drops newlines that separate nothing: inside parentheses, repeated, before the first token."""

    always_accept = ("_NEWLINE",)

    def process(self, stream: Iterator[Token]) -> Iterator[Token]:
        depth, signs, at_start = 0, 0, True
        for token in stream:
            if token.type == "_NEWLINE":
                if depth > 0 or at_start:
                    continue
                signs = 0
            depth += {"LPAR": 1, "RPAR": -1}.get(token.type, 0)
            signs += token.type in {"LPAR", "PLUS", "MINUS", "STAR", "SLASH"}
            if signs > _SIGNS_IN_A_LINE:
                raise _OverlongLineError(token)
            at_start = token.type == "_NEWLINE"
            yield token


@v_args(inline=True)
class _TreeBuilder(Transformer[Token, Any]):
    """Converts lark's tree of one block to ours. Raises nothing: malformed parts are added to `mistakes`."""

    def __init__(self, first_line: int) -> None:
        super().__init__()
        self._first_line = first_line
        self.mistakes: list[_Located] = []

    def place(self, token: Token) -> SourcePosition:
        return SourcePosition(self._first_line + (token.line or 1) - 1, token.column or 1)

    def start(self, block: PredicateTree | RuleTree) -> PredicateTree | RuleTree:
        return block

    def predicate(self, name: Token, *parameters: Parameter | None) -> PredicateTree:
        return PredicateTree(str(name), tuple(filter(None, parameters)), self.place(name))

    def parameter(self, name: Token, merged: Token | None) -> Parameter:
        return Parameter(str(name), merged is not None, self.place(name))

    def rule(self, name: Token, *parts: Statement | Assertion | ChooseClause | None) -> RuleTree:
        statements = tuple(part for part in parts if isinstance(part, Pattern | Computation | Guard))
        conclusions = tuple(part for part in parts if isinstance(part, Assertion | ChooseClause))
        return RuleTree(str(name), statements, conclusions, self.place(name))

    def fact(self, expression: Expression) -> Pattern:
        return Pattern(self._atom(expression, "a fact such as word($text, $start, $end), a computation or a guard"))

    def absent(self, expression: Expression) -> Pattern:
        return Pattern(self._atom(expression, "a fact such as word($text, $start, $end) after `unless`"), absent=True)

    def computation(self, variable: Token, expression: Expression) -> Computation:
        return Computation(self.variable(variable), expression)

    def guard(self, left: Expression, operator: Token, right: Expression) -> Guard:
        return Guard(str(operator), left, right, self.place(operator))

    def assertion(self, keyword: Token, *facts: Expression | None) -> Assertion:
        expected = "a fact to assert, such as fcn(negation, plain, $start, $end, 5)"
        return Assertion(tuple(self._atom(fact, expected) for fact in facts if fact is not None), self.place(keyword))

    def choice(self, keyword: Token, *alternatives: WeightedCalls | None) -> ChooseClause:
        return ChooseClause(tuple(filter(None, alternatives)), self.place(keyword))

    def alternative(self, keyword: Token, *parts: Any) -> WeightedCalls:  # noqa: ANN401  # lark hands parts over mixed
        numbers = [part for part in parts if isinstance(part, Token)]
        guards = tuple(part for part in parts if isinstance(part, Guard))
        calls = [part for part in parts if part is not None and not isinstance(part, Guard | Token)]
        sign = -1 if len(numbers) > 1 else 1
        weight = {"always": ALWAYS, "never": NEVER}.get(str(keyword)) or sign * self._value(numbers[-1])
        atoms = tuple(self._atom(call, "a behaviour such as small_nod($start, $end)") for call in calls)
        return WeightedCalls(weight, guards, atoms, self.place(keyword))

    def variable(self, token: Token) -> Variable:
        return Variable(str(token[1:]), self.place(token))

    def constant(self, constant: Constant) -> Constant:
        return constant

    def symbol(self, token: Token) -> Constant:
        return Constant(str(token), self.place(token))

    def text(self, token: Token) -> Constant:
        return Constant(re.sub(r"\\(.)", r"\1", token[1:-1]), self.place(token))

    def number(self, token: Token) -> Constant:
        value = self._value(token)
        return Constant(value if "." in token else int(value), self.place(token))

    def _value(self, token: Token) -> float:
        """The number of a token; 0 with a mistake for one beyond `LARGEST`, which ends all computations."""
        value = float(token)
        if value <= LARGEST:
            return value
        self.mistakes.append((self.place(token), f"{shown(token)} is beyond {LARGEST:g}"))
        return 0.0

    def alternatives(self, *constants: Constant) -> Alternatives:
        return Alternatives(tuple(constant.value for constant in constants), constants[0].place)

    def call(self, name: Token, *arguments: Expression | None) -> Atom:
        return Atom(str(name), tuple(part for part in arguments if part is not None), self.place(name))

    def WILDCARD(self, token: Token) -> Wildcard:  # noqa: N802  # lark names terminals in capitals
        return Wildcard(self.place(token))

    def negation(self, value: Expression) -> Expression:
        if isinstance(value, Constant) and not isinstance(value.value, str):
            return Constant(-value.value, value.place)
        return ArithmeticOperation("-", Constant(0, value.place), value, value.place)

    def addition(self, left: Expression, right: Expression) -> ArithmeticOperation:
        return ArithmeticOperation("+", left, right, left.place)

    def subtraction(self, left: Expression, right: Expression) -> ArithmeticOperation:
        return ArithmeticOperation("-", left, right, left.place)

    def multiplication(self, left: Expression, right: Expression) -> ArithmeticOperation:
        return ArithmeticOperation("*", left, right, left.place)

    def division(self, left: Expression, right: Expression) -> ArithmeticOperation:
        return ArithmeticOperation("/", left, right, left.place)

    def _atom(self, expression: Expression, expected: str) -> Atom:
        if isinstance(expression, Atom):
            return expression
        if isinstance(expression, Constant):
            expected += "; where a rule's name stands alone, `foreach` comes right below it"
        self.mistakes.append((expression.place, f"expected {expected}"))
        return Atom("", (), expression.place)
