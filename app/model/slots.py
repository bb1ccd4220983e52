"""Slots: what the words of a gesture say of place and amount, so that the gesture can show it truly.

Sides are the performer's own, who faces the listener (what is on "your left" is on the performer's right), unless a
way is described. Directions follow docs/targets.md.
"""

from dataclasses import dataclass, fields
from enum import StrEnum


class Height(StrEnum):
    """How high, against the performer's own body."""

    KNEE = "knee"
    CHILD = "child"
    WAIST = "waist"
    CHEST = "chest"
    NECK = "neck"
    OWN = "own"
    OVER_HEAD = "over_head"


class Size(StrEnum):
    """How big, as hands can show it: a pinch, between the palms, arms apart, arms spread."""

    TINY = "tiny"
    SMALL = "small"
    BIG = "big"
    HUGE = "huge"


class Side(StrEnum):
    """On which side of the performer."""

    LEFT = "left"
    RIGHT = "right"
    FRONT = "front"
    BEHIND = "behind"


class Distance(StrEnum):
    """Within reach or beyond it."""

    NEAR = "near"
    FAR = "far"


class Which(StrEnum):
    """This one, that one, or the other."""

    THIS = "this"
    THAT = "that"
    OTHER = "other"


@dataclass(frozen=True, slots=True)
class Slots:
    """What the words of a gesture say; None where they say nothing.

    `height_m` and `size_m` are metres: as said in units of length, else usual for the class. `count` is how many (1 to
    10), `elevation_deg` the direction above (below, if negative) the eyes' level. `referent` identifies a thing within
    the line: the same one keeps its place. `listener` is the name of the target addressed.
    """

    height: Height | None = None
    height_m: float | None = None
    size: Size | None = None
    size_m: float | None = None
    count: int | None = None
    side: Side | None = None
    distance: Distance | None = None
    elevation_deg: float | None = None
    which: Which | None = None
    referent: str | None = None
    listener: str | None = None

    def __bool__(self) -> bool:
        return any(getattr(self, each.name) is not None for each in fields(self))
