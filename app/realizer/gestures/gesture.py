"""The gesture model (Gesture Engine §4.2): key poses at relative times, described symbolically instead of by angles.

An `ArmKey` gives position, orientation and shape of a hand relative to its own arm: `Sideways.C` is in front of the own
shoulder, `Opp…` on the other side of the body, `INWARDS` towards the body's middle. So the same key serves either arm.
Parts that a key leaves open are interpolated between keys that define them.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from ...model import Hand, Level
from ...model.figure import PLAIN_MANNER, GestureManner


class Sideways(StrEnum):
    """McNeill's seven sectors across the body, from the extreme periphery on the arm's own side to that on the
    other."""

    EP = "XEP"
    P = "XP"
    C = "XC"
    CC = "XCC"
    OPP_C = "XOppC"
    OPP_P = "XOppP"
    OPP_EP = "XOppEP"


class HeightSector(StrEnum):
    """The seven sectors in height; `UPPER_P` is at the shoulders."""

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
    """The twelve basic hand forms of HamNoSys, and the relaxed hand."""

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
    """The thumb's position; `OPEN` is stretched beside the index finger, `OUT` away from it."""

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


class HandDirection(StrEnum):
    """A direction of the finger base or the palm, in the body's space, independent of the arm's pose."""

    UP = "Up"
    DOWN = "Down"
    INWARDS = "Inwards"
    OUTWARDS = "Outwards"
    AWAY = "Away"
    TOWARDS = "Towards"


class FrameType(StrEnum):
    """The phase boundary that a frame marks: one of the paper's seven markers (§3.8), or a pose within a phase."""

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
class SectorPlace:
    """A sector of gesture space, and an offset from its centre in metres: outwards, up, away from the body."""

    sideways: Sideways
    height: HeightSector
    depth: Depth
    offset_m: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def offset_by(self, offset_m: tuple[float, float, float]) -> "SectorPlace":
        """The place that far from the sector's centre."""
        return SectorPlace(self.sideways, self.height, self.depth, offset_m)


@dataclass(frozen=True, slots=True)
class HandShape:
    form: HandForm
    thumb: Thumb = Thumb.DEFAULT


@dataclass(frozen=True, slots=True)
class Wrist:
    """The directions of the finger base and the palm's normal: sums of directions, orthogonal to each other. Empty
    means `FBDefault` or `PalmDefault`: in line with the forearm, without twist or bend."""

    finger_base: frozenset[HandDirection] = frozenset()
    palm: frozenset[HandDirection] = frozenset()


@dataclass(frozen=True, slots=True)
class ArmKey:
    """What a frame defines for one arm; None and () leave a part open. `shoulder` raises (1) or lowers (-1) the
    collarbone, `joints` sets joints (`LowerArm`) by degrees about their x, y and z axes, as for the left arm.
    `elbow_deg` is how far the elbow is out, about the line from shoulder to wrist, where a gesture script asks for it;
    otherwise it is where the wrist is at ease."""

    place: SectorPlace | None = None
    hand: HandShape | None = None
    fingers: tuple[tuple[Finger, Bend], ...] = ()
    wrist: Wrist | None = None
    shoulder: float | None = None
    joints: tuple[tuple[str, tuple[float, float, float]], ...] = ()
    elbow_deg: float | None = None

    def at(self, place: SectorPlace) -> "ArmKey":
        """The same elsewhere: in a third of the time of `dataclasses.replace`, and clips have hundreds of them."""
        return ArmKey(place, self.hand, self.fingers, self.wrist, self.shoulder, self.joints, self.elbow_deg)


@dataclass(frozen=True, slots=True)
class KeyCurve:
    """How the path runs through a key (Gesture Engine §5.2; Kochanek & Bartels 1984), each in [-1, 1]; None leaves it
    to the gesture's expressivity. Positive `tension` slows down at the key, negative speeds up; `continuity` other than
    0 makes a corner; positive `bias` overshoots the key, negative turns to the next one before it."""

    tension: float | None = None
    continuity: float | None = None
    bias: float | None = None


@dataclass(frozen=True, slots=True)
class Frame:
    """A key pose at `time` in [0, 1] of the gesture. `other` is the other arm in two-handed gestures: None means the
    mirror image of `leading`. `noise` adds Perlin noise at this key."""

    time: float
    type: FrameType
    leading: ArmKey
    other: ArmKey | None = None
    noise: bool = False
    curve: KeyCurve = KeyCurve()


@dataclass(frozen=True, slots=True)
class Expressivity:
    """How a gesture is performed: `amplitude` and `tempo` are factors (1 as defined), the rest is in [0, 1]: `fluidity`
    smooths the path through the keys, `power` makes it stop sharply (tension, overshoot), `repetition` adds strokes."""

    amplitude: float = 1.0
    tempo: float = 1.0
    fluidity: float = 0.5
    power: float = 0.5
    repetition: float = 0.0


class TrackForm(StrEnum):
    """How an offset track goes: up to the stroke's end and back with the retraction; there and back within the stroke,
    which curves its path; round and round in the stroke."""

    HELD = "held"
    CURVED = "curved"
    CIRCLING = "circling"


@dataclass(frozen=True, slots=True)
class OffsetTrack:
    """A rotation that is added to what the key poses make of a joint (NGS §3.4), in degrees about the joint's axes as
    for a left arm; at most `degrees`. One that circles goes round `turns` times, and begins at the angle `phase_deg` of
    its sine."""

    form: TrackForm
    joint: str
    degrees: tuple[float, float, float]
    turns: float = 0.0
    phase_deg: float = 0.0


@dataclass(frozen=True, slots=True)
class Definition:
    """A gesture as defined in a file. `categories` are the BML lexemes that it shows; `levels` its expressivity at each
    level of agitation that it suits; `hand` None is either hand alone; `aimed` hands point at the target by inverse
    kinematics. `tracks` are added to what the frames make. `manner` is that of the character whose gesture it is. The
    stroke of one that `waves` may swing to and fro."""

    gesture_class: str
    name: str
    categories: tuple[str, ...]
    duration_s: float
    frames: tuple[Frame, ...]
    levels: Mapping[Level, Expressivity]
    hand: Hand | None = None
    aimed: bool = False
    tracks: tuple[OffsetTrack, ...] = ()
    path: Path | None = None
    line: int = 1
    manner: GestureManner = PLAIN_MANNER
    waves: bool = False

    @property
    def at_the_body(self) -> bool:
        """Whether it grows in no agitation, as those do whose place is a part of the body."""
        calm, agitated = self.levels.get(Level.MEDIUM), self.levels.get(Level.HIGH)
        return calm is not None and agitated is not None and agitated.amplitude <= calm.amplitude


@dataclass(frozen=True, slots=True)
class Markers:
    """The paper's seven markers (§3.8, Table 3) in seconds: from the clip's start, or absolute in a plan."""

    start: float
    ready: float
    stroke_start: float
    stroke: float
    stroke_end: float
    relax: float
    end: float


@dataclass(frozen=True, slots=True)
class ClipKey:
    """A key pose at `time_s` in the clip; None for an arm that takes no part."""

    time_s: float
    type: FrameType
    left: ArmKey | None
    right: ArmKey | None
    noise: bool = False
    curve: KeyCurve = KeyCurve()

    def at(self, time_s: float) -> "ClipKey":
        """The same at another time."""
        return ClipKey(time_s, self.type, self.left, self.right, self.noise, self.curve)

    def of(self, left: ArmKey | None, right: ArmKey | None) -> "ClipKey":
        """The same of other arms."""
        return ClipKey(self.time_s, self.type, left, right, self.noise, self.curve)


@dataclass(frozen=True, slots=True)
class Clip:
    """A playable gesture: a definition at one level of agitation, made by one hand or both.

    `stroke_speed_m_s` is the mean speed of the leading hand from `stroke_start` to `stroke_end` (paper §3.8, v). Space
    and pace of the `manner` are in `expressivity` and in the times already. The stroke of one that `waves` swings to
    and fro. One `at_the_body` is as big in any voice: its stroke ends at the chest, the temple, the mouth.
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
    tracks: tuple[OffsetTrack, ...] = ()
    manner: GestureManner = PLAIN_MANNER
    waves: bool = False
    at_the_body: bool = False
