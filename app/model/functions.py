"""What words do: communicative functions (paper §3.3), derived or given, and why we think so."""

from dataclasses import dataclass

PLAIN = "plain"
"""The subtype of a function whose class has none; it leaves as the empty string."""


@dataclass(frozen=True, slots=True)
class Because:
    """One support of a derivation: a word of the transcript, or a fact with the rule that derived it (None: given)."""

    word: int | None = None
    fact: str | None = None
    rule: str | None = None


@dataclass(frozen=True, slots=True)
class Function:
    """A communicative function (paper §3.3): what words `first` to `last` do, how much it matters, and why we think so.

    A function that lost a conflict stays, with `kept` false and the winner's id in `lost_to`. `given` tells that it was
    not derived but came with the line.
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
    """A function that the caller already knows; `priority` None is above all that rules derive."""

    class_name: str
    subtype: str
    first: int
    last: int
    priority: float | None = None
