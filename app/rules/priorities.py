"""The existing functions, by class and subtype, and their base priorities before rules raise them (paper §3.3).

`functions/priorities.yaml` is the single table of both: functions that are not in it are mistakes wherever they are
named.

Resolves conflicts between functions: which ones compete, and which of them is kept (paper §3.3): by a table
(`resolved`), or all that overlap, as the paper has it (`resolved_as_in_paper`).
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
from .program.loading import FactMention, Rule

_OPEN = ("$", "_")
"""How an argument begins that is no constant: a variable, or anything."""

Priority = Annotated[float, Field(gt=0, le=100)]


class Priorities(RootModel[Mapping[str, Mapping[str, Priority]]]):
    """The table: class to subtype to priority; higher is more important."""

    model_config = ConfigDict(defer_build=True, frozen=True)

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
            return self._no_class(class_name)
        return None if subtype in self.root[class_name] else self._no_subtype(class_name, subtype)

    def _no_class(self, name: str) -> str:
        return f"no function has the class {name[:LONGEST_SHOWN]}{_meant(name, self.root)}"

    def _no_subtype(self, class_name: str, name: str) -> str:
        return (
            f"{class_name} has no subtype {name[:LONGEST_SHOWN]}; its subtypes are {', '.join(self.root[class_name])}"
        )

    def mistakes_in_rules(self, rules: Iterable[Rule]) -> Iterator[Mistake]:
        """Mistakes for rules that assert or join functions that are not in the table, where class and subtype are
        constants."""
        for rule in rules:
            for mention in (*rule.asserts, *rule.joins):
                for reason in self._unknown_in(mention):
                    yield Mistake(rule.path, rule.line, 1, f"rule {rule.name}: {reason}; priorities.yaml lists them")

    def _unknown_in(self, mention: FactMention) -> Iterator[str]:
        """Why a mentioned function does not exist: for each of its classes, and each subtype that none of them has."""
        if mention.predicate != "fcn" or mention.arguments[0][:1] in _OPEN:
            return
        classes, subtypes = (argument.split("|") for argument in mention.arguments[:2])
        missing = [name for name in classes if name not in self.root]
        yield from map(self._no_class, missing)
        if missing:
            return
        for subtype in subtypes:
            if subtype[:1] not in _OPEN and all(subtype not in self.root[name] for name in classes):
                yield self._no_subtype(classes[0], subtype)

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
    return tuple(_marked(functions, lost_to))


def resolved_as_in_paper(functions: Sequence[Function]) -> tuple[Function, ...]:
    """The same functions, where of those still kept any two that share a word compete, whatever their classes: "these
    priorities are used to resolve conflicts between overlapping functions with lower priorities being dropped" (paper
    §3.3). Then the longer wins, then the earlier. Given functions compete too, by their priority, but none is
    dropped."""
    strongest_on: dict[int, Function] = {}
    lost_to: dict[str, str] = {}
    for function in sorted((each for each in functions if each.kept), key=_importance):
        words = range(function.first, function.last + 1)
        winners = [strongest_on[word] for word in words if word in strongest_on]
        if winners and not function.given:
            lost_to[function.id] = min(winners, key=_importance).id
            continue
        strongest_on |= {word: function for word in words if word not in strongest_on}
    return tuple(_marked(functions, lost_to))


def _marked(functions: Iterable[Function], lost_to: Mapping[str, str]) -> Iterator[Function]:
    """The functions, those that lost as not kept."""
    for function in functions:
        winner = lost_to.get(function.id)
        yield replace(function, kept=False, lost_to=winner) if winner else function


def _kinds(function: Function) -> tuple[_Kind, _Kind]:
    return (function.class_name, None), (function.class_name, function.subtype)


def _rank(function: Function) -> tuple[bool, tuple[float, int, int]]:
    return not function.given, _importance(function)


def _importance(function: Function) -> tuple[float, int, int]:
    return -function.priority, function.first - function.last, function.first
