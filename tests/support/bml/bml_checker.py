"""Checks a BML document against every point of shared/bml.md's section on BML 1.0 core, and for overlapping behaviours.

Written from that page and not from our writer, and used by the tests of whole lines.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from lxml import etree

CORE = "{http://www.bml-initiative.org/bml/bml-1.0}"
EXTENSIONS = "{http://www.bml-initiative.org/bml/coreextensions-1.0}"
NAMESPACES = {CORE, EXTENSIONS}

STROKED = ("start", "ready", "strokeStart", "stroke", "strokeEnd", "relax", "end")
REACHED = ("start", "ready", "relax", "end")
FACIAL = ("start", "attackPeak", "relax", "end")
ENDS = ("start", "end")


@dataclass(frozen=True, slots=True)
class Kind:
    """What an element may carry: its sync points in order, and its attributes, the required ones apart."""

    syncs: tuple[str, ...] = ()
    required: frozenset[str] = frozenset()
    optional: frozenset[str] = frozenset()
    identified: bool = True


KINDS: Mapping[str, Kind] = {
    CORE + "speech": Kind(ENDS),
    CORE + "gesture": Kind(STROKED, frozenset({"lexeme"}), frozenset({"mode"})),
    CORE + "pointing": Kind(STROKED, frozenset({"target"}), frozenset({"mode"})),
    CORE + "head": Kind(STROKED, frozenset({"lexeme"}), frozenset({"repetition", "amount"})),
    CORE + "headDirectionShift": Kind(ENDS, frozenset({"target"})),
    CORE + "gaze": Kind(REACHED, frozenset({"target"}), frozenset({"influence", "offsetAngle", "offsetDirection"})),
    CORE + "gazeShift": Kind(ENDS, frozenset({"target"}), frozenset({"influence", "offsetAngle", "offsetDirection"})),
    CORE + "faceLexeme": Kind(FACIAL, frozenset({"lexeme"}), frozenset({"amount"})),
    EXTENSIONS + "faceFacs": Kind(FACIAL, frozenset({"au"}), frozenset({"side", "amount"})),
    CORE + "posture": Kind(REACHED),
    CORE + "postureShift": Kind(ENDS),
    CORE + "locomotion": Kind(ENDS, frozenset({"target"}), frozenset({"manner"})),
    CORE + "wait": Kind(ENDS, frozenset({"max-wait"})),
    CORE + "constraint": Kind(identified=False),
    CORE + "required": Kind(identified=False),
}
PARTS: Mapping[str, Kind] = {
    CORE + "text": Kind(identified=False),
    CORE + "description": Kind(required=frozenset({"priority", "type"}), identified=False),
    CORE + "stance": Kind(required=frozenset({"type"}), identified=False),
    CORE + "pose": Kind(required=frozenset({"part", "lexeme"}), identified=False),
    CORE + "synchronize": Kind(identified=False),
    CORE + "before": Kind(required=frozenset({"ref"}), identified=False),
    CORE + "after": Kind(required=frozenset({"ref"}), identified=False),
}
SYNC = CORE + "sync"

CLOSED: Mapping[str, frozenset[str]] = {
    "mode": frozenset({"LEFT_HAND", "RIGHT_HAND", "BOTH_HANDS"}),
    "side": frozenset({"LEFT", "RIGHT", "BOTH"}),
    "composition": frozenset({"MERGE", "APPEND", "REPLACE"}),
    "offsetDirection": frozenset(
        ["LEFT", "RIGHT", "UP", "DOWN", "UPLEFT", "UPRIGHT", "DOWNLEFT", "DOWNRIGHT", "POLAR"]
    ),
}
WHOLE = frozenset({"au", "repetition"})
DECIMAL_ATTRIBUTES = frozenset({"amount", "offsetAngle", "max-wait"})

ID = re.compile(r"[A-Za-z][A-Za-z0-9_.]*")
DECIMAL = re.compile(r"-?\d+(\.\d+)?")
REFERENCE = re.compile(r"([A-Za-z][A-Za-z0-9_.]*):([A-Za-z][A-Za-z0-9_.]*)(\s*[+-]\s*\d+(\.\d+)?)?")
CHARACTER_REFERENCE = re.compile(rb"&#(x[0-9A-Fa-f]+|\d+);")


def check(bml: bytes) -> list[str]:
    """What is wrong with the document, a line for each mistake; nothing when realizers will play it."""
    try:
        text = bml.decode("utf-8")
        root = etree.fromstring(bml, etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False))
    except (UnicodeDecodeError, etree.XMLSyntaxError) as error:
        return [f"not well-formed UTF-8 XML: {error}"]
    if root.tag != CORE + "bml":
        return [f"the root is {root.tag}, not {CORE}bml"]
    return [
        *(["has a DOCTYPE"] if "<!DOCTYPE" in text else []),
        *(["has numeric character references"] if CHARACTER_REFERENCE.search(bml) else []),
        *_root(root),
        *_elements(root),
        *_ids(root),
        *_references(root),
        *_order(root),
        *_overlaps(root),
    ]


def _root(root: etree._Element) -> Iterator[str]:
    for name in ("id", "characterId"):
        if name not in _given(root):
            yield f"<bml> has no {name}"
    for name in _given(root):
        if name not in ("id", "characterId", "composition"):
            yield f"<bml> may not have {name}"
    if not list(root):
        yield "<bml> is empty"


def _elements(root: etree._Element) -> Iterator[str]:
    yield from _values(root)
    for child in root.iterchildren("*"):
        if child.tag in KINDS:
            yield from _attributes(child, KINDS[child.tag])
            yield from _parts(child)
        else:
            yield f"{_name(child)}: no behaviour of BML 1.0 core"


def _parts(behavior: etree._Element) -> Iterator[str]:
    descriptions = behavior.findall(CORE + "description")
    free = {inside for description in descriptions for inside in description.iterdescendants("*")}
    for part in behavior.iterdescendants("*"):
        if part in free:
            continue
        if part.tag == SYNC:
            yield from _attributes(part, Kind(optional=frozenset({"ref"}), identified="ref" not in _given(part)))
        elif part.tag in PARTS:
            yield from _attributes(part, PARTS[part.tag])
        elif part.tag in KINDS and behavior.tag == CORE + "required":
            yield from _attributes(part, KINDS[part.tag])
        else:
            yield f"{_name(part)}: no part of a behaviour"
    if behavior.tag == CORE + "speech" and behavior.find(CORE + "text") is None:
        yield f"{_name(behavior)}: no text"


def _attributes(element: etree._Element, kind: Kind) -> Iterator[str]:
    identity = frozenset({"id"}) if kind.identified else frozenset()
    explicit = frozenset({"start"}) if kind.syncs else frozenset()
    given = _given(element).keys()
    for name in sorted((identity | explicit | kind.required) - given):
        yield f"{_name(element)}: no {name}"
    for name in sorted(given - identity - kind.required - kind.optional - set(kind.syncs)):
        yield f"{_name(element)}: {name} is refused"
    yield from _values(element)


def _values(element: etree._Element) -> Iterator[str]:
    for name, value in _given(element).items():
        where = f"{_name(element)}: {name}={value!r}"
        if not value.strip():
            yield f"{where} is empty"
        elif name in CLOSED and value not in CLOSED[name]:
            yield f"{where} is none of {', '.join(sorted(CLOSED[name]))}"
        elif name in WHOLE and not re.fullmatch(r"\d+", value):
            yield f"{where} is not a whole number"
        elif name in DECIMAL_ATTRIBUTES and not DECIMAL.fullmatch(value):
            yield f"{where} is not a fixed decimal"
        elif name in (*STROKED, "attackPeak") and not (DECIMAL.fullmatch(value) or REFERENCE.fullmatch(value)):
            yield f"{where} is neither a fixed decimal nor a reference"
        elif name in ("id", "characterId") and not ID.fullmatch(value):
            yield f"{where} breaks references"
        elif name == "amount" and not 0 <= float(value) <= 1:
            yield f"{where} is not between 0 and 1"


def _ids(root: etree._Element) -> Iterator[str]:
    """Behaviours and the block share one name space; each speech has one of its own for its marks."""
    blocks = [root, *(child for child in root.iterchildren("*") if child.tag != CORE + "constraint")]
    yield from _doubles([element.get("id", "") for element in blocks])
    for speech in root.iter(CORE + "speech"):
        yield from _doubles([mark.get("id", "") for mark in speech.iter(SYNC)])


def _doubles(ids: Sequence[str]) -> Iterator[str]:
    for name in sorted({name for name in ids if name and ids.count(name) > 1}):
        yield f"id {name!r} is there {ids.count(name)} times"


def _references(root: etree._Element) -> Iterator[str]:
    points = {
        child.get("id"): {*KINDS[child.tag].syncs, *(mark.get("id") for mark in child.iter(SYNC))}
        for child in root.iterchildren("*")
        if child.tag in KINDS
    }
    for element in root.iterdescendants("*"):
        for name in (*STROKED, "attackPeak", "ref"):
            reference = REFERENCE.fullmatch(element.get(name, ""))
            if reference and reference[1] not in points:
                yield f"{_name(element)}: {name} refers to unknown behaviour {reference[1]!r}"
            elif reference and reference[2] not in points[reference[1]]:
                yield f"{_name(element)}: {name} refers to unknown mark {reference[0]!r}"


def _order(root: etree._Element) -> Iterator[str]:
    for element in root.iterchildren("*"):
        kind = KINDS.get(element.tag, Kind())
        times = [
            (name, float(element.get(name, ""))) for name in kind.syncs if DECIMAL.fullmatch(element.get(name, ""))
        ]
        for (name, time_s), (later, later_s) in pairwise(times):
            if later_s < time_s:
                yield f"{_name(element)}: {later} {later_s} is before {name} {time_s}"
        if times and times[0][1] < 0:
            yield f"{_name(element)}: {times[0][0]} {times[0][1]} is before 0"


def _overlaps(root: etree._Element) -> Iterator[str]:
    """Behaviours that want the same part of the body at the same time."""
    busy: dict[str, list[tuple[float, float, str]]] = {}
    for element in root.iterchildren("*"):
        start, end = element.get("start", ""), element.get("end", "")
        if DECIMAL.fullmatch(start) and DECIMAL.fullmatch(end):
            for resource in _resources(element):
                busy.setdefault(resource, []).append((float(start), float(end), _name(element)))
    for resource, spans in busy.items():
        for (_, end_s, name), (start_s, _, later) in pairwise(sorted(spans)):
            if start_s < end_s:
                yield f"{name} and {later} overlap ({resource})"


def _resources(element: etree._Element) -> tuple[str, ...]:
    name = etree.QName(element).localname
    if name in ("gesture", "pointing"):
        mode = element.get("mode", "BOTH_HANDS")
        return ("LEFT_HAND", "RIGHT_HAND") if mode == "BOTH_HANDS" else (mode,)
    if name == "faceFacs":
        if element.get("au") in ("43", "45"):
            return ("eyelids",)
        part = {"1": "brows", "2": "brows", "4": "brows", "5": "lids", "6": "lids", "7": "lids"}
        return (part.get(element.get("au") or "", "mouth"),)
    if name == "faceLexeme":
        lexeme = element.get("lexeme", "")
        if any(part in lexeme for part in ("MOUTH", "LIP")):
            return ("mouth",)
        return ("lids",) if "EYES" in lexeme else ("brows",)
    return {"head": ("head",), "gaze": ("gaze",), "gazeShift": ("gaze",)}.get(name, ())


def _given(element: etree._Element) -> dict[str, str]:
    return {str(name): str(value) for name, value in element.attrib.items()}


def _name(element: etree._Element) -> str:
    name = etree.QName(element).localname
    return f"<{name} {element.get('id')}>" if element.get("id") else f"<{name}>"
