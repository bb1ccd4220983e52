"""The data of gesture planning: requests, the clips chosen for them, and what each arm does over time.

Conventions: seconds from the start of the audio; markers of placed gestures are absolute. An arm is `Hand.LEFT` or
`Hand.RIGHT`; a two-handed gesture is on both arms with the same stroke, but preparation and retraction may differ. What
chance decides of a gesture depends on the seed and on the gesture alone (`drawn`), so that editing one leaves the
others as they were.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from zlib import crc32

import numpy as np

from ...model import Hand, Level, Manner, SyncPoints
from ...model.limits import playable_size
from ...model.schedule import Way
from ...model.slots import Slots
from ..body.motion import Decision
from ..body.movement_style import PLAIN, MovementStyle
from ..geometry.chance import generator_of
from .gesture import Clip, Markers

Position = tuple[float, float, float]

USUAL_MANNER = Manner()


@dataclass(frozen=True, slots=True)
class AskedTimes:
    """When the way to a gesture is to begin and to be over, how long its stroke is to take, and when its hold and the
    way to rest are to end; None leaves it to the clip."""

    start_s: float | None = None
    ready_s: float | None = None
    stroke_s: float | None = None
    relax_s: float | None = None
    end_s: float | None = None


NOTHING_ASKED = AskedTimes()


@dataclass(frozen=True, slots=True)
class GestureRequest:
    """A gesture of the schedule: category, desired stroke and relax time, priority (paper §3.8, eq. 4), and what our
    BML adds: hand, level of agitation, size (1 as defined), the name of a target, the longest that its stroke may take,
    where it says that, and the ends of further strokes, seconds after that of the main one (None: as the emphases of
    the speech have it). A still body makes the whole gesture smaller by the factor `scale`; the stroke of one
    that is `curved` is an arc. `manner` is how the voice at the stroke has it made, `slots` what its words say of size,
    number and place, `way` the sectors from and to which its stroke leads. `asked` has times beside the
    stroke's that are to be met."""

    behavior: str
    category: str
    stroke_s: float
    relax_s: float
    priority: float
    hand: Hand = Hand.RIGHT
    level: Level = Level.MEDIUM
    size: float = 1.0
    target: str | None = None
    longest_stroke_s: float = inf
    after_strokes_s: tuple[float, ...] | None = None
    scale: float = 1.0
    curved: bool = False
    manner: Manner = USUAL_MANNER
    slots: Slots | None = None
    way: Way | None = None
    asked: AskedTimes = NOTHING_ASKED


@dataclass(frozen=True, slots=True)
class Repeat:
    """A partial repetition of the stroke (Gesture Engine §5.1): back from `start_s`, and forth until `end_s`, which is
    on an emphasis; `amplitude` is a share of the first stroke's. One with `way_m` goes that far back towards hanging
    instead, one that `swings` to where the hand turned back last, and with it the hand."""

    start_s: float
    end_s: float
    amplitude: float
    way_m: float | None = None
    swings: bool = False


@dataclass(frozen=True, slots=True)
class PlacedGesture:
    """A clip A_i for a request G_i, its stroke at the desired time; `relax_s` is the earliest end of its hold. `aim_m`
    is the world position that it points at; None plays it as defined; poses before `aimed_from_s` of the clip are as
    defined. `share` is how far of the way from the rest pose `basis` the hand goes: less than 1 in a hand that only
    follows the other. Where the hand does not lead, its fingers from index to little are bent by `bends_deg` more."""

    request: GestureRequest
    clip: Clip
    relax_s: float
    repeats: tuple[Repeat, ...] = ()
    aim_m: Position | None = None
    aimed_from_s: float = -inf
    share: float = 1.0
    basis: str = "at_side"
    bends_deg: tuple[float, ...] = ()

    @property
    def follows(self) -> bool:
        """Whether it is what the other hand makes of a gesture of one hand."""
        return self.share < 1.0

    @property
    def placed_by_words(self) -> bool:
        """Whether its words or its script say where its hands are, which is not changed."""
        return bool(self.request.slots or self.request.way or self.clip.aimed)

    @property
    def offset_s(self) -> float:
        """The absolute time of the clip's own time 0."""
        return self.request.stroke_s - self.clip.markers.stroke

    @property
    def stroke_start_s(self) -> float:
        """The absolute time of the stroke's start."""
        return self.offset_s + self.clip.markers.stroke_start

    @property
    def stroke_end_s(self) -> float:
        """The absolute time of the stroke's end."""
        return self.offset_s + self.clip.markers.stroke_end

    @property
    def size(self) -> float:
        """The requested size, reduced where the stroke would be too fast, and then scaled: if all gestures are scaled
        alike, none needs more time to come from another than it did (`understudy.model.limits`)."""
        return self.request.scale * playable_size(self.request.size, self.clip.stroke_speed_m_s)

    @property
    def arms(self) -> tuple[Hand, ...]:
        """The arms that take part."""
        return arms_of(self.clip.hand)


@dataclass(frozen=True, slots=True)
class ArmGesture:
    """A placed gesture as played by one arm. `blended_from` and `blended_to` are the gestures that the arm comes from
    and goes to without rest; None is from or to rest. `initial_progress` is the share of the way to the stroke start
    that the arm has already covered in the first frame, when the first stroke of a line leaves no time for it. `beats`
    fill a long hold."""

    side: Hand
    placed: PlacedGesture
    markers: Markers
    blended_from: str | None = None
    blended_to: str | None = None
    initial_progress: float = 0.0
    beats: tuple[Repeat, ...] = ()

    @property
    def behavior(self) -> str:
        """The BML id of the gesture."""
        return self.placed.request.behavior


@dataclass(frozen=True, slots=True)
class ArmRest:
    """An arm at rest in a pose, from arrival to departure, with small `beats` on stressed words."""

    side: Hand
    pose: str
    start_s: float
    end_s: float
    beats: tuple[Repeat, ...] = ()


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
class GestureUnit:
    """A gesture unit: gestures without rest between them, from the first preparation to the end of the last
    retraction."""

    behaviors: tuple[str, ...]
    start_s: float
    end_s: float


@dataclass(frozen=True, slots=True)
class GesturePlan:
    """What the arms do from the first frame to `end_s`, when both are at rest; gestures and rests are in order of time.
    `following` are those that an arm makes because the other one gestures, `style` is how lively they all are.
    `realized` has the sync points of every gesture that is played, by BML id; `decisions` explain those that are not
    played as requested."""

    gestures: tuple[ArmGesture, ...]
    rests: tuple[ArmRest, ...]
    transitions: tuple[Transition, ...]
    units: tuple[GestureUnit, ...]
    decisions: tuple[Decision, ...]
    realized: Mapping[str, SyncPoints]
    end_s: float
    following: tuple[ArmGesture, ...] = ()
    style: MovementStyle = PLAIN

    def of_arm(self, side: Hand) -> tuple[tuple[ArmGesture, ...], tuple[ArmRest, ...]]:
        """The gestures of one arm, with those in which it follows, and its rests."""
        made = (each for each in (*self.gestures, *self.following) if each.side is side)
        gestures = tuple(sorted(made, key=lambda each: each.markers.stroke_start))
        return gestures, tuple(each for each in self.rests if each.side is side)


def arms_of(hand: Hand) -> tuple[Hand, ...]:
    """The arms that a hand of the schedule refers to."""
    return (Hand.LEFT, Hand.RIGHT) if hand is Hand.BOTH else (hand,)


def drawn(seed: int, gesture: PlacedGesture, what: int = 0) -> np.random.Generator:
    """The generator of a gesture; `what` is drawn, where more than one thing is."""
    asked = gesture.request
    named = f"{asked.behavior} {asked.category} {asked.stroke_s:.3f}"
    return generator_of(seed, crc32(named.encode()), *([what] if what else []))
