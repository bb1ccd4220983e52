"""A performance as the page plays it: the motion as a clip, the recording as FLAC, and a body of each character.

A clip must not reveal its condition, so names, reasons and decisions are stripped from the motion, and tags from the
recording.
"""

import io
import json

import soundfile

from ...errors import UndecodableError
from ...library.motion import PreparedSchedule, RealizedSchedule, realize_prepared, write_realized
from ...model import Schedule
from ...model.formats import MotionFormat
from ...models import Understudy

FRAME_RATE_HZ = 30
"""The page goes evenly from one frame to the next."""

TAIL_S = 1.0
"""Motion after the recording, in which hands come to rest."""

_TELLING = ("events", "decisions", "notices")


def realized(models: Understudy, prepared: PreparedSchedule) -> RealizedSchedule:
    """The motion of a schedule, with its tail."""
    return realize_prepared(models.realizer, prepared, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S)


def blind_clip(models: Understudy, found: RealizedSchedule) -> str:
    """The motion as JSON (docs/motion-formats.md), without anything that reveals its condition."""
    clip = json.loads(write_realized(found, models.realizer, MotionFormat.JSON))
    return json.dumps(clip | {name: [] for name in _TELLING}, separators=(",", ":"))


def body_of(models: Understudy, character: str) -> bytes:
    """The mannequin of a character, at rest, as GLB."""
    still = PreparedSchedule(Schedule((), duration_s=1 / FRAME_RATE_HZ, character=character, stillness=1.0), ())
    standing = realize_prepared(models.realizer, still, frame_rate_hz=FRAME_RATE_HZ)
    return write_realized(standing, models.realizer, MotionFormat.GLB)


def blind_sound(audio: bytes) -> bytes:
    """The recording as FLAC; raises UndecodableError `audio_undecodable`."""
    try:
        samples, rate_hz = soundfile.read(io.BytesIO(audio), dtype="float32", always_2d=True)
    except soundfile.LibsndfileError as error:
        raise UndecodableError("audio_undecodable", f"cannot be read as sound: {error}", field="audio") from None
    content = io.BytesIO()
    soundfile.write(content, samples, rate_hz, format="FLAC", subtype="PCM_16")
    return content.getvalue()
