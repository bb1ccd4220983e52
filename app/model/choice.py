"""The plan and the candidates: moments, the behaviours that could show them, and why they win or lose (paper §3.4)."""

from dataclasses import dataclass
from enum import StrEnum

from .body import Channel
from .functions import Function, Term


class Mode(StrEnum):
    """Where the gestures come from, as in the paper's study (§5): the meaning, the stress, or chance."""

    SEMANTIC = "semantic"
    PROSODY = "prosody"
    RANDOM = "random"


@dataclass(frozen=True, slots=True)
class RejectedAlternative:
    """An alternative that lost at a moment: its families, their expected worth, and the reason."""

    families: tuple[str, ...]
    worth: float
    reason: str


@dataclass(frozen=True, slots=True)
class Moment:
    """Words `first` to `last`, during which one channel expresses something; a gesture's stroke falls on word `stroke`.

    `families` are the possible meanings, the likeliest first, `shares` the probability of each that a director wants it
    there. `importance` ranks the moments of a line. `terms` made the first family win, the heaviest first; `rejected`
    lost to it. `note` is the number of the director's note it comes from, if any; `set_against` is the word of the
    stroke that shows the other side of its contrast. One that is `demanded` was asked for always.
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
    rejected: tuple[RejectedAlternative, ...] = ()
    note: int | None = None
    set_against: int | None = None
    demanded: bool = False


@dataclass(frozen=True, slots=True)
class Movement:
    """A behaviour class, `name` in its table, that could show a function (paper §3.4), regardless of time and
    neighbours.

    Its stroke falls on word `stroke`; if that is None, on the word of its span that the table says. `moment` is the id
    of the moment it shows, `target` its target if that is not the table's. `decided_by` are the named parts of its
    worth in log-odds, the largest first.
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
    decided_by: tuple[Term, ...] = ()


@dataclass(frozen=True, slots=True)
class Demand:
    """What is shown `always` over words `first` to `last`, or never: above all worths.

    `what` is a behaviour, a lexeme or a family; of what never comes, a channel too. `by` says who demands it.
    """

    what: str
    first: int
    last: int
    always: bool
    by: str
    function: str | None = None


@dataclass(frozen=True, slots=True)
class CallableNames:
    """What mapping rules may call: `behaviors` of the table; below `always` what is in `demandable` too, below `never`
    what is in `bannable`."""

    behaviors: frozenset[str]
    demandable: frozenset[str] = frozenset()
    bannable: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Alternative:
    """Movements that show a function together, or any part of them (paper §3.4).

    `weight` is how often a rule wants them, `lot` a random draw (exponential, mean 1). If nothing else decides between
    alternatives, the smallest `lot / weight` wins, so that each is chosen in proportion to its weight.
    """

    movements: tuple[Movement, ...]
    weight: float
    lot: float


@dataclass(frozen=True, slots=True)
class BehaviorCandidates:
    """A function or a moment to be shown, and everything that could show it; at least one alternative."""

    function: Function | None
    alternatives: tuple[Alternative, ...]
    moment: Moment | None = None

    @property
    def priority(self) -> float:
        """Decides what is shown where not everything can be: the importance of a moment, the priority of a function."""
        return max(movement.priority for alternative in self.alternatives for movement in alternative.movements)

    @property
    def rank(self) -> tuple[float, int, int, str]:
        """Sort key: the most important first, then by position."""
        shown = self.moment or self.function
        assert shown is not None, "candidates show something"
        return -self.priority, shown.first, shown.last, shown.id


@dataclass(frozen=True, slots=True)
class MappedFunctions:
    """What the mapping rules say of a line: what they offer for functions, and what they demand always or never."""

    offers: tuple[BehaviorCandidates, ...] = ()
    demands: tuple[Demand, ...] = ()
