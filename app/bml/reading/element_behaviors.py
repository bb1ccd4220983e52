"""Converts BML elements to behaviours, the inverse of `understudy.bml.writing.blocks` and
`understudy.bml.writing.smartbody`.

What core BML cannot express is unknown, such as a gesture's size and priority. Faces without a lexeme of ours have
their FACS action unit as lexeme, `AU12`, and the side as `direction`.

Others' names of head movements and faces, by the nearest lexeme of ours, from `lexicon/bml_aliases.yaml`.

Gestures are named to the realizer as the document has them, whose library knows their aliases.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from types import MappingProxyType

from ...authored_folders import lexicon_folder
from ...errors import AuthoringError, Mistake
from ...model import Behavior, Channel, Hand, SyncPoints
from ...model.tables import ACTION_UNITS, GLANCE, LOOK, SHIFT
from ...yaml_files import Entry, Source
from ..markup.documents import Element
from ..markup.elements import SBM
from ..writing.blocks import GAZE_RANGE_DEGREES, MODES
from ..writing.smartbody_tables import shipped_tables

_HANDS: Mapping[str, Hand] = MappingProxyType({mode: hand for hand, mode in MODES.items()})
_WORDS_OF_UNITS: Mapping[int, str] = MappingProxyType({unit: lexeme for lexeme, unit in ACTION_UNITS.items()})
_EYES_ALONE = "EYES"
_BLINK = 45
_UNIT = re.compile(r"(?P<unit>\d{1,9})(_(?P<side>[A-Za-z]+))?", re.ASCII)
_PRIORITY_STEP = 10
_USUAL_HEAD = 0.5
_KINDS = frozenset({"BEAT", "DEICTIC", "EMBLEM", "ICONIC", "METAPHORIC"})
"""The kinds of gestures (McNeill 1992), of which one or another document has a gesture's `type`."""

SHIFTS = frozenset({"gazeShift", "headDirectionShift", "postureShift", "body"})
"""Elements that end when a new state is reached, which then lasts."""


def to_behavior(element: Element, name: str, sync: SyncPoints) -> Behavior | None:
    """The behaviour of an element, with the id `name`; None if it is not a body movement."""
    make = _MAKERS.get(element.name)
    return None if make is None else make(element, _blank(element, name, sync))


Making = Callable[[Element, Behavior], Behavior | None]
"""Completes the behaviour from the element; None if its content is unknown."""


def _blank(element: Element, name: str, sync: SyncPoints) -> Behavior:
    priority = element.attributes.get("priority")
    return Behavior(
        id=name,
        kind=Channel.GESTURE,
        lexeme="",
        sync=sync,
        first=0,
        last=0,
        priority=priority / _PRIORITY_STEP if isinstance(priority, int) else 0.0,
        hand=_HANDS.get(_text(element, "mode") or ""),
    )


def _gesture(element: Element, blank: Behavior) -> Behavior | None:
    """SmartBody's `type` is the gesture and its `lexeme` the kind of it (`lexeme="DEICTIC" type="ME"`), unless only the
    `lexeme` is known, or is the gesture and the `type` the kind."""
    lexeme, named = _text(element, "lexeme"), _text(element, "type")
    known = shipped_tables().knows
    is_gesture = named not in _KINDS and (known(named) or not known(lexeme))
    found = (named if is_gesture else lexeme) or lexeme or named
    return replace(blank, lexeme=found) if found else None


def passed_over(element: Element, behavior: Behavior) -> str | None:
    """The `type` of a gesture that is played as its `lexeme` says, because nobody knows the type."""
    named = _text(element, "type") if behavior.kind is Channel.GESTURE else None
    return named if named not in {None, behavior.lexeme, *_KINDS} else None


def _pointing(element: Element, blank: Behavior) -> Behavior:
    return replace(blank, lexeme="POINT", target=_text(element, "target"))


def _head(element: Element, blank: Behavior) -> Behavior | None:
    lexeme = _text(element, "lexeme") or _text(element, "type")
    if lexeme is None:
        return None
    often = _number(element, "repetition") or _number(element, "repeats")
    amount = _number(element, "amount")
    return replace(
        blank,
        kind=Channel.HEAD,
        lexeme=shipped_aliases().head(lexeme),
        amount=_USUAL_HEAD if amount is None else amount,
        repetitions=None if often is None else max(1, round(often)),
    )


def _gaze(element: Element, blank: Behavior, *, shifts: bool = False) -> Behavior:
    joints = _text(element, "influence") or _text(element, f"{{{SBM}}}joint-range")
    direction = _text(element, "offsetDirection") or _text(element, "direction")
    angle = _number(element, "offsetAngle") or _number(element, "angle")
    aside = direction is not None and angle is not None
    return replace(
        blank,
        kind=Channel.GAZE,
        lexeme=GLANCE if joints == _EYES_ALONE and not shifts else SHIFT if shifts else LOOK,
        target=_text(element, "target"),
        direction=direction if aside else None,
        amount=round(min(1.0, abs(angle) / GAZE_RANGE_DEGREES), 3) if aside and angle is not None else None,
    )


def _face(element: Element, blank: Behavior) -> Behavior | None:
    """`faceLexeme`, `faceFacs` and SmartBody's `face`, whose unit may name its side: `au="1_left"`."""
    amount = _number(element, "amount")
    face = replace(blank, kind=Channel.FACE, amount=1.0 if amount is None else amount)
    lexeme = _text(element, "lexeme")
    if lexeme:
        return replace(face, lexeme=shipped_aliases().face(lexeme))
    found = _UNIT.fullmatch(str(element.attributes.get("au", "")))
    if found is None:
        return None
    unit, side = found["unit"], (found["side"] or _text(element, "side") or "BOTH").upper()
    word = _WORDS_OF_UNITS.get(int(unit)) if side == "BOTH" else None
    kind = Channel.EYES if int(unit) == _BLINK else Channel.FACE
    return replace(face, kind=kind, lexeme=word or f"AU{int(unit)}", direction=None if side == "BOTH" else side)


def _posture(element: Element, blank: Behavior) -> Behavior | None:
    poses = (_text(part, "lexeme") for part in element.children if part.name == "pose")
    lexeme = _text(element, "posture") or next(poses, None)
    return replace(blank, kind=Channel.POSTURE, lexeme=lexeme) if lexeme else None


def _text(element: Element, name: str) -> str | None:
    found = element.attributes.get(name)
    return found if isinstance(found, str) and found else None


def _number(element: Element, name: str) -> float | None:
    found = element.attributes.get(name)
    return float(found) if isinstance(found, int | float) else None


FILE = "bml_aliases.yaml"

_NOT_IN_NAMES = re.compile(r"[^A-Z0-9]+")


class AliasFile(Entry):
    """The file's schema: for each lexeme of ours, the other names."""

    heads: dict[str, list[str]]
    faces: dict[str, list[str]]


@dataclass(frozen=True, slots=True)
class LexemeAliases:
    """Our lexeme by every name that has one, its own among them."""

    heads: Mapping[str, str]
    faces: Mapping[str, str]

    @classmethod
    def load(cls, path: Path) -> "LexemeAliases":
        """The aliases of a file. Raises AuthoringError for names that stand twice."""
        source = Source(path)
        written = source.validated(AliasFile)
        parts = {"heads": written.heads, "faces": written.faces}
        mistakes = tuple(each for part, names in parts.items() for each in _mistakes(source, part, names))
        if mistakes:
            raise AuthoringError(mistakes)
        return cls(*(MappingProxyType(_by_name(names)) for names in parts.values()))

    def head(self, lexeme: str) -> str:
        """The lexeme of a head movement, unchanged where nothing is known of it."""
        return self.heads.get(_spelt(lexeme), lexeme)

    def face(self, lexeme: str) -> str:
        """The lexeme of a face, unchanged where nothing is known of it."""
        return self.faces.get(_spelt(lexeme), lexeme)


@cache
def shipped_aliases() -> LexemeAliases:
    """The aliases in the package."""
    return LexemeAliases.load(lexicon_folder() / FILE)


def _by_name(names: Mapping[str, list[str]]) -> dict[str, str]:
    return {name: lexeme for lexeme, others in names.items() for name in (lexeme, *others)}


def _mistakes(source: Source, part: str, names: Mapping[str, list[str]]) -> Iterator[Mistake]:
    seen = set(names)
    for lexeme, others in names.items():
        for position, name in enumerate(others):
            where = (part, lexeme, position)
            if _spelt(name) != name:
                yield source.mistake(where, f"{name!r}: names are written in capitals, words joined by one underscore")
            elif name in seen:
                yield source.mistake(where, f"{name} is listed already")
            seen.add(name)


def _spelt(name: str) -> str:
    return _NOT_IN_NAMES.sub("_", name.upper()).strip("_")


_MAKERS: Mapping[str, Making] = MappingProxyType(
    {
        "gesture": _gesture,
        "pointing": _pointing,
        "head": _head,
        "gaze": _gaze,
        "gazeShift": partial(_gaze, shifts=True),
        "headDirectionShift": partial(_gaze, shifts=True),
        "faceLexeme": _face,
        "faceFacs": _face,
        "face": _face,
        "posture": _posture,
        "postureShift": _posture,
        "body": _posture,
    }
)
