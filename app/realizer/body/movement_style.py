"""How alive a body is (lexicon/movement.yaml): second hand, two hands, holds, the trunk in strokes and by itself.

The classes are the schema of the file as well, whose comments explain the keys. Without a file, as by default, the body
does no more than its schedule asks: every amount is 0.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from math import inf
from pathlib import Path
from typing import Annotated, ClassVar, Literal, TypeAlias

from pydantic import AfterValidator, ConfigDict, Field

from ...errors import AuthoringError, did_you_mean
from ...model.figure import Figure, GestureManner, Sex, Wait
from ...yaml_files import Entry, Source


def _rising(ends: tuple[float, float]) -> tuple[float, float]:
    if ends[0] > ends[1]:
        raise ValueError("the first end of a range is the smaller one")
    return ends


Share: TypeAlias = Annotated[float, Field(ge=0, le=1)]
Seconds: TypeAlias = Annotated[float, Field(ge=0, le=5)]
Degrees: TypeAlias = Annotated[float, Field(ge=0, le=20)]
Reach: TypeAlias = Annotated[float, Field(ge=0, le=0.6)]
Aside: TypeAlias = Annotated[float, Field(ge=-0.15, le=0.15)]
OpenHand: TypeAlias = Literal["form_default", "form_flat", "form_spread"]
Bend: TypeAlias = Annotated[float, Field(ge=0, le=60)]
Turn: TypeAlias = Annotated[float, Field(ge=-20, le=20)]
Lift: TypeAlias = Annotated[float, Field(ge=-0.2, le=0.2)]
Metres: TypeAlias = Annotated[float, Field(ge=0, le=0.4)]
Hertz: TypeAlias = Annotated[float, Field(ge=0.01, le=2)]
Weight: TypeAlias = Annotated[float, Field(ge=0, le=100)]
Speed: TypeAlias = Annotated[float, Field(ge=0, le=2)]
Unhurried: TypeAlias = Annotated[float, Field(ge=0.2, le=2)]
Factor: TypeAlias = Annotated[float, Field(gt=0, le=4)]
Factors: TypeAlias = Annotated[tuple[Factor, Factor], AfterValidator(_rising)]
Shares: TypeAlias = Annotated[tuple[Share, Share], AfterValidator(_rising)]
SecondsRange: TypeAlias = Annotated[tuple[Seconds, Seconds], AfterValidator(_rising)]
MetresRange: TypeAlias = Annotated[tuple[Metres, Metres], AfterValidator(_rising)]

_STRICT = ConfigDict(defer_build=True, extra="forbid")


@dataclass(frozen=True, slots=True)
class SecondHand:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    follows: Share = 0.0
    share: Shares = (0.0, 0.0)
    lag_s: SecondsRange = (0.0, 0.0)
    near_belly: bool = False


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
class Strokes:
    """Three values are those of low, medium and high agitation, here and below."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    speed_m_s: tuple[Speed, Speed, Speed] = (0.0, 0.0, 0.0)
    fastest_m_s: tuple[Speed, Speed, Speed] = (1.4, 1.4, 1.4)
    variety: Factors = (1.0, 1.0)
    shortest_s: Seconds = 0.0
    lift_m: tuple[Lift, Lift, Lift] = (0.0, 0.0, 0.0)
    wind_up: tuple[Factor, Factor, Factor] = (1.0, 1.0, 1.0)
    longest_m: tuple[Reach, Reach, Reach] = (0.0, 0.0, 0.0)
    unhurried: tuple[str, ...] = ()
    waving: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Retractions:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    speed_m_s: tuple[Unhurried, Unhurried, Unhurried] = (1.0, 1.0, 1.0)
    variety: Factors = (1.0, 1.0)
    arc_deg: Degrees = 0.0


@dataclass(frozen=True, slots=True)
class Lap:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    longest_gap_s: tuple[Annotated[float, Field(ge=0)], ...] = (0.0, 0.0, 0.0)
    beats: tuple[Share, Share, Share] = (0.0, 0.0, 0.0)
    lift_m: tuple[Metres, Metres, Metres] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Waits:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    belly: tuple[Weight, Weight, Weight] = (1.0, 1.0, 1.0)
    uneven: tuple[Weight, Weight, Weight] = (0.0, 0.0, 0.0)
    one: tuple[Weight, Weight, Weight] = (0.0, 0.0, 0.0)
    hip: tuple[Weight, Weight, Weight] = (0.0, 0.0, 0.0)
    pocket: tuple[Weight, Weight, Weight] = (0.0, 0.0, 0.0)
    forearm: tuple[Weight, Weight, Weight] = (0.0, 0.0, 0.0)
    open: tuple[Weight, Weight, Weight] = (0.0, 0.0, 0.0)

    def only(self, waits: Sequence[Wait]) -> "Waits":
        """Those of a character, or all if it has none of its own; what others never do it does as often as anything."""
        if not waits:
            return self
        given = {wait.value: getattr(self, wait) for wait in waits}
        return Waits(
            **{wait.value: (0.0, 0.0, 0.0) for wait in Wait}
            | {name: weights if any(weights) else (1.0, 1.0, 1.0) for name, weights in given.items()}
        )

    def weights(self, level: int) -> Mapping[Wait, float]:
        """Those with a weight at the level; both hands before the belly if none has."""
        found = {wait: getattr(self, wait)[level] for wait in Wait}
        return {wait: weight for wait, weight in found.items() if weight} or {Wait.BELLY: 1.0}


@dataclass(frozen=True, slots=True)
class Dragging:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    hand_deg: Bend = 0.0
    hand_lag_s: Seconds = 0.0
    fingers_deg: Bend = 0.0
    finger_lag_s: Seconds = 0.0
    life_deg: Bend = 0.0


@dataclass(frozen=True, slots=True)
class Ends:
    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    still_s: Seconds = 0.0
    eased_s: Seconds = 0.0


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
    pelvis_share: Share = 0.0


@dataclass(frozen=True, slots=True)
class LevelVariant:
    """How the hands of a gesture differ from those of medium agitation: metres outwards, up and away from the body, and
    the shape of open hands."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    offset_m: tuple[Aside, Aside, Aside]
    hand: OpenHand | None = None

    def aside(self, offset_m: Sequence[float], hand: OpenHand | None) -> "LevelVariant":
        out, up, away = (own + more for own, more in zip(self.offset_m, offset_m, strict=True))
        return LevelVariant((out, up, away), self.hand or hand)


@dataclass(frozen=True, slots=True)
class LevelVariants:
    """The variants of a gesture that is calm, of one that is agitated, and, for a sex, of one that is neither."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    low: LevelVariant
    high: LevelVariant
    medium: LevelVariant = LevelVariant((0.0, 0.0, 0.0))

    def aside(self, offset_m: Sequence[float], hand: OpenHand | None) -> "LevelVariants":
        """The variants with all hands that far elsewhere, and `hand` where a level has no shape of its own."""
        return LevelVariants(*(each.aside(offset_m, hand) for each in (self.low, self.high, self.medium)))


@dataclass(frozen=True, slots=True)
class SexStyle:
    """How the gestures of a sex differ from those of the neutral body: added to a character's own `space` (a factor),
    `elbow_deg` and `wrist_deg`; where the hands are and the shape of open ones, in gestures that have variants; and, as
    factors, how much of the weight goes to one leg, and how far the ribs bend over it."""

    __pydantic_config__: ClassVar[ConfigDict] = _STRICT
    space: Factor = 1.0
    elbow_deg: Turn = 0.0
    wrist_deg: Turn = 0.0
    offset_m: tuple[Aside, Aside, Aside] = (0.0, 0.0, 0.0)
    hand: OpenHand | None = None
    stance: Factor = 1.0
    ribs: Factor = 1.0

    def manner(self, own: GestureManner) -> GestureManner:
        """A character's own manner, made as its sex does, within the ranges for which bodies were tested."""
        return replace(
            own,
            space=min(max(own.space * self.space, 0.7), 1.3),
            elbow_deg=min(max(own.elbow_deg + self.elbow_deg, -20.0), 30.0),
            wrist_deg=min(max(own.wrist_deg + self.wrist_deg, -20.0), 20.0),
        )


@dataclass(frozen=True, slots=True)
class MovementStyle:
    """The whole file. `idle` has what a body does by itself even without one: it is never quite still."""

    second_hand: SecondHand = SecondHand()
    two_hands: TwoHands = TwoHands()
    holds: Holds = Holds()
    stroke: StrokeLife = StrokeLife()
    idle: IdleLife = IdleLife()
    strokes: Strokes = Strokes()
    retractions: Retractions = Retractions()
    lap: Lap = Lap()
    waits: Waits = Waits()
    dragging: Dragging = Dragging()
    ends: Ends = Ends()
    variants: Mapping[str, LevelVariants] = field(default_factory=dict)
    sexes: Mapping[Sex, SexStyle] = field(default_factory=dict)

    def of(self, figure: Figure) -> "MovementStyle":
        """How the body of this figure moves: as its sex does, with the waits of its own."""
        sex, idle = self.sex(figure), self.idle
        side_deg, twist_deg = idle.ribs_side_deg * sex.ribs, idle.ribs_twist_deg * sex.ribs
        weight = min(idle.stance_weight * sex.stance, 1.0)
        return replace(
            self,
            waits=self.waits.only(figure.waits),
            idle=replace(idle, stance_weight=weight, ribs_side_deg=side_deg, ribs_twist_deg=twist_deg),
            variants={name: each.aside(sex.offset_m, sex.hand) for name, each in self.variants.items()},
        )

    def sex(self, figure: Figure) -> SexStyle:
        """What is usual for the sex of this figure."""
        return self.sexes.get(figure.physique.sex, SexStyle())

    @classmethod
    def load(cls, path: Path, categories: Collection[str] = ()) -> "MovementStyle":
        """The style of a file, for the gestures of these categories, by default any; raises AuthoringError with every
        mistake at its place."""
        source = Source(path)
        file = source.validated(_MovementFile)
        mistakes = [source.mistake(*each) for each in _unknown_gestures(file, categories)] if categories else []
        if mistakes:
            raise AuthoringError(tuple(mistakes))
        return cls(**{each.name: getattr(file, each.name) for each in fields(cls)})


class _MovementFile(Entry):
    second_hand: SecondHand
    two_hands: TwoHands
    holds: Holds
    stroke: StrokeLife
    idle: IdleLife
    strokes: Strokes
    retractions: Retractions
    lap: Lap
    waits: Waits
    dragging: Dragging
    ends: Ends
    variants: dict[str, LevelVariants]
    sexes: dict[Sex, SexStyle]


def _unknown_gestures(file: _MovementFile, categories: Collection[str]) -> Iterator[tuple[tuple[str | int, ...], str]]:
    """The places that name a gesture which is none of these categories, each with what is wrong."""
    named: dict[tuple[str | int, ...], str] = {("variants", name): name for name in file.variants}
    for key in ("unhurried", "waving"):
        named |= {("strokes", key, place): name for place, name in enumerate(getattr(file.strokes, key))}
    for place, name in named.items():
        if name not in categories:
            yield place, f"no gesture is called {name!r}{did_you_mean(name, categories)}"


PLAIN = MovementStyle()
