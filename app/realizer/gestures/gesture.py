"""Gestures as they are defined (Gesture Engine §4.2): key poses in relative time, said in words, not in angles.

An `ArmKey` says where a hand is and how it is held, as seen from the arm that makes it: `Sideways.C` is before the own
shoulder, `Opp…` on the other side of the body, `INWARDS` towards the body's middle. So the same key serves either arm.
What a key leaves out is interpolated between the keys that say it, each part by itself.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from ...model import Hand, Level


class Sideways(StrEnum):
    """McNeill's seven sectors across the body, from the extreme periphery of the arm's own side to the other's."""

    EP = "XEP"
    P = "XP"
    C = "XC"
    CC = "XCC"
    OPP_C = "XOppC"
    OPP_P = "XOppP"
    OPP_EP = "XOppEP"


class Height(StrEnum):
    """The seven sectors in height; `UPPER_P` is the shoulder's."""

    UPPER_EP = "YUpperEP"
    UPPER_P = "YUpperP"
    UPPER_C = "YUpperC"
    CC = "YCC"
    LOWER_C = "YLowerC"
    LOWER_P = "YLowerP"
    LOWER_EP = "YLowerEP"


class Depth(StrEnum):
    """The three sectors of distance from the body."""

    NEAR = "ZNear"
    MIDDLE = "ZMiddle"
    FAR = "ZFar"


class HandForm(StrEnum):
    """The twelve basic forms of HamNoSys, and the hand at ease."""

    DEFAULT = "form_default"
    FIST = "form_fist"
    FLAT = "form_flat"
    SPREAD = "form_spread"
    INDEX = "symbol_1"
    TWO = "symbol_2"
    TWO_APART = "symbol_2apart"
    PINCH = "symbol_pinch"
    PINCH_ALL = "symbol_pinchall"
    PINCH_OPEN = "symbol_pinchopen"
    CEE = "symbol_cee"
    CEE_ALL = "symbol_ceeall"
    CEE_OPEN = "symbol_ceeopen"


class Thumb(StrEnum):
    """The thumb beside the form; `OPEN` is stretched beside the index finger, `OUT` away from it."""

    DEFAULT = "default"
    OPEN = "open"
    OUT = "out"
    ACROSS = "across"


class Finger(StrEnum):
    THUMB = "thumb"
    INDEX = "index"
    MIDDLE = "middle"
    RING = "ring"
    LITTLE = "little"


class Bend(StrEnum):
    STRAIGHT = "straight"
    CURVED = "bend_curved"
    ANGLED = "bend_angled"
    HOOKED = "bend_hooked"
    CLOSED = "bend_closed"


class Direction(StrEnum):
    """Where the finger base or the palm points, in the body's space, whatever the arm does."""

    UP = "Up"
    DOWN = "Down"
    INWARDS = "Inwards"
    OUTWARDS = "Outwards"
    AWAY = "Away"
    TOWARDS = "Towards"


class FrameType(StrEnum):
    """The phase boundary that a frame stands for: the paper's seven markers (§3.8), and a pose inside a phase."""

    START = "start"
    PREPARATION = "preparation"
    READY = "ready"
    STROKE_START = "stroke_start"
    STROKE = "stroke"
    STROKE_END = "stroke_end"
    HOLD = "hold"
    RELAX = "relax"
    RETRACTION = "retraction"
    END = "end"


@dataclass(frozen=True, slots=True)
class Place:
    """A sector of gesture space, and how far off its middle, in metres: outwards, up, away from the body."""

    sideways: Sideways
    height: Height
    depth: Depth
    offset_m: tuple[float, float, float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class HandShape:
    form: HandForm
    thumb: Thumb = Thumb.DEFAULT


@dataclass(frozen=True, slots=True)
class Wrist:
    """Where the finger base and the palm's normal point: sums of directions, orthogonal to each other. Empty is
    `FBDefault` or `PalmDefault`: as the forearm has it, without twist or bend."""

    finger_base: frozenset[Direction] = frozenset()
    palm: frozenset[Direction] = frozenset()


@dataclass(frozen=True, slots=True)
class ArmKey:
    """What a frame says of one arm; None and () say nothing. `shoulder` raises (1) or lowers (-1) the collarbone,
    `joints` fixes joints (`LowerArm`) by degrees about their x, y and z axes, as the left arm has them."""

    place: Place | None = None
    hand: HandShape | None = None
    fingers: tuple[tuple[Finger, Bend], ...] = ()
    wrist: Wrist | None = None
    shoulder: float | None = None
    joints: tuple[tuple[str, tuple[float, float, float]], ...] = ()


@dataclass(frozen=True, slots=True)
class Frame:
    """A key pose at `time`, in [0, 1] of the gesture. `other` is the other arm's in gestures of both: None there means
    the mirror image of `leading`. `noise` moves the place a little (Perlin), by chance."""

    time: float
    type: FrameType
    leading: ArmKey
    other: ArmKey | None = None
    noise: bool = False


@dataclass(frozen=True, slots=True)
class Expressivity:
    """How a gesture is made: `amplitude` and `tempo` are factors (1 as defined), the others in [0, 1]: `fluidity`
    rounds the path through the keys, `power` stops short and sharp (tension, overshoot), `repetition` adds strokes."""

    amplitude: float = 1.0
    tempo: float = 1.0
    fluidity: float = 0.5
    power: float = 0.5
    repetition: float = 0.0


@dataclass(frozen=True, slots=True)
class Definition:
    """A gesture as a file defines it. `categories` are the BML lexemes it shows; `levels` how it is made at each level
    of agitation for which it is fit; `hand` None is one hand, whichever; `aimed` hands point at the target by IK."""

    gesture_class: str
    name: str
    categories: tuple[str, ...]
    duration_s: float
    frames: tuple[Frame, ...]
    levels: Mapping[Level, Expressivity]
    hand: Hand | None = None
    aimed: bool = False
    path: Path | None = None
    line: int = 1


@dataclass(frozen=True, slots=True)
class Markers:
    """The paper's seven markers in seconds from the start of the clip (§3.8, Table 3)."""

    start: float
    ready: float
    stroke_start: float
    stroke: float
    stroke_end: float
    relax: float
    end: float


@dataclass(frozen=True, slots=True)
class ClipKey:
    """A key pose at `time_s` in the clip; an arm that takes no part is None."""

    time_s: float
    type: FrameType
    left: ArmKey | None
    right: ArmKey | None
    noise: bool = False


@dataclass(frozen=True, slots=True)
class Clip:
    """A gesture ready to be played: a definition at one level of agitation by one hand (or both).

    `stroke_speed_m_s` is the mean speed of the leading hand from `stroke_start` to `stroke_end` (paper §3.8, v).
    """

    name: str
    category: str
    level: Level
    hand: Hand
    markers: Markers
    keys: tuple[ClipKey, ...]
    expressivity: Expressivity
    stroke_speed_m_s: float
    aimed: bool = False
