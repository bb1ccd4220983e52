"""The schema of BML as one table: elements, their attributes and sync points, and their content.

Writer, reader and JSON form all use this table. It covers BML 1.0 core as strict realizers interpret it
(docs/references.md), `faceFacs` of the core extensions, and the subset of SmartBody's dialect that we write. The core
is closed: an unknown name in its namespaces is a mistake. SmartBody's dialect is open: unknown names are kept and
reported.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from types import MappingProxyType

from ...model.formats import DialectName

CORE = "http://www.bml-initiative.org/bml/bml-1.0"
CORE_EXTENSIONS = "http://www.bml-initiative.org/bml/coreextensions-1.0"
SBM = "http://ict.usc.edu"
"""The namespace of SmartBody's additional attributes, `sbm:` in its files."""
BMLT = "http://hmi.ewi.utwente.nl/bmlt"
"""The namespace of ASAP's additional elements, such as recordings."""
BMLA = "http://www.asap-project.org/bmla"
"""The namespace of ASAP's additional attributes of blocks."""
OURS = "urn:understudy:performance"
RECORD_TYPE = "application/vnd.understudy.performance+xml"
"""The namespace, and the type of the `description` of a speech, of what our realizer needs and the core cannot say
(`understudy.bml.writing.blocks`). Other realizers skip a description whose type they do not know."""


class ValueKind(StrEnum):
    """The type of an attribute's value."""

    TEXT = "a text"
    ID = "an id: a letter, then letters, digits, _ and . (a - breaks references)"
    NUMBER = "a fixed decimal"
    SHARE = "a fixed decimal from 0 to 1"
    COUNT = "a whole number"
    WHOLE = "a whole number, which may be negative"
    PHONES = "phones: the label, start and end of each"
    DURATIONS = "durations: fixed decimals"
    TIME = "a time: fixed decimal seconds, or behaviour:point with an optional + or - seconds"


@dataclass(frozen=True, slots=True)
class Attribute:
    """The type of an attribute; `one_of` lists its permitted values (all, if empty); `beyond` matches those of known
    extensions."""

    kind: ValueKind = ValueKind.TEXT
    required: bool = False
    one_of: frozenset[str] = frozenset()
    beyond: re.Pattern[str] | None = None


@dataclass(frozen=True, slots=True)
class ElementKind:
    """The type of an element: its attributes in the order of writing, with its sync points `syncs` in order of time.
    `mixed` permits text between its parts; `free` permits any content beside its parts."""

    name: str
    namespace: str
    attributes: Mapping[str, Attribute]
    syncs: tuple[str, ...] = ()
    parts: Mapping[str, "ElementKind"] = field(default_factory=dict)
    needs: str | None = None
    mixed: bool = False
    free: bool = False

    @property
    def qualified(self) -> str:
        """The expanded name `{namespace}name`."""
        return f"{{{self.namespace}}}{self.name}" if self.namespace else self.name


@dataclass(frozen=True, slots=True)
class Dialect:
    """A dialect with its possible root elements; an unknown name in one of `namespaces` (no namespace: "") is a
    mistake."""

    name: DialectName
    title: str
    roots: Mapping[str, ElementKind]
    namespaces: frozenset[str] = frozenset()


STROKED = ("start", "ready", "strokeStart", "stroke", "strokeEnd", "relax", "end")
REACHED = ("start", "ready", "relax", "end")
FACIAL = ("start", "attackPeak", "relax", "end")
ENDS = ("start", "end")
STROKED_SMARTBODY = ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end")


def _kind(
    name: str,
    attributes: Mapping[str, Attribute] | None = None,
    *,
    syncs: tuple[str, ...] = (),
    parts: Iterable[ElementKind] = (),
    needs: str | None = None,
    mixed: bool = False,
    free: bool = False,
    namespace: str = CORE,
) -> ElementKind:
    """An element type; every sync point is also an attribute."""
    every = {**(attributes or {}), **dict.fromkeys(syncs, _TIME)}
    inside = MappingProxyType({part.name: part for part in parts})
    return ElementKind(name, namespace, MappingProxyType(every), syncs, inside, needs, mixed, free)


def _any(**attributes: Attribute) -> dict[str, Attribute]:
    """The attributes of a behaviour: its id, then those given."""
    return {"id": _ID, **attributes}


def _one_of(values: str, *, required: bool = False, beyond: str | None = None) -> Attribute:
    return Attribute(one_of=frozenset(values.split()), required=required, beyond=re.compile(beyond) if beyond else None)


_ID = Attribute(ValueKind.ID, required=True)
_OWN_ID = Attribute(ValueKind.ID)
_TEXT = Attribute()
_NEEDED = Attribute(required=True)
_TIME = Attribute(ValueKind.TIME)
_SHARE = Attribute(ValueKind.SHARE)
_NUMBER = Attribute(ValueKind.NUMBER)
_COUNT = Attribute(ValueKind.COUNT)
_REFERENCE = Attribute(ValueKind.TIME, required=True)

_HANDS = _one_of("LEFT_HAND RIGHT_HAND BOTH_HANDS")
_GAZE = {
    "target": _NEEDED,
    "influence": _one_of("EYES HEAD NECK SHOULDER TORSO WAIST LEGS WHOLE"),
    "offsetAngle": _NUMBER,
    "offsetDirection": _one_of("LEFT RIGHT UP DOWN UPLEFT UPRIGHT DOWNLEFT DOWNRIGHT POLAR"),
}

_RECORD = _kind(
    "performance",
    {
        "agitation": _one_of("low medium high"),
        "stillness": _SHARE,
        "seed": Attribute(ValueKind.WHOLE),
        "duration": _NUMBER,
    },
    parts=[
        _kind(
            "word",
            {
                **dict.fromkeys(("start", "end", "emphasis", "focus", "prominence", "stressedRatio"), _NUMBER),
                "spread": _one_of("true"),
                "phones": Attribute(ValueKind.PHONES),
            },
            namespace=OURS,
        ),
        _kind(
            "behavior",
            {
                "ref": _ID,
                "priority": _NUMBER,
                "amount": _SHARE,
                "first": _COUNT,
                "last": _COUNT,
                "phases": Attribute(ValueKind.DURATIONS),
                "afterStrokes": Attribute(ValueKind.DURATIONS),
                "path": _one_of("curved"),
                "manner": Attribute(ValueKind.DURATIONS),
                **dict.fromkeys(("target", "rule", "function", "moment", "reason", "slots"), _TEXT),
            },
            namespace=OURS,
        ),
        _kind("notice", {"code": _NEEDED, "message": _NEEDED}, namespace=OURS),
    ],
    namespace=OURS,
)
_DESCRIPTION = _kind(
    "description",
    {"priority": Attribute(ValueKind.COUNT, required=True), "type": _NEEDED},
    parts=[_RECORD],
    free=True,
)
_MARK = _kind("sync", {"id": _ID})
_SPOKEN = _kind("text", parts=[_MARK], mixed=True)
_STANCE = _kind("stance", {"type": _one_of("STANDING SITTING CROUCHING LYING", required=True)})
_POSE = _kind("pose", {"part": _NEEDED, "lexeme": _NEEDED})

_BEHAVIORS = (
    _kind("speech", _any(), syncs=ENDS, parts=[_SPOKEN, _DESCRIPTION], needs="text"),
    _kind("gesture", _any(lexeme=_NEEDED, mode=_HANDS), syncs=STROKED, parts=[_DESCRIPTION]),
    _kind("pointing", _any(target=_NEEDED, mode=_HANDS), syncs=STROKED, parts=[_DESCRIPTION]),
    _kind("head", _any(lexeme=_NEEDED, repetition=_COUNT, amount=_SHARE), syncs=STROKED, parts=[_DESCRIPTION]),
    _kind("headDirectionShift", _any(target=_NEEDED), syncs=ENDS, parts=[_DESCRIPTION]),
    _kind("gaze", _any(**_GAZE), syncs=REACHED, parts=[_DESCRIPTION]),
    _kind("gazeShift", _any(**_GAZE), syncs=ENDS, parts=[_DESCRIPTION]),
    _kind("faceLexeme", _any(lexeme=_NEEDED, amount=_SHARE), syncs=FACIAL, parts=[_DESCRIPTION]),
    _kind(
        "faceFacs",
        _any(au=Attribute(ValueKind.COUNT, required=True), side=_one_of("LEFT RIGHT BOTH"), amount=_SHARE),
        syncs=FACIAL,
        namespace=CORE_EXTENSIONS,
    ),
    _kind("posture", _any(), syncs=REACHED, parts=[_STANCE, _POSE, _DESCRIPTION]),
    _kind("postureShift", _any(), syncs=ENDS, parts=[_STANCE, _POSE, _DESCRIPTION]),
    _kind("locomotion", _any(target=_NEEDED, manner=_TEXT), syncs=ENDS, parts=[_DESCRIPTION]),
    _kind("wait", _any(**{"max-wait": _NUMBER}), syncs=ENDS),
)
_MEETING = _kind("sync", {"ref": _REFERENCE})
_CONSTRAINT = _kind(
    "constraint",
    parts=[
        _kind("synchronize", parts=[_MEETING], needs="sync"),
        _kind("before", {"ref": _REFERENCE}, parts=[_MEETING], needs="sync"),
        _kind("after", {"ref": _REFERENCE}, parts=[_MEETING], needs="sync"),
    ],
)
_BLOCK = _kind(
    "bml",
    {"id": _ID, "characterId": _OWN_ID, "composition": _one_of("MERGE APPEND REPLACE", beyond=r"[A-Z]+-AFTER\(.+\)")},
    parts=[*_BEHAVIORS, _kind("required", parts=[*_BEHAVIORS, _CONSTRAINT]), _CONSTRAINT],
)
BML_CORE = Dialect(
    DialectName.BML, "BML 1.0 core", MappingProxyType({"bml": _BLOCK}), frozenset({CORE, CORE_EXTENSIONS, ""})
)

_JOINTS = f"{{{SBM}}}joint-range"


def _own(name: str, attributes: Mapping[str, Attribute], *, syncs: tuple[str, ...] = ()) -> ElementKind:
    """A behaviour of SmartBody's dialect, where the id is optional."""
    every = {"id": _OWN_ID, **attributes, "priority": _COUNT}
    return _kind(name, every, syncs=syncs, namespace="")


_FILE = _kind("file", {"ref": _NEEDED}, namespace="")
_SPEECH_PARTS = (
    _kind("text", parts=[_kind("sync", {"id": _ID, "time": _NUMBER}, namespace="")], mixed=True, namespace=""),
    _kind("mark", {"name": _ID, "time": _NUMBER}, namespace=""),
    _kind("description", {"level": _COUNT, "type": _TEXT}, parts=[_FILE], namespace=""),
)
_GESTURE = {
    **dict.fromkeys(("lexeme", "type", "style", "emotion"), _TEXT),
    "mode": _HANDS,
    f"{{{SBM}}}style": _TEXT,
    **dict.fromkeys(("prestroke_hold", "poststroke_hold"), _TEXT),
    _JOINTS: _TEXT,
    **dict.fromkeys((f"{{{SBM}}}frequency", f"{{{SBM}}}scale"), _NUMBER),
}
_OWN_SPEECH = {"id": _OWN_ID, "ref": _TEXT, "type": _TEXT}
_LIPS = {"viseme": _NEEDED, "articulation": _NUMBER}
_OWN_BLOCK = _kind(
    "bml",
    {"id": _OWN_ID},
    parts=[
        _kind("speech", _OWN_SPEECH, syncs=ENDS, parts=_SPEECH_PARTS, mixed=True, namespace=""),
        _own("gesture", _GESTURE, syncs=STROKED_SMARTBODY),
        _own("head", {"type": _NEEDED, "repeats": _NUMBER, "amount": _NUMBER}, syncs=STROKED_SMARTBODY),
        _own(
            "gaze",
            {"target": _TEXT, "direction": _TEXT, "angle": _NUMBER, _JOINTS: _TEXT},
            syncs=STROKED_SMARTBODY,
        ),
        _own("face", {"type": _NEEDED, "au": _TEXT, "side": _TEXT, "amount": _NUMBER}, syncs=STROKED_SMARTBODY),
        _own("saccade", {"mode": _TEXT}, syncs=STROKED_SMARTBODY),
        _own("body", {"posture": _NEEDED}, syncs=STROKED_SMARTBODY),
        _own("lips", _LIPS, syncs=REACHED),
    ],
    namespace="",
)
_ACT = _kind(
    "act",
    parts=[_kind("participant", {"id": _NEEDED, "role": _TEXT}, namespace=""), _OWN_BLOCK],
    needs="bml",
    namespace="",
)
SMARTBODY = Dialect(
    DialectName.SMARTBODY, "SmartBody's dialect", MappingProxyType({"act": _ACT, "bml": _OWN_BLOCK}), frozenset()
)

DIALECTS: Mapping[DialectName, Dialect] = MappingProxyType({each.name: each for each in (BML_CORE, SMARTBODY)})
