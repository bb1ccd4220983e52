"""The messages of a live stream (docs/live.md): what a client sends, as checked values; what the service sends, as
JSON.
"""

import json
from collections.abc import Mapping
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from ..errors import InputError, UndecodableError, UnderstudyError, did_you_mean, shown
from ..live.body import BodyFrame
from ..live.messages import LiveMessage, LiveOptions, MouthMessage, PhraseMessage, WithdrawalMessage
from ..live.words import TimedText
from ..model import Behavior, FloatArray, Interval
from ..option_table import PERFORMANCE
from ..realizer.body.motion import SHAPES
from .options import Seed, field_of
from .requests import checked, read_object

DECIMALS = 3
_FULL_SCALE = 32768
_ROTATION_DECIMALS, _WEIGHT_DECIMALS = 5, 4
MOST_WORDS = 2500
LONGEST_NAME = 64
_Seconds = Annotated[float, Field(allow_inf_nan=False, strict=False)]


class _Message(BaseModel):
    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True)


class StartMessage(_Message):
    """Begins a stream. Of two `channels` the second is the voice of whom the character listens to. `motion_model` is
    the name of one whose units the body moves by."""

    type: Literal["start"]
    sample_rate_hz: int = 16_000
    channels: Literal[1, 2] = 1
    character: str = field_of(PERFORMANCE["character"])
    seed: Annotated[Seed, Field(description="Random seed of the movements.")] = 0
    frames: Literal[30, 60] | None = None
    stillness: Annotated[float, Field(ge=0, le=1, strict=False)] = 0.0
    motion_model: Annotated[str, Field(max_length=LONGEST_NAME)] | None = None

    @property
    def options(self) -> LiveOptions:
        return LiveOptions(self.sample_rate_hz, self.character, self.seed, self.frames, self.stillness)


class TimedWord(_Message):
    """A word and when it is spoken, seconds of the stream."""

    text: str
    start_s: _Seconds
    end_s: _Seconds


class WordsMessage(_Message):
    """What the character says: words with times, or plain `text`, for which its voice is waited."""

    type: Literal["words"]
    text: str | None = None
    words: Annotated[tuple[TimedWord, ...], Field(strict=False, max_length=MOST_WORDS)] = ()

    @property
    def timed(self) -> tuple[TimedText, ...]:
        """Raises InputError `value_wrong` for a word that ends before it begins."""
        for each in self.words:
            if each.end_s <= each.start_s:
                message = f"words: {shown(each.text)} ends at {each.end_s:g} s, before it begins"
                raise InputError("value_wrong", message, field="words")
        return tuple(TimedText(each.text, Interval(each.start_s, each.end_s)) for each in self.words)


class SilenceMessage(_Message):
    """Nothing was heard for so long: chunks were lost, or the microphone is off."""

    type: Literal["silence"]
    duration_s: _Seconds


class ListenMessage(_Message):
    """From now on the sound is that of whom the character listens to; `speak` ends that."""

    type: Literal["listen", "speak"]


class CommandMessage(_Message):
    """Ends what goes on, or the stream."""

    type: Literal["interrupt", "end"]


ClientMessage = StartMessage | WordsMessage | SilenceMessage | ListenMessage | CommandMessage
_KINDS: Mapping[str, type[ClientMessage]] = {
    "start": StartMessage,
    "words": WordsMessage,
    "silence": SilenceMessage,
    "listen": ListenMessage,
    "speak": ListenMessage,
    "interrupt": CommandMessage,
    "end": CommandMessage,
}


def read_message(content: bytes) -> ClientMessage:
    """A client's message. Raises UndecodableError `not_json`, InputError `not_an_object`, `value_wrong`."""
    fields = read_object(content, "message")
    kind = fields.get("type")
    if not isinstance(kind, str) or kind not in _KINDS:
        near = did_you_mean(kind, _KINDS) if isinstance(kind, str) else ""
        message = f"type: {shown(kind)}; there are {', '.join(_KINDS)}{near}"
        raise InputError("value_wrong", message, field="type")
    return checked(_KINDS[kind], fields)


def read_samples(content: bytes, channels: int) -> FloatArray:
    """Little-endian 16-bit samples (n, channels) in [-1, 1]. Raises UndecodableError `samples_odd`."""
    if len(content) % (2 * channels):
        message = f"{len(content)} bytes are not a whole number of 16-bit samples of {channels} channels"
        raise UndecodableError("samples_odd", message, field="audio")
    return np.frombuffer(content, dtype="<i2").reshape(-1, channels) / _FULL_SCALE


def to_ready(options: LiveOptions, joints: tuple[str, ...]) -> str:
    """The answer to the start: with frames, the order of their numbers."""
    fields: dict[str, Any] = {"type": "ready", "sample_rate_hz": options.sample_rate_hz, "character": options.character}
    if joints:
        fields |= {"frames": options.frame_rate_hz, "joints": joints, "shapes": SHAPES}
    return json.dumps(fields)


def to_json(message: LiveMessage) -> str:
    """A message of the service: the behaviour's kind is its type (`gesture`, `head`, `face`, `gaze`, `eyes`,
    `posture`), else `withdrawn`, `mouth`, `phrase` of a motion model, `frame`."""
    match message:
        case BodyFrame():
            return _frame(message)
        case MouthMessage(shape=shape, heard_s=heard_s):
            fields = {"start_s": shape.at_s, "viseme": shape.viseme, "articulation": shape.articulation}
            return _json("mouth", heard_s, fields | {"opening": shape.opening})
        case PhraseMessage(phrase=phrase, heard_s=heard_s):
            fields = {"kind": phrase.kind, "start_s": phrase.start_s, "decided": phrase.decided}
            return _json("phrase", heard_s, fields)
        case WithdrawalMessage(id=name, heard_s=heard_s):
            return _json("withdrawn", heard_s, {"id": name})
    fields = _behavior(message.behavior) | ({"revised": True} if message.revised else {})
    return _json(message.behavior.kind.value, message.heard_s, fields)


def to_frames_skipped(count: int) -> str:
    """So many frames are left out before the next, for the client reads too slowly."""
    return json.dumps({"type": "frames_skipped", "count": count})


def to_done(heard_s: float) -> str:
    """The last message of a stream that its client ended."""
    return json.dumps({"type": "done", "duration_s": round(heard_s, DECIMALS)})


def to_error(error: UnderstudyError, *, goes_on: bool = False) -> str:
    """What went wrong; the stream is over unless it `goes_on`."""
    field = error.field if isinstance(error, InputError) else None
    fields = {"type": "error", "code": error.code, "detail": error.message, "goes_on": goes_on}
    return json.dumps(fields | ({"field": field} if field else {}))


def _json(kind: str, heard_s: float, fields: dict[str, Any]) -> str:
    times = {name: round(value, DECIMALS) if name.endswith("_s") else value for name, value in fields.items()}
    return json.dumps({"type": kind, **times, "heard_s": round(heard_s, DECIMALS)})


def _behavior(behavior: Behavior) -> dict[str, Any]:
    sync = dict(behavior.sync.in_order())
    names = ("hand", "amount", "direction", "target", "repetitions", "rule", "function", "reason")
    found = {name: getattr(behavior, name) for name in names}
    words = {"first": behavior.first, "last": behavior.last} if behavior.rule else {}
    begun = {"id": behavior.id, "start_s": behavior.sync.start, "lexeme": behavior.lexeme, "sync": sync}
    return begun | {name: value for name, value in found.items() if value is not None} | words


def _frame(frame: BodyFrame) -> str:
    """Rotations x y z w joint after joint, hips x y z, weights; numbers alone, for there are sixty of them a second."""
    rotations = np.round(frame.rotations.ravel(), _ROTATION_DECIMALS).tolist()
    hips = np.round(frame.hips_m, _WEIGHT_DECIMALS).tolist()
    shapes = np.round(frame.shapes, _WEIGHT_DECIMALS).tolist()
    fields = {"type": "frame", "time_s": round(frame.at_s, 4), "rotations": rotations, "hips_m": hips, "shapes": shapes}
    return json.dumps(fields, separators=(",", ":"))
