"""Communicative functions of words (paper §3.3), derived or given, with their justification.

A fact of the rule language: what is known of a line, given or derived (paper §3.3).

Why something was chosen: named parts of a sum.
"""

from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

PLAIN = "plain"
"""The subtype of a function whose class has none; in output it is the empty string."""


@dataclass(frozen=True, slots=True)
class Because:
    """One support of a derivation: a word of the transcript, or a fact with the rule that derived it (None: given)."""

    word: int | None = None
    fact: str | None = None
    rule: str | None = None


@dataclass(frozen=True, slots=True)
class Function:
    """A communicative function (paper §3.3) of words `first` to `last`, with its priority and justification.

    A function that lost a conflict stays, with `kept` false and the winner's id in `lost_to`. `given` marks a function
    that was not derived but came with the line.
    """

    id: str
    class_name: str
    subtype: str
    first: int
    last: int
    priority: float
    rule: str
    because: tuple[Because, ...] = ()
    kept: bool = True
    lost_to: str | None = None
    given: bool = False


@dataclass(frozen=True, slots=True)
class GivenFunction:
    """A function that the caller already knows; priority None ranks it above all that rules derive."""

    class_name: str
    subtype: str
    first: int
    last: int
    priority: float | None = None


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


@dataclass(frozen=True, slots=True)
class Term:
    """One reason for or against a choice: a fact about the words, the voice, a rule or the author, and its weight
    (log-odds)."""

    name: str
    weight: float
