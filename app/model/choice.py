"""What could be shown, and why it is or is not: moments, and the behaviours that compete for them (paper §3.4)."""

from dataclasses import dataclass
from enum import StrEnum

from .body import Channel
from .functions import Function


class Mode(StrEnum):
    """Where the gestures come from, as in the paper's study (§5): the meaning, the stress, or chance."""

    SEMANTIC = "semantic"
    PROSODY = "prosody"
    RANDOM = "random"


@dataclass(frozen=True, slots=True)
class Term:
    """One reason for or against a choice: a fact about the words, and what it weighs (log-odds)."""

    name: str
    weight: float


@dataclass(frozen=True, slots=True)
class Rejected:
    """What a moment might have been and is not: the families that lost, what they would have been worth, and why."""

    families: tuple[str, ...]
    worth: float
    reason: str


@dataclass(frozen=True, slots=True)
class Moment:
    """Words `first` to `last`, over which one channel means something; a gesture's stroke falls on word `stroke`.

    `families` are what it may mean, the likeliest first, `shares` how likely each is to be what a director wants there.
    `importance` ranks the moments of a line. `terms` made the first family win, the heaviest first; `rejected` lost to
    it. `note` is the number of the director's note it comes from, if any; `set_against` is the word of the stroke that
    shows the other side of its contrast.
    """

    id: str
    channel: Channel
    first: int
    last: int
    stroke: int
    families: tuple[str, ...]
    importance: float
    shares: tuple[float, ...] = ()
    terms: tuple[Term, ...] = ()
    rejected: tuple[Rejected, ...] = ()
    note: int | None = None
    set_against: int | None = None


@dataclass(frozen=True, slots=True)
class Movement:
    """A behaviour class, `name` in its table, that could show a function (paper §3.4), clock and neighbours aside.

    Its stroke falls on word `stroke`; where that is None, on the word of its span that the table says. `moment` is the
    id of the moment it makes visible, `target` what it is at if not what the table says.
    """

    name: str
    first: int
    last: int
    priority: float
    rule: str
    function: str | None
    stroke: int | None = None
    moment: str | None = None
    target: str | None = None


@dataclass(frozen=True, slots=True)
class Alternative:
    """Movements that show a function together, or any part of them (paper §3.4).

    `weight` is how often a rule wants them, `lot` the luck they drew (exponential, mean 1). Where nothing else speaks
    for one of several alternatives the smallest `lot / weight` wins, which takes each in proportion to its weight.
    """

    movements: tuple[Movement, ...]
    weight: float
    lot: float


@dataclass(frozen=True, slots=True)
class BehaviorCandidates:
    """A function or a moment that wants to be shown, and all that could show it; at least one alternative."""

    function: Function | None
    alternatives: tuple[Alternative, ...]
    moment: Moment | None = None

    @property
    def priority(self) -> float:
        """What is shown first where not all can be: a moment by what it is worth, a function by its priority."""
        return max(movement.priority for alternative in self.alternatives for movement in alternative.movements)

    @property
    def rank(self) -> tuple[float, int, int, str]:
        """Sorts candidates: the most important first, then by their words."""
        shown = self.moment or self.function
        assert shown is not None, "candidates show something"
        return -self.priority, shown.first, shown.last, shown.id
