"""A fact of the rule language: what is known of a line, given or derived (paper §3.3)."""

from typing import NamedTuple, TypeAlias

Argument: TypeAlias = str | int | float
"""An argument of a fact: a text (symbols are texts) or a number."""


class Fact(NamedTuple):
    """`predicate(arguments)`, without the annotation: two facts are one when predicate and arguments are equal.

    A named tuple, unlike our other values: a line makes hundreds and hashes them thousands of times.
    """

    predicate: str
    arguments: tuple[Argument, ...]

    def __str__(self) -> str:
        return f"{self.predicate}({', '.join(map(str, self.arguments))})"
