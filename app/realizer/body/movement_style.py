"""How alive a body is (lexicon/movement.yaml): second hand, two hands, holds, the trunk in strokes and by itself.

The classes are the schema of the file as well, whose comments explain the keys. Without a file, as by default, the body
does no more than its schedule asks: every amount is 0.
"""

from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import Annotated, ClassVar, TypeAlias

from pydantic import AfterValidator, ConfigDict, Field

from ...yaml_files import Entry, Source


def _rising(ends: tuple[float, float]) -> tuple[float, float]:
    if ends[0] > ends[1]:
        raise ValueError("the first end of a range is the smaller one")
    return ends


Share: TypeAlias = Annotated[float, Field(ge=0, le=1)]
Seconds: TypeAlias = Annotated[float, Field(ge=0, le=5)]
Degrees: TypeAlias = Annotated[float, Field(ge=0, le=20)]
Metres: TypeAlias = Annotated[float, Field(ge=0, le=0.4)]
Hertz: TypeAlias = Annotated[float, Field(ge=0.01, le=2)]
Shares: TypeAlias = Annotated[tuple[Share, Share], AfterValidator(_rising)]
SecondsRange: TypeAlias = Annotated[tuple[Seconds, Seconds], AfterValidator(_rising)]
MetresRange: TypeAlias = Annotated[tuple[Metres, Metres], AfterValidator(_rising)]

_STRICT = ConfigDict(extra="forbid")


@dataclass(frozen=True, slots=True)
class SecondHand:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    follows: Share = 0.0
    share: Shares = (0.0, 0.0)
    lag_s: SecondsRange = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class TwoHands:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    lag_s: SecondsRange = (0.0, 0.0)
    smaller: Shares = (0.0, 0.0)
    bend_deg: Degrees = 0.0


@dataclass(frozen=True, slots=True)
class Holds:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    longest_s: Annotated[float, Field(ge=0.3)] = inf
    way_m: MetresRange = (0.0, 0.0)
    spacing_s: SecondsRange = (1.0, 1.0)


@dataclass(frozen=True, slots=True)
class StrokeLife:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    dip_m: Metres = 0.0
    bow_deg: Degrees = 0.0
    twist_deg: Degrees = 0.0
    shoulders_deg: Degrees = 0.0
    weight_m: Metres = 0.0
    neck_deg: Degrees = 0.0


@dataclass(frozen=True, slots=True)
class IdleLife:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    weight: Share = 0.5
    weight_hz: Hertz = 0.06
    sway_m: Metres = 0.018
    sway_hz: Hertz = 0.23
    bob_m: Metres = 0.0
    bob_hz: Hertz = 0.4
    bend_deg: Degrees = 2.0
    slump_deg: Degrees = 0.0
    slump_hz: Hertz = 0.3
    neck_forward_deg: Degrees = 0.0
    neck_deg: Degrees = 0.0
    breath_deg: Degrees = 2.0
    stance_weight: Share = 0.0
    ribs_side_deg: Degrees = 0.0
    ribs_twist_deg: Degrees = 0.0


@dataclass(frozen=True, slots=True)
class MovementStyle:
    """The whole file. `idle` has what a body does by itself even without one: it is never quite still."""

    second_hand: SecondHand = SecondHand()
    two_hands: TwoHands = TwoHands()
    holds: Holds = Holds()
    stroke: StrokeLife = StrokeLife()
    idle: IdleLife = IdleLife()

    @classmethod
    def load(cls, path: Path) -> "MovementStyle":
        """The style of a file; raises AuthoringError with every mistake at its place."""
        file = Source(path).validated(_MovementFile)
        return cls(file.second_hand, file.two_hands, file.holds, file.stroke, file.idle)


class _MovementFile(Entry):
    second_hand: SecondHand
    two_hands: TwoHands
    holds: Holds
    stroke: StrokeLife
    idle: IdleLife


PLAIN = MovementStyle()
