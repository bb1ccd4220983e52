"""Converts the schedule of a performance to a BML 1.0 core document: the speech, then the kept behaviours in order of
time.

The speech has a mark before every word, `w0`, `w1`, …, and one after the last. What has no counterpart in BML is in the
speech's description.

That record of a performance has what our realizer needs and the core cannot express. With it, `realize` of our own BML
gives the same result as `perform --realize`, byte for byte. It contains only what the rest of the file does not, so
that somebody who edits the file finds everything in one place: the word times, and for each behaviour its function,
priority, gesture size, reason, and the durations of its phases as scheduled, from which the reader detects points moved
by hand. Times are seconds from the start of the recording, not rounded.
"""

from collections.abc import Iterator, Mapping
from itertools import pairwise
from types import MappingProxyType

from ...model import Behavior, Channel, Hand, Performance, Phone, Target, Word
from ...model.formats import DialectName, TimeForm
from ...model.lead_in import later_s, later_word
from ...model.tables import ACTION_UNITS
from ..markup.documents import Document, Element, Time, Value
from ..markup.elements import BMLT, OURS, RECORD_TYPE
from ..markup.speech import SPEECH, time_formatter, to_milli
from ..markup.values import text_of, written_slots

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


def record(performance: Performance) -> Element:
    """The description with the record."""
    utterance = performance.utterance
    attributes: dict[str, Value] = {
        "agitation": utterance.level.value,
        "stillness": float(performance.stillness),
        "seed": performance.seed,
    }
    if utterance.duration_s is not None:
        attributes["duration"] = later_s(utterance.duration_s, -utterance.lead_in_s)
    content = (
        *(_word(later_word(word, -utterance.lead_in_s)) for word in utterance.words),
        *(_pawn(target) for target in performance.targets),
        *(_behavior(behavior) for behavior in performance.behaviors if behavior.kept),
        *(Element("notice", {"code": each.code, "message": each.message}) for each in performance.notices),
    )
    return Element("description", {"priority": 1, "type": RECORD_TYPE}, (Element("performance", attributes, content),))


def _pawn(target: Target) -> Element:
    place = dict(zip("xyz", target.position_m, strict=True))
    return Element(f"{{{OURS}}}pawn", {"name": target.name, **place})


def _word(word: Word) -> Element:
    return Element("word", dict(_of_word(word)))


def _of_word(word: Word) -> Iterator[tuple[str, Value]]:
    if word.interval:
        yield "start", float(word.interval.start_s)
        yield "end", float(word.interval.end_s)
    measures = (
        ("emphasis", word.emphasis),
        ("focus", word.focus),
        ("prominence", word.prominence),
        ("stressedRatio", word.stressed_ratio),
    )
    yield from ((name, float(measure)) for name, measure in measures if measure is not None)
    if word.spread:
        yield "spread", "true"
    if word.phones:
        yield "phones", " ".join(map(_phone, word.phones))


def _phone(phone: Phone) -> str:
    stress = "" if phone.stress is None else str(phone.stress)
    times = text_of(float(phone.interval.start_s)), text_of(float(phone.interval.end_s))
    return " ".join((f"{phone.label}{stress}", *times))


def _behavior(behavior: Behavior) -> Element:
    return Element("behavior", dict(_of_behavior(behavior)))


def _of_behavior(behavior: Behavior) -> Iterator[tuple[str, Value]]:
    yield "ref", behavior.id
    yield "priority", float(behavior.priority)
    yield "first", behavior.first
    yield "last", behavior.last
    if behavior.kind is Channel.GESTURE:
        if behavior.amount is not None:
            yield "amount", behavior.amount
        if behavior.target is not None:
            yield "target", behavior.target
        if behavior.after_strokes_s is not None:
            yield "afterStrokes", " ".join(map(text_of, behavior.after_strokes_s or (0.0,)))
        if behavior.curved:
            yield "path", "curved"
        if behavior.manner is not None:
            manner = behavior.manner
            yield "manner", " ".join(map(text_of, (manner.amplitude, manner.speed, manner.tension)))
        if behavior.slots is not None:
            yield "slots", written_slots(behavior.slots)
    times_s = [time_s for _name, time_s in behavior.sync.in_order()]
    yield "phases", " ".join(text_of(to_milli(end_s - start_s)) for start_s, end_s in pairwise(times_s))
    why = {"rule": behavior.rule, "function": behavior.function, "moment": behavior.moment, "reason": behavior.reason}
    yield from ((name, value) for name, value in why.items() if value)
