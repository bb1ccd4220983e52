"""Finds the name that was probably meant, among ids of lines and names of recordings.

Such names differ mostly in their numbers, and the next number is never what was meant. So two names are near if their
numbers are the same except for leading zeros and their letters are similar.
"""

import re
from collections import Counter, defaultdict
from collections.abc import Iterable

LEAST_LIKENESS = 0.6
"""The least Dice coefficient of the trigrams of two names that are near."""

_RUNS = re.compile(r"\d+|[^\W\d_]+")


class NearNames:
    """A set of names that is searched for near ones."""

    def __init__(self, names: Iterable[str]) -> None:
        self._by_numbers: dict[tuple[int, ...], list[tuple[str, Counter[str]]]] = defaultdict(list)
        for name in names:
            self._by_numbers[_numbers(name)].append((name, _trigrams(name)))

    def nearest(self, name: str) -> str | None:
        """The nearest name, or None."""
        own = _trigrams(name)
        likenesses = [(_likeness(own, theirs), other) for other, theirs in self._by_numbers[_numbers(name)]]
        best = max(likenesses, default=(0.0, ""))
        return best[1] if best[0] >= LEAST_LIKENESS else None


def _numbers(name: str) -> tuple[int, ...]:
    return tuple(int(run) for run in _RUNS.findall(name) if run.isdecimal())


def _trigrams(name: str) -> Counter[str]:
    """The trigrams of the letters, padded at both ends; numbers are compared separately."""
    letters = "".join(run.casefold() for run in _RUNS.findall(name) if not run.isdecimal())
    marked = f"  {letters} "
    return Counter(marked[place : place + 3] for place in range(len(marked) - 2))


def _likeness(first: Counter[str], second: Counter[str]) -> float:
    return 2 * (first & second).total() / (first.total() + second.total())
