"""BML as strips know it: which behaviours a file has, and the file with some moved, made longer, or left out.

Both BML 1.0 and SmartBody's dialect are read, each element by its local name. What is not changed stays as it was
written, other namespaces too. Files may come from anywhere: a DOCTYPE, and so every entity, is refused.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from xml.dom import minidom
from xml.parsers.expat import ExpatError

KINDS = {
    "gesture": "gesture",
    "pointing": "gesture",
    "animation": "gesture",
    "head": "head",
    "headDirectionShift": "head",
    "gaze": "gaze",
    "gazeShift": "gaze",
    "saccade": "gaze",
    "face": "face",
    "faceLexeme": "face",
    "faceFacs": "face",
    "faceShift": "face",
    "posture": "posture",
    "postureShift": "posture",
    "pose": "posture",
    "body": "posture",
}
"""Elements that are behaviours, and their kinds; speech, locomotion and what only orders others are none."""

_POINTS = (
    "start",
    "ready",
    "strokeStart",
    "attackPeak",
    "stroke",
    "strokeEnd",
    "relax",
    "end",
    "stroke_start",
    "stroke_end",
)
_OURS = {"strokeStart": "stroke_start", "strokeEnd": "stroke_end", "attackPeak": "ready"}
_BLINK = "AU 45"
_REFERENCE = re.compile(r"^\s*(?P<point>[A-Za-z_][\w.]*(?::[\w.]+)+)\s*(?P<offset>[+-]\s*[\d.]+)?\s*$")


class WrongBmlError(ValueError):
    """A file that is not BML; the message says why."""


@dataclass(frozen=True, slots=True)
class Described:
    """A behaviour's element: its id, kind and what it is called, its hand, what is looked at and by which way."""

    id: str
    kind: str
    lexeme: str
    hand: str = ""
    target: str = ""
    direction: str = ""


@dataclass(frozen=True, slots=True)
class StripChange:
    """What was done to a behaviour's strip: moved by `shift_s`, its end by `longer_s` more, or taken out."""

    behavior: str
    shift_s: float = 0.0
    longer_s: float = 0.0
    removed: bool = False


def described(bml: bytes) -> tuple[Described, ...]:
    """The behaviours of a file in its order. Raises WrongBmlError."""
    return tuple(map(_described, _behaviors(bml)))


def text_of(bml: bytes) -> str:
    """The words of the speech, empty where there are none. Raises WrongBmlError."""
    for element in _elements(_parsed(bml)):
        if _local(element) == "text":
            return " ".join("".join(_texts(element)).split())
    return ""


def character_of(bml: bytes) -> str:
    """Who is to perform, empty where nobody is named. Raises WrongBmlError."""
    for element in _elements(_parsed(bml)):
        for name in ("characterId", "character"):
            if element.getAttribute(name):
                return str(element.getAttribute(name))
    return ""


def changed(bml: bytes, changes: Mapping[str, StripChange], realized_s: Mapping[str, Mapping[str, float]]) -> bytes:
    """The file with the strips' changes.

    Times in seconds are moved, times that refer to other behaviours get an offset. `realized_s` are the points of all
    behaviours (our names): where a behaviour has no time of its own it gets the one realized, and so do those that
    refer to one that is taken out. Raises WrongBmlError.
    """
    document = _parsed(bml)
    removed = {change.behavior for change in changes.values() if change.removed}
    for element in [each for each in _elements(document) if _local(each) in KINDS]:
        name = element.getAttribute("id")
        change = changes.get(name)
        if change and change.removed:
            _take_out(element)
            continue
        _free_of(element, removed, realized_s)
        if change:
            _move(element, change, realized_s.get(name, {}))
    for element in [each for each in _elements(document) if each.getAttribute("ref") in removed]:
        _take_out(element)
    return bytes(document.toxml(encoding="UTF-8"))


def _described(element: minidom.Element) -> Described:
    """A blink is one of the eyes, whatever element writes it."""
    name, kind, lexeme = element.getAttribute("id"), KINDS[_local(element)], _lexeme(element)
    if lexeme == _BLINK:
        return Described(name, "eyes", "BLINK")
    hand = element.getAttribute("mode").removesuffix("_HAND").removesuffix("_HANDS").lower()
    return Described(name, kind, lexeme, hand, element.getAttribute("target"), element.getAttribute("offsetDirection"))


def _parsed(bml: bytes) -> minidom.Document:
    if b"<!DOCTYPE" in bml:
        raise WrongBmlError("BML with a DOCTYPE is not read; take it out")
    try:
        return minidom.parseString(bml)
    except (ExpatError, ValueError) as error:
        raise WrongBmlError(f"this is not BML: {error}") from None


def _elements(document: minidom.Document) -> Iterator[minidom.Element]:
    yield from document.getElementsByTagName("*")


def _behaviors(bml: bytes) -> list[minidom.Element]:
    return [each for each in _elements(_parsed(bml)) if _local(each) in KINDS and each.getAttribute("id")]


def _local(element: minidom.Element) -> str:
    return str(element.tagName.rpartition(":")[2])


def _lexeme(element: minidom.Element) -> str:
    """The name of a behaviour: its first attribute that has one."""
    names = ("lexeme", "type", "name", "target", "mode")
    said = next((str(element.getAttribute(name)) for name in names if element.getAttribute(name)), _local(element))
    unit = element.getAttribute("au")
    return f"AU {unit}" if unit else said


def _texts(element: minidom.Element) -> Iterator[str]:
    for node in element.childNodes:
        if isinstance(node, minidom.Text):
            yield node.data
        elif isinstance(node, minidom.Element):
            yield " "
            yield from _texts(node)


def _take_out(element: minidom.Element) -> None:
    """Removes an element and the line that it stood on."""
    parent, before = element.parentNode, element.previousSibling
    if not isinstance(parent, minidom.Element):
        return
    parent.removeChild(element)
    if isinstance(before, minidom.Text) and not before.data.strip():
        parent.removeChild(before)


def _free_of(element: minidom.Element, removed: set[str], realized_s: Mapping[str, Mapping[str, float]]) -> None:
    """Times that refer to a behaviour that is taken out become the seconds at which it was realized."""
    for name in _POINTS:
        found = _REFERENCE.match(element.getAttribute(name))
        if not found:
            continue
        behavior, point = found["point"].split(":")[-2:]
        if behavior in removed:
            time_s = realized_s.get(behavior, {}).get(_OURS.get(point, point), 0.0) + _offset_s(found)
            element.setAttribute(name, _seconds(time_s))


def _move(element: minidom.Element, change: StripChange, realized_s: Mapping[str, float]) -> None:
    timed = [name for name in _POINTS if element.getAttribute(name)]
    if not timed:
        element.setAttribute("start", _seconds(realized_s.get("start", 0.0)))
        timed = ["start"]
    for name in timed:
        later_s = change.shift_s + (change.longer_s if name == "end" else 0.0)
        element.setAttribute(name, _later(element.getAttribute(name), later_s))
    if change.longer_s and "end" not in timed and "end" in realized_s:
        element.setAttribute("end", _seconds(realized_s["end"] + change.shift_s + change.longer_s))


def _later(written: str, later_s: float) -> str:
    """A time so much later: in seconds never before 0, from another behaviour by its offset."""
    found = _REFERENCE.match(written)
    if found:
        return f"{found['point']}{_offset_s(found) + later_s:+.3f}"
    try:
        return _seconds(float(written) + later_s)
    except ValueError:
        return written


def _offset_s(found: "re.Match[str]") -> float:
    return float((found["offset"] or "0").replace(" ", ""))


def _seconds(time_s: float) -> str:
    return f"{max(time_s, 0.0):.3f}"
