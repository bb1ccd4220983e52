"""Converts the schedule of a performance to a BML 1.0 core document: the speech, then the kept behaviours in order of
time.

The speech has a mark before every word, `w0`, `w1`, …, and one after the last. What has no counterpart in BML is in the
speech's description (`record.py`).
"""

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from ...model import Behavior, Channel, Hand, Performance, Word
from ...model.formats.bml_form import DialectName, TimeForm
from ...model.tables.lexemes import ACTION_UNITS
from ..markup.documents import (
    Document,
    Element,
    Time,
    Value,
)
from ..markup.elements import BMLT
from ..markup.marks import SPEECH, time_formatter, to_milli
from .record import record

GAZE_RANGE_DEGREES = 60.0
"""The offset from its target of a gaze with amount 1."""

MODES: Mapping[Hand, str] = MappingProxyType(
    {Hand.LEFT: "LEFT_HAND", Hand.RIGHT: "RIGHT_HAND", Hand.BOTH: "BOTH_HANDS"}
)
_INFLUENCES: Mapping[str, str] = MappingProxyType({"LOOK": "NECK", "GLANCE": "EYES", "SHIFT": "NECK"})
"""The `influence` of our gaze lexemes; the test suite of the reference realizers uses NECK."""

_SYNC_NAMES: Mapping[str, str] = MappingProxyType({"stroke_start": "strokeStart", "stroke_end": "strokeEnd"})
_FACE_SYNC_NAMES: Mapping[str, str] = MappingProxyType({"ready": "attackPeak"})

Times = Mapping[str, Time]


def to_core(performance: Performance, timing: TimeForm, audio_file: str | None = None) -> Document:
    """A document of one block; times are in seconds, rounded to milliseconds, or relative to the sync marks.

    Without words, as for a listener, there is no speech. An `audio_file` is played by ASAP's own element.
    """
    words, lead_in_s = performance.utterance.words, performance.utterance.lead_in_s
    timed = time_formatter(words, timing, mark="w{}".format, speech_start_s=lead_in_s)
    behaviors = (_element(each, timed(each.sync)) for each in performance.behaviors if each.kept)
    speech = (_speech(performance), *_recording(audio_file, lead_in_s)) if words else ()
    attributes: dict[str, Value] = {"id": "bml1", "characterId": performance.character}
    return Document(DialectName.BML, Element("bml", attributes, (*speech, *behaviors)))


def _speech(performance: Performance) -> Element:
    text = Element("text", content=tuple(_marked(performance.utterance.words)))
    start_s = to_milli(performance.utterance.lead_in_s)
    return Element("speech", {"id": SPEECH, "start": start_s}, (text, record(performance)))


def _recording(audio_file: str | None, start_s: float) -> Iterator[Element]:
    if audio_file:
        yield Element(f"{{{BMLT}}}audiofile", {"id": "audio1", "fileName": audio_file, "start": to_milli(start_s)})


def _marked(words: tuple[Word, ...]) -> Iterator[Element | str]:
    for number, word in enumerate(words):
        yield Element("sync", {"id": f"w{number}"})
        yield f"{word.text} "
    yield Element("sync", {"id": f"w{len(words)}"})


def _element(behavior: Behavior, times: Times) -> Element:
    match behavior.kind:
        case Channel.GESTURE:
            return _gesture(behavior, times)
        case Channel.HEAD:
            return _head(behavior, times)
        case Channel.GAZE:
            return _gaze(behavior, times)
        case Channel.FACE | Channel.EYES:
            return _face(behavior, times)
        case Channel.POSTURE:
            return _posture(behavior, times)


def _gesture(behavior: Behavior, times: Times) -> Element:
    mode = {"mode": MODES[behavior.hand]} if behavior.hand else {}
    return Element("gesture", {**_named(behavior), **mode, **_spelt(times, _SYNC_NAMES)})


def _head(behavior: Behavior, times: Times) -> Element:
    repetition = {"repetition": behavior.repetitions} if behavior.repetitions is not None else {}
    return Element("head", {**_named(behavior), **repetition, **_amount(behavior), **_spelt(times, _SYNC_NAMES)})


def _gaze(behavior: Behavior, times: Times) -> Element:
    """A `gaze`, which returns from its target, or a `gazeShift`, which has only a start and an end."""
    attributes: dict[str, Value] = {"id": behavior.id, "target": behavior.target or ""}
    attributes["influence"] = _INFLUENCES[behavior.lexeme]
    if behavior.direction is not None and behavior.amount is not None:
        attributes["offsetAngle"] = to_milli(behavior.amount * GAZE_RANGE_DEGREES)
        attributes["offsetDirection"] = behavior.direction
    if behavior.lexeme == "SHIFT":
        return Element("gazeShift", {**attributes, **_ends(times)})
    return Element("gaze", {**attributes, **times})


def _face(behavior: Behavior, times: Times) -> Element:
    spelt = _spelt(times, _FACE_SYNC_NAMES)
    if behavior.lexeme in ACTION_UNITS:
        unit: dict[str, Value] = {"id": behavior.id, "au": ACTION_UNITS[behavior.lexeme], "side": "BOTH"}
        return Element("faceFacs", {**unit, **_amount(behavior), **spelt})
    return Element("faceLexeme", {**_named(behavior), **_amount(behavior), **spelt})


def _posture(behavior: Behavior, times: Times) -> Element:
    """A `postureShift`, which lasts, or a `posture`, which returns to the previous one."""
    stance = Element("stance", {"type": "STANDING"})
    pose = Element("pose", {"part": "WHOLEBODY", "lexeme": behavior.lexeme})
    if behavior.sync.relax is not None and behavior.sync.relax < behavior.sync.end:
        return Element("posture", {"id": behavior.id, **times}, (stance, pose))
    return Element("postureShift", {"id": behavior.id, **_ends(times)}, (stance, pose))


def _named(behavior: Behavior) -> dict[str, Value]:
    return {"id": behavior.id, "lexeme": behavior.lexeme}


def _amount(behavior: Behavior) -> dict[str, Value]:
    return {} if behavior.amount is None else {"amount": to_milli(behavior.amount)}


def _spelt(times: Times, names: Mapping[str, str]) -> Times:
    return {names.get(name, name): time for name, time in times.items()}


def _ends(times: Times) -> Times:
    return {"start": times["start"], "end": times["end"]}
