"""A director's notes on a line: what the body should mean, and what it should not do (docs/directing.md)."""

from dataclasses import dataclass

from .choice import Demand


@dataclass(frozen=True, slots=True)
class DirectedMoment:
    """A director's note: over words `first` to `last` the body should express something, with the hand's stroke on
    `stroke`.

    `gesture` are families of gestures (docs/directing.md), any of which would be right, the best first; `head`, `face`
    and `gaze` likewise. An empty tuple leaves the channel to the rules, ("still",) keeps it still. `importance` is 1
    (nice) to 3 (the line fails without it).
    """

    first: int
    last: int
    stroke: int
    importance: int = 2
    gesture: tuple[str, ...] = ()
    head: tuple[str, ...] = ()
    face: tuple[str, ...] = ()
    gaze: tuple[str, ...] = ()
    idea: str = ""


@dataclass(frozen=True, slots=True)
class Avoidance:
    """A director's note: over words `first` to `last` nothing of `what` (families of any channel; "hands" is every
    gesture, "any" everything)."""

    first: int
    last: int
    what: tuple[str, ...]
    why: str = ""


@dataclass(frozen=True, slots=True)
class Direction:
    """A director's notes on a line, with what is to come always or never (`demands`). If it is `complete`, the hands do
    only what the notes say."""

    moments: tuple[DirectedMoment, ...] = ()
    avoid: tuple[Avoidance, ...] = ()
    demands: tuple[Demand, ...] = ()
    complete: bool = False
