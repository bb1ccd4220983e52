"""Converts the schedule of a performance to SmartBody's dialect (shared/bml.md, "SmartBody dialect"), with lip sync.

SmartBody has a smaller vocabulary. Gestures and head movements without a counterpart are written as the nearest one
(`GESTURES`, `HEADS`); a gesture lexeme in neither is written unchanged, for characters that have such a gesture. Faces
are action units, as are blinks; a gaze lasts until the next, so one that returns becomes two; a posture is the name of
one of the character's own. Gestures have only `stroke` and `relax`, all that its scheduler accepts together.
"""

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from ...model import Behavior, Channel, Level, Performance, Viseme, Word
from ..choice.behavior_table.faces import ACTION_UNITS
from ..choice.speech.visemes import SILENCE
from ..markup.documents import DialectName, Document, Element, Time, TimeForm, Value
from ..markup.elements import SBM
from ..markup.marks import SPEECH, time_formatter, to_milli
from .blocks import GAZE_RANGE_DEGREES, MODES

_GESTURES_OF_TYPES: Mapping[str, str] = MappingProxyType(
    {
        "RHYTHM": "BEAT CHOP COUNT COUNT_FIRST COUNT_FIVE COUNT_FOUR COUNT_LAST COUNT_NEXT COUNT_ONE COUNT_THREE "
        "COUNT_TWO FAST PALM_BEAT QUOTES ROLL SLOW START MIME_KNOCK MIME_PRESS MIME_TYPE MIME_WRITE",
        "YOU": "GIVE OFFER OPEN_HAND PALM_UP THANKS MIME_TALK MIME_THUMB_UP MIME_TOAST",
        "ME": "APOLOGISE BRING_BACK COME_CLOSER HAND_ON_HEART MIME_BELLY MIME_DRINK MIME_EAT MIME_GRAB "
        "MIME_LOOK MIME_OATH MIME_PULL",
        "HERE": "NEAR NOW SET_DOWN",
        "LEFT": "PLACE_LEFT POINT_LEFT",
        "RIGHT": "PLACE_RIGHT POINT_RIGHT",
        "CENTER": "BETWEEN FUTURE HOLD NARROW PATH_FORWARD POINT_FRONT PUT_IN SHORT SWEEP_FORWARD THROUGH "
        "MIME_CRADLE MIME_DRIVE MIME_POUR MIME_READ MIME_WALK MIME_WATCH",
        "ASIDE": "BACK DISMISS OVER_SHOULDER PASS_BY PAST PATH_ASIDE PUSH_AWAY SET_ASIDE SWEEP_AWAY TAKE_OUT THERE "
        "MIME_SMELL MIME_THROW",
        "CONTRAST": "COMPARATIVE COMPARATIVE_BIGGER COMPARATIVE_EQUAL COMPARATIVE_LONGER COMPARATIVE_SMALLER "
        "PULL_APART TURN_OVER WEIGH MIME_TURN_KEY",
        "OBLIGATION": "FIST HEAVY INSIST POINT_UP RAISED_FINGER MIME_HIT MIME_SHOOT MIME_SWORD",
        "UNCERTAINTY": "SHRUG THINK WAVER WORD_SEARCH MIME_COVER_MOUTH MIME_FAN MIME_HOLD_HEAD MIME_LISTEN MIME_PHONE "
        "MIME_SLEEP",
        "INCLUSIVITY": "ACCEPT GATHER JOIN PALMS_TOGETHER",
        "EMPTY": "END_CUT FALL FLAT HEIGHT_LOW PALMS_OUT STROKE_SOFTLY MIME_CUT MIME_THROAT",
        "SURROUND": "CIRCLE CONTAIN FULL HEIGHT_HIGH LIFT_LIGHTLY LONG OPEN_UP RISE ROUND SWEEP_ALL UP WIDE "
        "MIME_BURST MIME_FLY MIME_LIFT",
        "STOP": "DOWN WALL MIME_HUSH MIME_PUSH",
        "GREETING": "FAREWELL MIME_SALUTE",
        "INTENSIFIER_POSITIVE": "PINCH PRECISION MIME_MONEY MIME_OK",
    }
)
GESTURES: Mapping[str, str] = MappingProxyType(
    {lexeme: name for name, lexemes in _GESTURES_OF_TYPES.items() for lexeme in lexemes.split()}
)
"""Our gesture lexemes and the nearest types of SmartBody's sets; identical names are not listed."""

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
_JOINT_RANGE = f"{{{SBM}}}joint-range"

_PRIORITY_STEP = 10
"""SmartBody's priorities are integers; ours differ by tenths."""

Times = Mapping[str, Time]


def to_smartbody(performance: Performance, timing: TimeForm, *, audio_name: str | None = None) -> Document:
    """A document with one act; `audio_name` is the recording's file name without extension, which SmartBody needs to
    find it."""
    words, lead_in_s = performance.utterance.words, performance.utterance.lead_in_s
    timed = time_formatter(words, timing, mark=lambda number: f"T{2 * number}", speech_start_s=lead_in_s)
    agitation = performance.utterance.agitation
    style = _STYLES[agitation.level] if agitation else None
    block = (
        *((_speech(words, audio_name, lead_in_s),) if words else ()),
        *(_lips(shape) for shape in performance.visemes if shape.label != SILENCE),
        Element("saccade", {"mode": "talk" if words else "listen", "start": 0.0}),
        *(
            element
            for behavior in performance.behaviors
            if behavior.kept
            for element in _elements(behavior, timed(behavior.sync), style)
        ),
    )
    actor = Element("participant", {"id": performance.character, "role": "actor"})
    return Document(DialectName.SMARTBODY, Element("act", content=(actor, Element("bml", content=block))))


def _speech(words: tuple[Word, ...], audio_name: str | None, start_s: float) -> Element:
    text = Element("text", content=tuple(_marked(words, start_s)))
    recording = Element("file", {"ref": audio_name}) if audio_name else None
    description = Element("description", {"level": 1, "type": "audio/x-wav"}, (recording,)) if recording else None
    return Element(
        "speech", {"id": SPEECH, "start": to_milli(start_s)}, (text, description) if description else (text,)
    )


def _marked(words: tuple[Word, ...], start_s: float) -> Iterator[Element | str]:
    """Every timed word between marks at its start and its end, in seconds from the start of the speech."""
    for word in words:
        if word.interval is None:
            yield f"{word.text} "
            continue
        yield Element("sync", {"id": f"T{2 * word.index}", "time": to_milli(word.interval.start_s - start_s)})
        yield f"{word.text} "
        yield Element("sync", {"id": f"T{2 * word.index + 1}", "time": to_milli(word.interval.end_s - start_s)})


def _lips(shape: Viseme) -> Element:
    """A viseme rises over its first quarter and decays over its last."""
    start_s, end_s = shape.interval.start_s, shape.interval.end_s
    quarter_s = shape.interval.duration_s / 4
    syncs = {"start": start_s, "ready": start_s + quarter_s, "relax": end_s - quarter_s, "end": end_s}
    times = {name: to_milli(time_s) for name, time_s in syncs.items()}
    return Element("lips", {"viseme": shape.label, "articulation": to_milli(shape.articulation), **times})


def _elements(behavior: Behavior, times: Times, style: str | None) -> Iterator[Element]:
    match behavior.kind:
        case Channel.GESTURE:
            yield _gesture(behavior, times, style)
        case Channel.HEAD:
            yield _head(behavior, times)
        case Channel.GAZE:
            yield from _gazes(behavior, times)
        case Channel.FACE | Channel.EYES:
            yield from _faces(behavior, times)
        case Channel.POSTURE:
            yield Element("body", {"id": behavior.id, "posture": behavior.lexeme, **_some(times, "start", "end")})


def _gesture(behavior: Behavior, times: Times, style: str | None) -> Element:
    attributes: dict[str, Value] = {"id": behavior.id, "type": GESTURES.get(behavior.lexeme, behavior.lexeme)}
    if style:
        attributes["style"] = style
    if behavior.hand:
        attributes["mode"] = MODES[behavior.hand]
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
        yield Element("gaze", {"id": f"{behavior.id}.back", **target, "start": times.get("relax", times["end"])})


def _faces(behavior: Behavior, times: Times) -> Iterator[Element]:
    """An element for each action unit, numbered from the second on."""
    side, units = _units(behavior.lexeme)
    for number, unit in enumerate(units, start=1):
        name = behavior.id if number == 1 else f"{behavior.id}.{number}"
        attributes: dict[str, Value] = {"id": name, "type": "facs", "au": str(unit), "side": side}
        yield Element("face", {**attributes, **_amount(behavior), "priority": _priority(behavior), **times})


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
