"""Communicative functions of words (paper §3.3), derived or given, with their justification."""

from dataclasses import dataclass

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
