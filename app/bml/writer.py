"""The kept behaviours of a performance as BML 1.0 core, in the form that strict realizers read (shared/bml.md).

Every time is absolute, in seconds with three decimals: realizers do not know when the words of recorded speech fall.
The speech carries a mark before every word, `w0`, `w1`, …, and one after the last. Nothing of ours that BML has no
attribute for goes in; the performance has it all.
"""

from collections.abc import Mapping
from types import MappingProxyType

from lxml import etree

from app.bml.faces import ACTION_UNITS
from app.model import Behavior, Channel, Hand, Performance, SyncPoints, Word

CORE = "http://www.bml-initiative.org/bml/bml-1.0"
CORE_EXTENSIONS = "http://www.bml-initiative.org/bml/coreextensions-1.0"

# lxml-stubs do not know that None is the default namespace.
_IN_CORE: dict[str, str] = {None: CORE}  # type: ignore[dict-item]
_IN_EXTENSIONS: dict[str, str] = {None: CORE_EXTENSIONS}  # type: ignore[dict-item]

GAZE_RANGE_DEGREES = 60.0
"""How far beside its target a gaze of amount 1 goes."""

_MODES: Mapping[Hand, str] = MappingProxyType(
    {Hand.LEFT: "LEFT_HAND", Hand.RIGHT: "RIGHT_HAND", Hand.BOTH: "BOTH_HANDS"}
)
_INFLUENCES: Mapping[str, str] = MappingProxyType({"LOOK": "NECK", "GLANCE": "EYES", "SHIFT": "NECK"})
"""The joints that take part in our gaze lexemes; the suite of the reference realizers uses NECK."""

_SYNC_NAMES: Mapping[str, str] = MappingProxyType({"stroke_start": "strokeStart", "stroke_end": "strokeEnd"})
_FACE_SYNC_NAMES: Mapping[str, str] = MappingProxyType({"ready": "attackPeak"})


def write_bml(performance: Performance) -> bytes:
    """The BML document, UTF-8: the speech, then the kept behaviours in order of time."""
    root = etree.Element(f"{{{CORE}}}bml", {"id": "bml1", "characterId": performance.character}, nsmap=_IN_CORE)
    root.append(_speech(performance.utterance.words))
    for behavior in performance.behaviors:
        if behavior.kept:
            root.append(_element(behavior))
    return etree.tostring(root, encoding="UTF-8", xml_declaration=True, pretty_print=True)


def _speech(words: tuple[Word, ...]) -> etree._Element:
    speech = _core("speech", {"id": "speech1", "start": _number(0.0)})
    text = etree.SubElement(speech, f"{{{CORE}}}text")
    for number, word in enumerate(words):
        mark = etree.SubElement(text, f"{{{CORE}}}sync", {"id": f"w{number}"})
        mark.tail = f"{word.text} "
    etree.SubElement(text, f"{{{CORE}}}sync", {"id": f"w{len(words)}"})
    return speech


def _element(behavior: Behavior) -> etree._Element:
    match behavior.kind:
        case Channel.GESTURE:
            return _core("gesture", _gesture(behavior))
        case Channel.HEAD:
            return _core("head", _head(behavior))
        case Channel.GAZE:
            return _gaze(behavior)
        case Channel.FACE | Channel.EYES:
            return _face(behavior)
        case Channel.POSTURE:
            return _posture(behavior)


def _gesture(behavior: Behavior) -> dict[str, str]:
    mode = {"mode": _MODES[behavior.hand]} if behavior.hand else {}
    return {"id": behavior.id, "lexeme": behavior.lexeme, **mode, **_times(behavior.sync, _SYNC_NAMES)}


def _head(behavior: Behavior) -> dict[str, str]:
    repetition = {"repetition": str(behavior.repetitions)} if behavior.repetitions is not None else {}
    times = _times(behavior.sync, _SYNC_NAMES)
    return {"id": behavior.id, "lexeme": behavior.lexeme, **repetition, **_amount(behavior), **times}


def _gaze(behavior: Behavior) -> etree._Element:
    """A `gaze`, from which the eyes come back, or the `gazeShift`, which has no more than a start and an end."""
    attributes = {"id": behavior.id, "target": behavior.target or "", "influence": _INFLUENCES[behavior.lexeme]}
    if behavior.direction is not None and behavior.amount is not None:
        attributes["offsetAngle"] = _number(behavior.amount * GAZE_RANGE_DEGREES)
        attributes["offsetDirection"] = behavior.direction
    if behavior.lexeme == "SHIFT":
        return _core("gazeShift", attributes | _ends(behavior.sync))
    return _core("gaze", attributes | _times(behavior.sync, _SYNC_NAMES))


def _face(behavior: Behavior) -> etree._Element:
    times = _times(behavior.sync, _FACE_SYNC_NAMES)
    if behavior.lexeme in ACTION_UNITS:
        unit = {"au": str(ACTION_UNITS[behavior.lexeme]), "side": "BOTH"}
        attributes = {"id": behavior.id, **unit, **_amount(behavior), **times}
        return etree.Element(f"{{{CORE_EXTENSIONS}}}faceFacs", attributes, nsmap=_IN_EXTENSIONS)
    return _core("faceLexeme", {"id": behavior.id, "lexeme": behavior.lexeme, **_amount(behavior), **times})


def _posture(behavior: Behavior) -> etree._Element:
    shift = _core("postureShift", {"id": behavior.id, **_ends(behavior.sync)})
    etree.SubElement(shift, f"{{{CORE}}}stance", {"type": "STANDING"})
    etree.SubElement(shift, f"{{{CORE}}}pose", {"part": "WHOLEBODY", "lexeme": behavior.lexeme})
    return shift


def _core(name: str, attributes: Mapping[str, str]) -> etree._Element:
    return etree.Element(f"{{{CORE}}}{name}", dict(attributes), nsmap=_IN_CORE)


def _amount(behavior: Behavior) -> dict[str, str]:
    return {} if behavior.amount is None else {"amount": _number(behavior.amount)}


def _times(sync: SyncPoints, names: Mapping[str, str]) -> dict[str, str]:
    return {names.get(name, name): _number(time_s) for name, time_s in sync.in_order()}


def _ends(sync: SyncPoints) -> dict[str, str]:
    return {"start": _number(sync.start), "end": _number(sync.end)}


def _number(value: float) -> str:
    return f"{value:.3f}"
