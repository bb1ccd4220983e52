"""The values of gesture planning: what is asked for, which clip plays when, and what each arm does with its time.

Conventions: seconds from the start of the audio; markers of placed gestures are absolute. An arm is `Hand.LEFT` or
`Hand.RIGHT`; a two-handed gesture is on both arms, with the same stroke, but its phases before and after may differ.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from ...model import Hand, Level, SyncPoints
from ..body.motion import Decision
from .gesture import Clip, Markers

Position = tuple[float, float, float]

TOP_STROKE_SPEED_M_S = 1.0
"""The fastest mean speed of a stroke: it peaks at about 1.9 times that, where people's 95th percentile is."""


@dataclass(frozen=True, slots=True)
class Request:
    """A gesture as the schedule asks for it: category, desired stroke and relax time, priority (paper §3.8, eq. 4),
    and the hand, the level of agitation, the size (1 as defined) and the name of a target that our BML adds."""

    behavior: str
    category: str
    stroke_s: float
    relax_s: float
    priority: float
    hand: Hand = Hand.RIGHT
    level: Level = Level.MEDIUM
    size: float = 1.0
    target: str | None = None


@dataclass(frozen=True, slots=True)
class Repeat:
    """A partial repetition of the stroke (Gesture Engine §5.1): back from `start_s`, forth until `end_s`, on an
    emphasis; `amplitude` is in parts of the first stroke."""

    start_s: float
    end_s: float
    amplitude: float


@dataclass(frozen=True, slots=True)
class Placed:
    """A clip A_i for a request G_i, its stroke on the desired time; `relax_s` is when its hold ends at the earliest.
    `aim_m` is the place in the world that it points at; None where it is played as defined."""

    request: Request
    clip: Clip
    relax_s: float
    repeats: tuple[Repeat, ...] = ()
    aim_m: Position | None = None

    @property
    def offset_s(self) -> float:
        """When the clip's own time 0 falls."""
        return self.request.stroke_s - self.clip.markers.stroke

    @property
    def stroke_start_s(self) -> float:
        return self.offset_s + self.clip.markers.stroke_start

    @property
    def stroke_end_s(self) -> float:
        return self.offset_s + self.clip.markers.stroke_end

    @property
    def size(self) -> float:
        """How large the gesture is made: as it is asked for, but its stroke, which takes its own time, no faster than
        `TOP_STROKE_SPEED_M_S`."""
        fastest_m_s = max(self.request.size * self.clip.stroke_speed_m_s, TOP_STROKE_SPEED_M_S)
        return self.request.size * TOP_STROKE_SPEED_M_S / fastest_m_s

    @property
    def arms(self) -> tuple[Hand, ...]:
        return arms_of(self.clip.hand)


@dataclass(frozen=True, slots=True)
class ArmGesture:
    """A placed gesture as one arm plays it. `blended_from` and `blended_to` are the gestures that this arm comes from
    and goes to without rest; where they are None it comes from rest and goes back. `underway` is how much of the way to
    the stroke start lies behind the arm in the first frame, on a line whose first stroke leaves no time for it."""

    side: Hand
    placed: Placed
    markers: Markers
    blended_from: str | None = None
    blended_to: str | None = None
    underway: float = 0.0

    @property
    def behavior(self) -> str:
        return self.placed.request.behavior


@dataclass(frozen=True, slots=True)
class ArmRest:
    """An arm at rest in a pose, from when it has arrived until it leaves."""

    side: Hand
    pose: str
    start_s: float
    end_s: float


@dataclass(frozen=True, slots=True)
class Transition:
    """The blend of an arm from the relax time of one gesture to the stroke start of the next (paper §3.8)."""

    side: Hand
    first: str
    second: str
    start_s: float
    end_s: float
    speed_m_s: float


@dataclass(frozen=True, slots=True)
class Unit:
    """A gesture unit: gestures that flow together, from the first preparation to the end of the last retraction."""

    behaviors: tuple[str, ...]
    start_s: float
    end_s: float


@dataclass(frozen=True, slots=True)
class GesturePlan:
    """What the arms do from the first frame to `end_s`, when the last of them is at rest; gestures and rests are in
    order of time. `realized` has the sync points of every gesture that is played, by BML id, and `decisions` what
    became of every one that is not played as asked for."""

    gestures: tuple[ArmGesture, ...]
    rests: tuple[ArmRest, ...]
    transitions: tuple[Transition, ...]
    units: tuple[Unit, ...]
    decisions: tuple[Decision, ...]
    realized: Mapping[str, SyncPoints]
    end_s: float

    def of_arm(self, side: Hand) -> tuple[tuple[ArmGesture, ...], tuple[ArmRest, ...]]:
        """The gestures and rests of one arm."""
        gestures = tuple(each for each in self.gestures if each.side is side)
        return gestures, tuple(each for each in self.rests if each.side is side)


def arms_of(hand: Hand) -> tuple[Hand, ...]:
    """The arms that a hand stands for."""
    return (Hand.LEFT, Hand.RIGHT) if hand is Hand.BOTH else (hand,)
