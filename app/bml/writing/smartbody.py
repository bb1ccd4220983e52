"""Converts the schedule of a performance to an act of SmartBody (docs/references.md).

SmartBody has a smaller vocabulary. Gestures are written as the nearest in its shipped gesture map (`smartbody_tables`),
head movements as the nearest of three (`HEADS`). Faces are action units, as are blinks; a gaze lasts until the next, so
one that returns becomes two, and gazes at targets that the scene is not known to have are left out; a posture is the
name of one of the character's own. Gestures have only `stroke` and `relax`, since its scheduler accepts no others
together. The visemes are in the file beside the recording (`speech_file`): lips in the act are ignored.

The speech is an element in the act, and a file beside the audio: SmartBody finds a recording by `ref`, the name of its
files without extension: NAME.wav is played, and NAME.bml beside it has the word times (`sync`) and visemes (`lips`);
without visemes there it refuses the speech. It copies the element as text without escaping it, so that `&`, `<` and `>`
in it cut it off.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

from ...model import Behavior, Channel, Level, Notice, Performance, Viseme, Word
from ...model.formats import DialectName, TimeForm
from ...model.tables import ACTION_UNITS, SILENCE
from ...model.targets import LISTENER
from ..markup.documents import (
    Document,
    Element,
    Time,
    Value,
)
from ..markup.elements import SBM
from ..markup.speech import SPEECH, time_formatter, to_milli
from .blocks import GAZE_RANGE_DEGREES, MODES
from .smartbody_tables import GestureName, SmartBodyMouthShape, SmartBodyTables

UNSAFE = "&<>"
"""The characters on which SmartBody's second reading of the speech fails."""

_WITHOUT_UNSAFE = str.maketrans(dict.fromkeys(UNSAFE))
_WITH_MARKS = "application/ssml+xml"
"""The type of a speech whose `mark` elements are sync points."""


def safe(text: str) -> str:
    """The text without the characters on which SmartBody fails."""
    return text.translate(_WITHOUT_UNSAFE)


def first_mark(word_index: int) -> str:
    """The id of the mark before a word; the mark after it has the next number."""
    return f"T{2 * word_index}"


def speech_element(performance: Performance, timing: TimeForm, ref: str | None) -> Element:
    """The speech in the act. Only marks directly inside it are sync points for other behaviours."""
    start_s = performance.utterance.lead_in_s
    named: dict[str, Value] = {"id": SPEECH, **({"ref": ref} if ref else {})}
    begun = {"start": to_milli(start_s)}
    marked = tuple(_marked(performance.utterance.words, start_s, timing))
    if timing is TimeForm.SYNC:
        return Element("speech", {**named, "type": _WITH_MARKS, **begun}, marked)
    return Element("speech", {**named, **begun}, (Element("text", content=marked),))


def speech_file(performance: Performance, shapes: Mapping[str, SmartBodyMouthShape]) -> Document:
    """The file beside the recording, in seconds of the recording. If the mouth never moves, a closed one is written,
    because SmartBody requires a viseme."""
    lead_in_s = performance.utterance.lead_in_s
    text = Element("text", content=tuple(_marked(performance.utterance.words, lead_in_s, TimeForm.ABSOLUTE)))
    shown = [shape for shape in performance.visemes if shape.label != SILENCE]
    lips = [_lips(shape, shapes[shape.label], lead_in_s) for shape in shown]
    content = (Element("speech", {"id": SPEECH}, (text,)), *(lips or [_shut(next(iter(shapes.values())))]))
    return Document(DialectName.SMARTBODY, Element("bml", content=content))


def _marked(words: tuple[Word, ...], start_s: float, timing: TimeForm) -> Iterator[Element | str]:
    """Every timed word between marks at its start and its end, in seconds from the start of the speech."""
    kind, naming = ("mark", "name") if timing is TimeForm.SYNC else ("sync", "id")
    for word in words:
        if word.interval is None:
            yield f"{safe(word.text)} "
            continue
        yield Element(kind, {naming: first_mark(word.index), "time": to_milli(word.interval.start_s - start_s)})
        yield f"{safe(word.text)} "
        end_s = to_milli(word.interval.end_s - start_s)
        yield Element(kind, {naming: f"T{2 * word.index + 1}", "time": end_s})


def _lips(viseme: Viseme, shape: SmartBodyMouthShape, lead_in_s: float) -> Element:
    """A viseme rises over its first quarter and decays over its last."""
    start_s, end_s = viseme.interval.start_s - lead_in_s, viseme.interval.end_s - lead_in_s
    quarter_s = viseme.interval.duration_s / 4
    syncs = {"start": start_s, "ready": start_s + quarter_s, "relax": end_s - quarter_s, "end": end_s}
    times = {name: to_milli(time_s) for name, time_s in syncs.items()}
    return Element("lips", {"viseme": shape.name, "articulation": to_milli(viseme.articulation * shape.share), **times})


def _shut(shape: SmartBodyMouthShape) -> Element:
    times = {"start": 0.0, "ready": 0.0, "relax": 0.1, "end": 0.1}
    return Element("lips", {"viseme": shape.name, "articulation": 0.0, **times})


HEADS: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys(("RAISE", "LOWER", "TILT_LEFT_NOD", "TILT_RIGHT_NOD"), "NOD"),
        **dict.fromkeys(("SWAY", "TURN_LEFT", "TURN_RIGHT"), "SHAKE"),
        **dict.fromkeys(("TILT_LEFT", "TILT_RIGHT"), "TOSS"),
    }
)
"""Our head lexemes and the nearest of SmartBody's three types."""

UNITS_OF_LEXEMES: Mapping[str, tuple[int, ...]] = MappingProxyType(
    {
        "OBLIQUE_BROWS": (1, 4),
        "RAISE_BROWS": (1, 2),
        "LOWER_BROWS": (4,),
        "LOWER_MOUTH_CORNERS": (15,),
        "RAISE_MOUTH_CORNERS": (12,),
        "OPEN_MOUTH": (26,),
        "OPEN_LIPS": (25,),
        "WIDEN_EYES": (5,),
        "CLOSE_EYES": (43,),
    }
)
"""The action units of the core's face lexemes; one-sided lexemes have the same with LEFT or RIGHT in the name."""

_STYLES: Mapping[Level, str] = MappingProxyType({Level.LOW: "low", Level.MEDIUM: "mid", Level.HIGH: "high"})
_JOINTS: Mapping[str, str] = MappingProxyType({"LOOK": "EYES NECK", "GLANCE": "EYES", "SHIFT": "EYES NECK"})
_STYLE = f"{{{SBM}}}style"
_JOINT_RANGE = f"{{{SBM}}}joint-range"

_PRIORITY_STEP = 10
"""SmartBody's priorities are integers; ours differ by tenths."""

Times = Mapping[str, Time]


def to_smartbody(
    performance: Performance, timing: TimeForm, tables: SmartBodyTables, *, audio_name: str | None = None
) -> Document:
    """A document with one act; `audio_name` is the recording's file name without extension, without which SmartBody
    refuses the speech."""
    words, lead_in_s = performance.utterance.words, performance.utterance.lead_in_s
    timed = time_formatter(words, timing, mark=first_mark, speech_start_s=lead_in_s)
    agitation = performance.utterance.agitation
    style = _STYLES[agitation.level] if agitation else None
    speech = (speech_element(performance, timing, safe(audio_name) if audio_name else None),) if words else ()
    movements = (
        element
        for behavior in _playable(performance)
        for element in _elements(behavior, timed(behavior.sync), tables, style)
    )
    saccade = Element("saccade", {"mode": "talk" if words else "listen", "start": 0.0})
    actor = Element("participant", {"id": performance.character, "role": "actor"})
    block = Element("bml", content=(*speech, saccade, *movements))
    return Document(DialectName.SMARTBODY, Element("act", content=(actor, block)))


def left_out(performance: Performance, audio_name: str | None, tables: SmartBodyTables) -> Iterator[Notice]:
    """Notices about what SmartBody would refuse, fail on, not find or not show, and what is written instead."""
    if performance.utterance.words and audio_name is None:
        message = "SmartBody finds a recording by its name, and this one has none; name it, or write ref in the speech"
        yield Notice("smartbody_unnamed", message)
    if audio_name and safe(audio_name) != audio_name:
        message = f"SmartBody cannot read {UNSAFE} in a name; call the recording {safe(audio_name)!r} there"
        yield Notice("smartbody_text", message)
    words = [word.text for word in performance.utterance.words if safe(word.text) != word.text]
    if words:
        yield Notice("smartbody_text", f"SmartBody cannot read {UNSAFE}; left out in: {', '.join(words)}")
    gazes = [each for each in performance.behaviors if each.kept and not _has_target(each, performance)]
    if gazes:
        message = (
            f"{len(gazes)} gazes are left out: SmartBody looks only at pawns and characters of its scene; "
            "name them as listeners or targets"
        )
        yield Notice("smartbody_gaze", message)
    yield from _other_units(performance, tables)


def _other_units(performance: Performance, tables: SmartBodyTables) -> Iterator[Notice]:
    """A notice if faces have action units for which others are written."""
    faces = [each for each in performance.behaviors if each.kept and each.kind in {Channel.FACE, Channel.EYES}]
    asked = sorted({unit for face in faces for unit in _units(face.lexeme)[1]})
    shown = [f"{tables.unit_shown(unit).unit} for {unit}" for unit in asked if tables.unit_shown(unit).unit != unit]
    if shown:
        message = f"the faces of SmartBody's characters lack action units; others are written: {', '.join(shown)}"
        yield Notice("smartbody_face", message)


def _playable(performance: Performance) -> Iterator[Behavior]:
    """The kept behaviours, without gazes at nothing, and with gazes at the listener directed at the first named one."""
    names = [listening.name for listening in performance.listeners]
    for behavior in performance.behaviors:
        if not behavior.kept or not _has_target(behavior, performance):
            continue
        at_listener = behavior.kind is Channel.GAZE and behavior.target == LISTENER and LISTENER not in names
        yield replace(behavior, target=names[0]) if at_listener and names else behavior


def _has_target(behavior: Behavior, performance: Performance) -> bool:
    """Whether a gaze is at a person or thing in the scene; SmartBody refuses others. A performance without words is a
    listener's, whose gazes are at the speaker."""
    if behavior.kind is not Channel.GAZE or not performance.utterance.words:
        return True
    names = {listening.name for listening in performance.listeners}
    return behavior.target in names | {target.name for target in performance.targets} | ({LISTENER} if names else set())


def _elements(behavior: Behavior, times: Times, tables: SmartBodyTables, style: str | None) -> Iterator[Element]:
    match behavior.kind:
        case Channel.GESTURE:
            yield _gesture(behavior, times, tables.gesture(behavior.lexeme, behavior.hand, style))
        case Channel.HEAD:
            yield _head(behavior, times)
        case Channel.GAZE:
            yield from _gazes(behavior, times)
        case Channel.FACE | Channel.EYES:
            yield from _faces(behavior, times, tables)
        case Channel.POSTURE:
            yield Element("body", {"id": behavior.id, "posture": behavior.lexeme, **_some(times, "start", "end")})


def _gesture(behavior: Behavior, times: Times, name: GestureName) -> Element:
    attributes: dict[str, Value] = {"id": behavior.id, "type": name.type}
    if name.hand:
        attributes["mode"] = MODES[name.hand]
    if name.style:
        attributes[_STYLE] = name.style
    attributes["priority"] = _priority(behavior)
    return Element("gesture", {**attributes, **_some(times, "stroke", "relax")})


def _head(behavior: Behavior, times: Times) -> Element:
    attributes: dict[str, Value] = {"id": behavior.id, "type": HEADS.get(behavior.lexeme, behavior.lexeme)}
    if behavior.repetitions is not None:
        attributes["repeats"] = float(behavior.repetitions)
    return Element("head", {**attributes, **_amount(behavior), "priority": _priority(behavior), **times})


def _gazes(behavior: Behavior, times: Times) -> Iterator[Element]:
    """The gaze, and another one that returns the eyes to its target."""
    target: dict[str, Value] = {"target": behavior.target or "", _JOINT_RANGE: _JOINTS[behavior.lexeme]}
    aside: dict[str, Value] = {}
    if behavior.direction is not None and behavior.amount is not None:
        aside = {"direction": behavior.direction, "angle": to_milli(behavior.amount * GAZE_RANGE_DEGREES)}
    yield Element("gaze", {"id": behavior.id, **target, **aside, "start": times["start"]})
    if aside and behavior.lexeme != "SHIFT":
        yield Element("gaze", {"id": f"{behavior.id}back", **target, "start": times.get("relax", times["end"])})


def _faces(behavior: Behavior, times: Times, tables: SmartBodyTables) -> Iterator[Element]:
    """An element for each action unit that the face has, or the one that stands in for it, numbered from the second
    on."""
    side, units = _units(behavior.lexeme)
    for number, shown in enumerate(map(tables.unit_shown, units), start=1):
        name = behavior.id if number == 1 else f"{behavior.id}unit{number}"
        attributes: dict[str, Value] = {"id": name, "type": "facs", "au": str(shown.unit), "side": side}
        amount = {} if behavior.amount is None and shown.share == 1 else {"amount": _share(behavior, shown.share)}
        yield Element("face", {**attributes, **amount, "priority": _priority(behavior), **times})


def _share(behavior: Behavior, share: float) -> float:
    return to_milli(share * (1.0 if behavior.amount is None else behavior.amount))


def _units(lexeme: str) -> tuple[str, tuple[int, ...]]:
    """The side of the face, and the action units of a lexeme."""
    if lexeme in ACTION_UNITS:
        return "both", (ACTION_UNITS[lexeme],)
    for side in ("LEFT", "RIGHT"):
        whole = lexeme.replace(f"_{side}_BROW", "_BROWS").replace(f"_{side}_MOUTH_CORNER", "_MOUTH_CORNERS")
        if whole != lexeme:
            return side.lower(), UNITS_OF_LEXEMES[whole]
    return "both", UNITS_OF_LEXEMES[lexeme]


def _amount(behavior: Behavior) -> dict[str, Value]:
    return {} if behavior.amount is None else {"amount": to_milli(behavior.amount)}


def _some(times: Times, *names: str) -> Times:
    return {name: times[name] for name in names if name in times}


def _priority(behavior: Behavior) -> int:
    return max(0, round(behavior.priority * _PRIORITY_STEP))
