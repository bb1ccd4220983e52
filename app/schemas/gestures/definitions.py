"""Requests and responses of the gesture editor (Gesture Engine §4.3): gestures as values, their text with its mistakes,
and how one is played. The values are those of `understudy.realizer.gestures.gesture`, in the words of the language."""

from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field

from ...authoring.gesture_texts import CheckedText
from ...errors import InputError, Mistake
from ...model import Hand, Level
from ...realizer.arms.plausibility import Doubt
from ...realizer.gestures.definitions import completed_by_mirroring
from ...realizer.gestures.gesture import (
    ArmKey,
    Bend,
    Definition,
    Depth,
    Expressivity,
    Finger,
    Frame,
    FrameType,
    HandDirection,
    HandForm,
    HandShape,
    HeightSector,
    KeyCurve,
    OffsetTrack,
    SectorPlace,
    Sideways,
    Thumb,
    TrackForm,
    Wrist,
)
from ...realizer.gestures.library import Library
from ...realizer.gestures.writing import write_gesture
from ..requests import checked
from ..response_model import ResponseModel

MOST_GESTURES, MOST_FRAMES, MOST_TRACKS = 400, 100, 21

Triple = tuple[float, float, float]


class Values(BaseModel):
    """Base of models that are both requests and responses."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", allow_inf_nan=False, populate_by_name=True)


class PlaceValues(Values):
    """A sector of gesture space; `offset_m` is outwards, up and away from its centre."""

    x: Sideways
    y: HeightSector
    z: Depth
    offset_m: Triple = (0.0, 0.0, 0.0)

    @classmethod
    def of(cls, place: SectorPlace) -> Self:
        return cls(x=place.sideways, y=place.height, z=place.depth, offset_m=place.offset_m)

    def to_place(self) -> SectorPlace:
        return SectorPlace(self.x, self.y, self.z, self.offset_m)


class HandValues(Values):
    """The hand's form and the thumb's position."""

    form: HandForm
    thumb: Thumb = Thumb.DEFAULT


class WristValues(Values):
    """Sums of directions; an empty one is in line with the forearm."""

    finger_base: tuple[HandDirection, ...] = ()
    palm: tuple[HandDirection, ...] = ()

    @classmethod
    def of(cls, wrist: Wrist) -> Self:
        return cls(finger_base=_in_order(wrist.finger_base), palm=_in_order(wrist.palm))

    def to_wrist(self) -> Wrist:
        return Wrist(frozenset(self.finger_base), frozenset(self.palm))


class ArmValues(Values):
    """What a frame defines for one arm; what is absent is left open. `joints` are degrees about x, y and z."""

    place: PlaceValues | None = None
    hand: HandValues | None = None
    fingers: dict[Finger, Bend] = {}
    wrist: WristValues | None = None
    shoulder: float | None = None
    joints: dict[str, Triple] = {}

    @classmethod
    def of(cls, key: ArmKey) -> Self:
        return cls(
            place=PlaceValues.of(key.place) if key.place else None,
            hand=HandValues(form=key.hand.form, thumb=key.hand.thumb) if key.hand else None,
            fingers=dict(key.fingers),
            wrist=WristValues.of(key.wrist) if key.wrist else None,
            shoulder=key.shoulder,
            joints=dict(key.joints),
        )

    def to_key(self) -> ArmKey:
        return ArmKey(
            place=self.place.to_place() if self.place else None,
            hand=HandShape(self.hand.form, self.hand.thumb) if self.hand else None,
            fingers=tuple(self.fingers.items()),
            wrist=self.wrist.to_wrist() if self.wrist else None,
            shoulder=self.shoulder,
            joints=tuple(self.joints.items()),
        )


class FrameValues(Values):
    """A key pose at a fraction of the gesture; `other` is the other arm if it is not the mirror image."""

    time: float
    type: FrameType
    leading: ArmValues
    other: ArmValues | None = None
    noise: bool = False
    tension: float | None = None
    continuity: float | None = None
    bias: float | None = None

    @classmethod
    def of(cls, frame: Frame) -> Self:
        return cls(
            time=frame.time,
            type=frame.type,
            leading=ArmValues.of(frame.leading),
            other=ArmValues.of(frame.other) if frame.other else None,
            noise=frame.noise,
            **{name: getattr(frame.curve, name) for name in KeyCurve.__slots__},
        )

    def to_frame(self) -> Frame:
        leading, other = self.leading.to_key(), self.other.to_key() if self.other else None
        mirrored = completed_by_mirroring(other, leading) if other else None
        curve = KeyCurve(self.tension, self.continuity, self.bias)
        return Frame(self.time, self.type, leading, mirrored, self.noise, curve)


class ExpressivityValues(Values):
    """How a gesture is performed at one level of agitation."""

    amplitude: float
    tempo: float
    fluidity: float
    power: float
    repetition: float


class TrackValues(Values):
    """A rotation that is added to a joint: its angles in degrees, and for a circling one the number of turns and the
    start angle."""

    form: TrackForm
    joint: Annotated[str, Field(max_length=16)]
    degrees: Triple
    turns: float = 0.0
    phase_deg: float = 0.0


class GestureValues(Values):
    """A whole gesture; `arms` is absent if either hand may make it."""

    gesture_class: Annotated[str, Field(alias="class", max_length=64)]
    name: Annotated[str, Field(max_length=64)]
    duration_s: float
    arms: Hand | None = None
    categories: Annotated[tuple[str, ...], Field(max_length=32)]
    aimed: bool = False
    tracks: Annotated[tuple[TrackValues, ...], Field(max_length=MOST_TRACKS)] = ()
    levels: dict[Level, ExpressivityValues]
    frames: Annotated[tuple[FrameValues, ...], Field(max_length=MOST_FRAMES)]

    @classmethod
    def of(cls, definition: Definition) -> Self:
        return cls(
            gesture_class=definition.gesture_class,
            name=definition.name,
            duration_s=definition.duration_s,
            arms=definition.hand,
            categories=definition.categories,
            aimed=definition.aimed,
            tracks=tuple(TrackValues.model_validate(asdict(track)) for track in definition.tracks),
            levels={level: _expressivity(found) for level, found in definition.levels.items()},
            frames=tuple(map(FrameValues.of, definition.frames)),
        )

    def to_text(self) -> str:
        """The gesture in the language, even if it has mistakes: those are found in the text."""
        return write_gesture(
            Definition(
                gesture_class=_one_line(self.gesture_class),
                name=_one_line(self.name),
                categories=tuple(map(_one_line, self.categories)),
                duration_s=self.duration_s,
                frames=tuple(frame.to_frame() for frame in self.frames),
                levels={
                    level: Expressivity(**self.levels[level].model_dump()) for level in Level if level in self.levels
                },
                hand=self.arms,
                aimed=self.aimed,
                tracks=tuple(
                    OffsetTrack(each.form, _one_line(each.joint), each.degrees, each.turns, each.phase_deg)
                    for each in self.tracks
                ),
            )
        )


class GestureCheckRequest(Values):
    """Gestures as text, as values, or by the name of one in the library; exactly one of the three."""

    text: Annotated[str | None, Field(description="In the language of docs/gesture-language.md.")] = None
    gestures: Annotated[tuple[GestureValues, ...] | None, Field(max_length=MOST_GESTURES)] = None

    library: Annotated[str | None, Field(description="The name of a gesture of the library.")] = None

    def written(self, library: Library) -> str:
        """The text. Raises InputError `value_wrong` if there is not one of the three, `unknown_name`."""
        if [self.text, self.gestures, self.library].count(None) != 2:
            raise InputError("value_wrong", "text: send text, gestures or library, and one alone", field="text")
        if self.library is not None:
            return write_gesture(library.definition(self.library))
        return self.text if self.text is not None else "\n".join(one.to_text() for one in self.gestures or ())


class GestureMotionRequest(Values):
    """A gesture as text, and how to play it."""

    text: str
    name: Annotated[str | None, Field(description="Which gesture of the text; the first if absent.")] = None
    level: Level = Level.MEDIUM
    hand: Annotated[Hand | None, Field(description="The hand it is for, else the right, if absent.")] = None
    character: str = "default"
    fps: Literal[30, 60] = 60


class PlacedMistakeResponse(ResponseModel):
    """A mistake in an authored text; line and column count from 1."""

    file: str | None = None
    line: int
    column: int
    message: str
    source_line: str

    @classmethod
    def of(cls, mistake: Mistake, *, file: str | None = None) -> Self:
        return cls(
            file=file,
            line=mistake.line,
            column=mistake.column,
            message=mistake.message,
            source_line=mistake.source_line,
        )


class DoubtResponse(ResponseModel):
    """A pose that the body cannot take as written; `time` is that of its frame."""

    gesture: str
    time: float
    level: Level
    message: str

    @classmethod
    def of(cls, doubt: Doubt) -> Self:
        return cls(gesture=doubt.definition.name, time=doubt.time, level=doubt.level, message=doubt.message)


class GestureCheckResponse(ResponseModel):
    """The text, and either its mistakes or its gestures as values, with doubts about them."""

    text: str
    gestures: list[GestureValues]
    mistakes: list[PlacedMistakeResponse]
    doubts: list[DoubtResponse]

    @classmethod
    def of(cls, found: CheckedText) -> Self:
        return cls(
            text=found.text,
            gestures=[GestureValues.of(definition) for definition in found.definitions],
            mistakes=[PlacedMistakeResponse.of(mistake) for mistake in found.mistakes],
            doubts=[DoubtResponse.of(doubt) for doubt in found.doubts],
        )


def read_gesture_check(fields: Mapping[str, object]) -> GestureCheckRequest:
    """The validated request. Raises InputError `value_wrong`."""
    return checked(GestureCheckRequest, dict(fields))


def read_gesture_motion(fields: Mapping[str, object]) -> GestureMotionRequest:
    """The validated request. Raises InputError `value_wrong`."""
    return checked(GestureMotionRequest, dict(fields))


def _expressivity(found: Expressivity) -> ExpressivityValues:
    return ExpressivityValues(**{name: getattr(found, name) for name in Expressivity.__slots__})


def _in_order(directions: Iterable[HandDirection]) -> tuple[HandDirection, ...]:
    said = set(directions)
    return tuple(direction for direction in HandDirection if direction in said)


def _one_line(text: str) -> str:
    """The text on one line, so that it cannot begin another line of the gesture's text."""
    return " ".join(text.split())
