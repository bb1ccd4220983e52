"""The state of a derivation: the facts, indexed by the arguments that joins look up, and the reason for each.

A `Knowledge` lives for one derivation and is the only mutable object in the chainer.
"""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf
from operator import itemgetter
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

from ..errors import AuthoringError, Mistake
from ..model.functions import Argument, Fact

Environment: TypeAlias = list[Any]
"""The slots of a rule while it is matched: its constants, the values of its variables, the facts it joined."""

Beginning: TypeAlias = tuple[str, Argument | None]
"""A predicate and a first argument, or None for any: the key by which facts of the last round are looked up."""

Pick: TypeAlias = Callable[[Sequence[Any]], Any]


def pick(places: Sequence[int]) -> Pick:
    """A function that picks the values at `places` as a key: one value bare, several as a tuple, none as the empty
    tuple."""
    return itemgetter(*places) if places else _nothing


def _nothing(_row: Sequence[Any]) -> tuple[()]:
    return ()


@dataclass(frozen=True, slots=True)
class Origin:
    """A place in a rule file, for errors that occur while the rule runs."""

    path: Path
    line: int
    column: int
    source_line: str
    rule: str

    def error(self, message: str) -> AuthoringError:
        return AuthoringError(
            (Mistake(self.path, self.line, self.column, f"rule {self.rule}: {message}", self.source_line),)
        )


@dataclass(frozen=True, slots=True)
class Limits:
    """The largest size of a derivation; a line of a hundred words needs a hundredth of it."""

    facts: int = 200_000
    rounds: int = 10_000


@dataclass(frozen=True, slots=True)
class Reason:
    """Why a fact holds: the first rule that derived it, and the facts it joined."""

    origin: Origin
    supports: tuple[Fact, ...]

    @property
    def rule(self) -> str:
        return self.origin.rule

    @property
    def path(self) -> Path:
        return self.origin.path

    @property
    def line(self) -> int:
        return self.origin.line


@dataclass(frozen=True, slots=True)
class Call:
    """A behaviour with its arguments, the words it spans or shows."""

    name: str
    arguments: tuple[Argument, ...]


@dataclass(frozen=True, slots=True)
class AlternativeCalls:
    """Behaviours to be shown together; their probability is `weight` over the sum of the alternatives' weights."""

    weight: float
    calls: tuple[Call, ...]


@dataclass(frozen=True, slots=True)
class Choice:
    """The offer of a choose-rule that matched: the alternatives whose guards hold, and the facts it joined."""

    origin: Origin
    supports: tuple[Fact, ...]
    alternatives: tuple[AlternativeCalls, ...]

    @property
    def rule(self) -> str:
        return self.origin.rule


@dataclass(frozen=True, slots=True)
class Index:
    """The facts of `predicate` by the arguments at `positions` (in order)."""

    predicate: str
    positions: tuple[int, ...]


class Claim(NamedTuple):
    """The annotation that one match of a rule would give a fact, computed from the annotations of the facts in
    `reads`."""

    fact: Fact
    reads: tuple[Fact, ...]
    value: Callable[[dict[Fact, float]], float]


Filed: TypeAlias = defaultdict[object, list[Fact]]


@dataclass(slots=True)
class SortedNumbers:
    """The numbers that the facts in a list have as one of their arguments, sorted, each with its fact's index in the
    list."""

    values: list[tuple[int | float, int]] = field(default_factory=list)
    has_texts: bool = False

    def take(self, facts: Sequence[Fact], position: int) -> None:
        """Includes the facts added to the list since the last call."""
        if self.has_texts or len(facts) == len(self.values):
            return
        for number in range(len(self.values), len(facts)):
            value = facts[number].arguments[position]
            if isinstance(value, str):
                self.has_texts = True
                return
            self.values.append((value, number))
        self.values.sort()


@dataclass(slots=True)
class Knowledge:
    """Facts in order of derivation, filed under every index. New facts are filed when the round ends (`end_round`)."""

    indexes: tuple[Index, ...]
    limits: Limits
    filed: list[Filed] = field(default_factory=list)
    known: defaultdict[str, dict[tuple[Argument, ...], Fact]] = field(default_factory=lambda: defaultdict(dict))
    facts: list[Fact] = field(default_factory=list)
    reasons: dict[Fact, Reason] = field(default_factory=dict)
    claims: list[Claim] = field(default_factory=list)
    annotations: dict[Fact, float] = field(default_factory=dict)
    choices: list[Choice] = field(default_factory=list)
    recent: defaultdict[Beginning, list[Fact]] = field(default_factory=lambda: defaultdict(list))
    _pending: list[Fact] = field(default_factory=list)
    _filing: Mapping[str, list[tuple[Pick, Filed]]] = field(default_factory=dict)
    _sorted: dict[tuple[int, object, int], SortedNumbers] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.filed = [defaultdict(list) for _ in self.indexes]
        filing: defaultdict[str, list[tuple[Pick, Filed]]] = defaultdict(list)
        for index, filed in zip(self.indexes, self.filed, strict=True):
            filing[index.predicate].append((pick(index.positions), filed))
        self._filing = filing

    def give(self, facts: Iterable[Fact]) -> None:
        """Adds facts that need no reason; joins find them at once."""
        for fact in in_canonical_order(facts):
            if fact.arguments not in self.known[fact.predicate]:
                self.known[fact.predicate][fact.arguments] = fact
                self.facts.append(fact)
        self._file(self.facts)

    def between(self, index: int, key: object, position: int, *, least: Argument, most: Argument) -> Sequence[Fact]:
        """The facts under the key whose argument at `position` is between two numbers, both included, in order of
        derivation; all facts under the key if there are texts among these arguments."""
        facts = self.filed[index][key]
        if isinstance(least, str) or isinstance(most, str):
            return facts
        ordered = self._sorted.setdefault((index, key, position), SortedNumbers())
        ordered.take(facts, position)
        if ordered.has_texts:
            return facts
        begin, end = bisect_left(ordered.values, (least,)), bisect_right(ordered.values, (most, len(facts)))
        return [facts[number] for number in sorted(number for _, number in ordered.values[begin:end])]

    def add(self, predicate: str, arguments: tuple[Argument, ...]) -> tuple[Fact, bool]:
        """The fact, and whether it is new; joins find a new one from the next round on."""
        known = self.known[predicate]
        fact = known.get(arguments)
        if fact is not None:
            return fact, False
        fact = known[arguments] = Fact(predicate, arguments)
        self.facts.append(fact)
        self._pending.append(fact)
        return fact, True

    def end_round(self) -> bool:
        """Files the new facts of this round, so that joins find them and `recent` has them; False if there were
        none."""
        brought, self._pending = self._pending, []
        self._file(brought)
        self.recent.clear()
        for fact in brought:
            self.recent[fact.predicate, None].append(fact)
            if fact.arguments:
                self.recent[fact.predicate, fact.arguments[0]].append(fact)
        return bool(brought)

    def claim(self, fact: Fact, annotation: float) -> None:
        """Raises the fact's annotation to `annotation`, unless it is already as high."""
        if annotation > self.annotations.get(fact, -inf):
            self.annotations[fact] = annotation

    def blamed(self) -> Origin:
        """The rule that derived the latest fact."""
        return self.reasons[self.facts[-1]].origin

    def _file(self, facts: Iterable[Fact]) -> None:
        for fact in facts:
            for key, filed in self._filing.get(fact.predicate, ()):
                filed[key(fact.arguments)].append(fact)


def in_canonical_order(facts: Iterable[Fact]) -> list[Fact]:
    """The facts sorted by predicate and arguments, numbers before texts, regardless of their original order."""
    listed = list(facts)
    try:
        return sorted(listed)
    except TypeError:  # an argument is a text in one fact and a number in another
        return sorted(listed, key=lambda fact: (fact.predicate, [(isinstance(a, str), a) for a in fact.arguments]))
