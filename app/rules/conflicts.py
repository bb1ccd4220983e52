"""Resolves conflicts between functions: which ones compete, and which of them is kept (paper §3.3)."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TypeAlias

from ..model import Fact, Function
from ..yaml_files import Entry

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
