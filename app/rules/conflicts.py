"""Functions that cannot both be shown: which compete, and which of them stays (paper §3.3)."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace

from ..model import Function
from ..yaml_files import Entry
from .chaining.chainer import Fact


class Conflicts(Entry):
    """Which functions compete when they share a word (`functions/conflicts.yaml`)."""

    within_class: frozenset[str]
    within_subtype: frozenset[str]
    between: tuple[tuple[str, str], ...]

    def compete(self, one: Function, other: Function) -> bool:
        """Whether the two cannot both be shown."""
        if one.first > other.last or other.first > one.last:
            return False
        if one.class_name == other.class_name:
            same_subtype = one.subtype == other.subtype and one.class_name in self.within_subtype
            return same_subtype or one.class_name in self.within_class
        pairs = (one.class_name, other.class_name), (other.class_name, one.class_name)
        return any(pair in self.between for pair in pairs)

    def facts(self) -> Iterator[Fact]:
        """The classes whose functions compete with each other, for the rules that ask."""
        return (Fact("competes_within", (class_name,)) for class_name in sorted(self.within_class))


def resolved(functions: Sequence[Function], conflicts: Conflicts) -> tuple[Function, ...]:
    """The same functions, those marked that lose a conflict to one that is kept.

    What was given from outside stays before all else; then the higher priority, the longer, the earlier.
    """
    strongest_first = sorted(functions, key=_rank)
    kept_on: dict[int, list[Function]] = defaultdict(list)
    lost_to: dict[str, str] = {}
    for function in strongest_first:
        words = range(function.first, function.last + 1)
        rivals = (other for word in words for other in kept_on[word])
        winner = next((other for other in rivals if conflicts.compete(function, other)), None)
        if winner is not None:
            lost_to[function.id] = winner.id
            continue
        for word in words:
            kept_on[word].append(function)
    return tuple(
        replace(function, kept=False, lost_to=lost_to[function.id]) if function.id in lost_to else function
        for function in functions
    )


def _rank(function: Function) -> tuple[bool, float, int, int]:
    return not function.given, -function.priority, function.first - function.last, function.first
