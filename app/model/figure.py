"""The appearance of a character and its manner of gesturing: the values of `body`, `looks` and `gestures` in its file.

They are part of the data model because the file is read where behaviours are chosen, and used where they are realized.
Conventions: widths, build, space and pace are relative to the average, 1; colours are sRGB, "#rrggbb". The ranges are
those for which the body was tested (docs/characters.md).
"""

from dataclasses import dataclass
from enum import StrEnum

from .body import Hand

AVERAGE_HEIGHT_M = 1.73


class Sex(StrEnum):
    """The sex of a body; `NEUTRAL` has proportions between the other two."""

    FEMALE = "female"
    MALE = "male"
    NEUTRAL = "neutral"


class Hair(StrEnum):
    BALD = "bald"
    SHORT = "short"
    BOB = "bob"
    LONG = "long"
    BUN = "bun"


class Legwear(StrEnum):
    TROUSERS = "trousers"
    SKIRT = "skirt"


@dataclass(frozen=True, slots=True)
class Physique:
    """The proportions of a body. `build` scales its girth; `shoulder_width` and `hip_width` are relative to the average
    of that height and sex."""

    sex: Sex = Sex.NEUTRAL
    age_years: int = 35
    height_m: float = AVERAGE_HEIGHT_M
    build: float = 1.0
    shoulder_width: float = 1.0
    hip_width: float = 1.0


@dataclass(frozen=True, slots=True)
class Looks:
    """Hair, clothes and colours."""

    hair: Hair = Hair.SHORT
    legwear: Legwear = Legwear.TROUSERS
    hair_colour: str = "#3c3029"
    skin_colour: str = "#c59f88"
    eye_colour: str = "#59737c"
    top_colour: str = "#597c8e"
    legwear_colour: str = "#424852"
    shoe_colour: str = "#303035"


@dataclass(frozen=True, slots=True)
class GestureManner:
    """How a character varies every gesture of the library.

    `space` scales gesture space about its centre and `pace` the speed of all phases; `elbow_deg` turns the elbow
    outwards and up (negative: towards the body), `wrist_deg` bends the hand back (negative: lets it hang).
    """

    space: float = 1.0
    pace: float = 1.0
    elbow_deg: float = 0.0
    wrist_deg: float = 0.0


PLAIN_MANNER = GestureManner()
"""Gestures unchanged from the library."""


class Wait(StrEnum):
    """How hands wait between two gestures: both before the belly, alike or unevenly; one of them there while the other
    hangs, is on the hip or in the pocket; one holding the other arm; or both open to the sides, one higher."""

    BELLY = "belly"
    UNEVEN = "uneven"
    ONE = "one"
    HIP = "hip"
    POCKET = "pocket"
    FOREARM = "forearm"
    OPEN = "open"


@dataclass(frozen=True, slots=True)
class Figure:
    """Body, looks and manner of one character, the hand that it prefers (`leading`), and how its hands wait between two
    gestures (none given: in all ways)."""

    physique: Physique = Physique()
    looks: Looks = Looks()
    manner: GestureManner = PLAIN_MANNER
    leading: Hand = Hand.RIGHT
    waits: tuple[Wait, ...] = ()


PLAIN = Figure()
"""The figure of a character without a file: an adult of 1.73 m."""
