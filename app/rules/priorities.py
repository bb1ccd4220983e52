"""The existing functions, by class and subtype, and their base priorities before rules raise them (paper §3.3).

`functions/priorities.yaml` is the single table of both: functions that are not in it are mistakes wherever they are
named.

Resolves conflicts between functions: which ones compete, and which of them is kept (paper §3.3).
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated, TypeAlias

from pydantic import ConfigDict, Field, RootModel

from ..errors import LONGEST_SHOWN, Mistake, did_you_mean
from ..model import Fact, Function
from ..yaml_files import Entry, Source
from .lexicon import LexicalEntry
from .program.program import Rule

Priority = Annotated[float, Field(gt=0, le=100)]


class Priorities(RootModel[Mapping[str, Mapping[str, Priority]]]):
    """The table: class to subtype to priority; higher is more important."""

    model_config = ConfigDict(frozen=True)

    @classmethod
    def load(cls, path: Path) -> "Priorities":
        """Raises AuthoringError with every mistake in the table."""
        return Source(path).validated(cls)

    def facts(self) -> Iterator[Fact]:
        """The table as facts, for the rules that raise priorities."""
        for class_name, subtypes in self.root.items():
            for subtype, priority in subtypes.items():
                yield Fact("base_priority", (class_name, subtype, priority))

    def unknown(self, class_name: str, subtype: str) -> str | None:
        """The message that there is no function of this class and subtype, with the known ones; None if there is
        one."""
        if class_name not in self.root:
            return f"no function has the class {class_name[:LONGEST_SHOWN]}{_meant(class_name, self.root)}"
        known = self.root[class_name]
        if subtype not in known:
            return f"{class_name} has no subtype {subtype[:LONGEST_SHOWN]}; its subtypes are {', '.join(known)}"
        return None

    def mistakes_in_rules(self, rules: Iterable[Rule]) -> Iterator[Mistake]:
        """Mistakes for rules that assert functions that are not in the table, where class and subtype are constants."""
        for rule in rules:
            for mention in rule.asserts:
                class_name, subtype = mention.arguments[:2] if mention.predicate == "fcn" else ("$", "$")
                reason = None if "$" in class_name + subtype else self.unknown(class_name, subtype)
                if reason:
                    yield Mistake(rule.path, rule.line, 1, f"rule {rule.name}: {reason}; priorities.yaml lists them")

    def mistakes_in_words(self, entries: Iterable[LexicalEntry]) -> Iterator[Mistake]:
        """Mistakes for words of a function class whose subtype the class does not have."""
        for entry in entries:
            if entry.subtype is not None and entry.subtype not in self.root.get(entry.class_name, {entry.subtype: 0}):
                yield Mistake(entry.path, entry.line, 1, f"{self.unknown(entry.class_name, entry.subtype)}")


def _meant(name: str, known: Iterable[str]) -> str:
    names = tuple(known)
    return did_you_mean(name, names, otherwise=f"; the classes are {', '.join(names)}")


_Kind: TypeAlias = tuple[str, str | None]
"""A class, and a subtype of it or None for all."""


class Conflicts(Entry):
    """Which functions compete when they share a word (`functions/conflicts.yaml`)."""

    within_class: frozenset[str]
    within_subtype: frozenset[str]
    between: tuple[tuple[str, str], ...]

    def rivals(self, function: Function) -> Iterator["_Kind"]:
        """The kinds of function that compete with this one where they share a word."""
        name = function.class_name
        if name in self.within_class:
            yield name, None
        elif name in self.within_subtype:
            yield name, function.subtype
        for one, other in self.between:
            if name in (one, other):
                yield (other if name == one else one), None

    def facts(self) -> Iterator[Fact]:
        """The classes whose functions compete with each other, as facts for rules that test this."""
        return (Fact("competes_within", (class_name,)) for class_name in sorted(self.within_class))


def resolved(functions: Sequence[Function], conflicts: Conflicts) -> tuple[Function, ...]:
    """The same functions, those that lose a conflict marked as not kept.

    Given functions take precedence; then the one with higher priority, the longer one, the earlier one.
    """
    strongest_on: defaultdict[_Kind, dict[int, tuple[int, Function]]] = defaultdict(dict)
    lost_to: dict[str, str] = {}
    for number, function in enumerate(sorted(functions, key=_rank)):
        words = range(function.first, function.last + 1)
        rivals = [strongest_on[kind] for kind in conflicts.rivals(function)]
        winner = next((min(found) for word in words if (found := [on[word] for on in rivals if word in on])), None)
        if winner is not None:
            lost_to[function.id] = winner[1].id
            continue
        for kind in _kinds(function):
            strongest_on[kind] |= {word: (number, function) for word in words if word not in strongest_on[kind]}
    return tuple(
        replace(function, kept=False, lost_to=lost_to[function.id]) if function.id in lost_to else function
        for function in functions
    )


def _kinds(function: Function) -> tuple[_Kind, _Kind]:
    return (function.class_name, None), (function.class_name, function.subtype)


def _rank(function: Function) -> tuple[bool, float, int, int]:
    return not function.given, -function.priority, function.first - function.last, function.first
