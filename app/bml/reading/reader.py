"""Reads BML 1.0 core or SmartBody's dialect, identified by the root, from XML, with the place of every mistake.

In the core, every name in its namespaces must be known. Elements and attributes of other namespaces are extensions,
which are kept and reported; in SmartBody's dialect, which has many more names than we know, this holds for all unknown
names. White space between elements is ignored, runs of it in attributes count as one space. The content of a
`description` is not checked.

In a file of ours the other sync points move along with those moved by hand. The record has the durations of each
behaviour's phases as scheduled (`understudy.bml.writing.blocks`). Points that no longer agree with most of the others
were moved. If that is a point up to the end of the stroke, the whole behaviour moves by as much, because strokes are
never stretched; if it is `relax`, which lengthens or shortens a hold, `end` moves too; `end` moves alone. Points that
were moved stay where they were put. Points at 0 that are written a moment later (`FIRST_MOMENT_S`) were not moved.
"""

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import accumulate, islice
from pathlib import Path

from ...errors import Mistake, TooLargeError, WrongBmlError
from ...model import Notice
from ..markup.documents import Document, Element, Reference, TagPosition, Time, Value
from ..markup.elements import DIALECTS, OURS, SBM, Dialect, ElementKind
from ..markup.mistakes import is_foreign, kind_of, local_name, mistakes_of, typed_attributes
from ..markup.parsing import NotXmlError, ParsedDocument, ReadingLimits, parse
from ..markup.speech import FIRST_MOMENT_S
from ..markup.values import text_of
from .greta import in_core_bml

_FIRST_COUNTS = ("stroke", "strokeEnd", "strokeStart", "attackPeak", "ready", "start", "relax")
"""If several points were moved, the first of these determines how the others move."""
_BLOCKS = ("bml", "required")
_FEWEST = 3
"""With only two points it cannot be decided which was moved."""


@dataclass(frozen=True, slots=True)
class _Move:
    """A behaviour's points, of which `point` was moved by hand, `later_s` later than scheduled; `points` have new
    values as text, by name."""

    behavior: str
    point: str
    later_s: float
    points: Mapping[str, str]

    @property
    def notice(self) -> Notice:
        which = "later" if self.later_s > 0 else "earlier"
        message = f"{self.behavior}: its {self.point} is {abs(self.later_s):.3f} s {which} than scheduled"
        return Notice("bml_point_moved", f"{message}; dependent behaviours move with it")


def with_following_points(root: Element, kind: ElementKind) -> tuple[Element, tuple[Notice, ...]]:
    """The file with the other points adjusted, and a notice for each behaviour of which one was moved."""
    moves = {move.behavior: move for move in _moves(root, kind, dict(_phases_s(root)))}
    notices = tuple(move.notice for move in moves.values())
    return _moved(root, moves) if moves else root, notices


def _moved(element: Element, moves: Mapping[str, _Move]) -> Element:
    content = tuple(part if isinstance(part, str) else _moved(part, moves) for part in element.content)
    move = moves.get(str(element.attributes.get("id")))
    return replace(element, content=content, attributes={**element.attributes, **(move.points if move else {})})


def _phases_s(element: Element) -> Iterator[tuple[str, tuple[float, ...]]]:
    """The durations of phases in the records of a file, by behaviour; what is not a number is reported elsewhere."""
    for part in element.children:
        if part.name == f"{{{OURS}}}behavior":
            lengths = str(part.attributes.get("phases", "")).split()
            if lengths and all(length.replace(".", "", 1).isdecimal() for length in lengths):
                yield str(part.attributes.get("ref")), tuple(map(float, lengths))
        else:
            yield from _phases_s(part)


def _moves(element: Element, kind: ElementKind, phases_s: Mapping[str, tuple[float, ...]]) -> Iterator[_Move]:
    for part in element.children:
        inside, name = kind_of(part, kind), str(part.attributes.get("id"))
        if inside and inside.name in _BLOCKS:
            yield from _moves(part, inside, phases_s)
        elif inside and name in phases_s:
            move = _move(name, _stated(part, inside), phases_s[name])
            if move:
                yield move


def _stated(element: Element, kind: ElementKind) -> dict[str, Time]:
    """The sync points given in the element, in order."""
    values = typed_attributes(element, kind)
    points = ((name, values.get(name)) for name in kind.syncs)
    return {name: time for name, time in points if isinstance(time, float | Reference)}


def _move(behavior: str, stated: Mapping[str, Time], phases_s: tuple[float, ...]) -> _Move | None:
    """The move of a behaviour all of whose points are given, relative to the same point; None if nothing moves."""
    anchors = {replace(time, offset_s=0.0) if isinstance(time, Reference) else None for time in stated.values()}
    if len(stated) != len(phases_s) + 1 or len(stated) < _FEWEST or len(anchors) != 1:
        return None
    times_s = {name: time.offset_s if isinstance(time, Reference) else float(time) for name, time in stated.items()}
    late_s = _late_s(times_s, phases_s, moment_s=0.0 if None in anchors else FIRST_MOMENT_S)
    point = next((name for name in _FIRST_COUNTS if late_s.get(name)), None)
    if point is None:
        return None
    (anchor,) = anchors
    follow = {"end"} if point == "relax" else late_s.keys()
    points = {
        name: _text(times_s[name] + late_s[point], anchor) for name in late_s if name in follow and not late_s[name]
    }
    return _Move(behavior, point, late_s[point], points)


def _late_s(times_s: Mapping[str, float], phases_s: tuple[float, ...], *, moment_s: float) -> dict[str, float]:
    """How much later than scheduled each point is, relative to most of them; first points that are `moment_s` later
    than others are not."""
    scheduled_s = accumulate(phases_s, initial=0.0)
    apart_s = {name: round(time_s - at_s, 3) for (name, time_s), at_s in zip(times_s.items(), scheduled_s, strict=True)}
    first_s = next(iter(apart_s.values()))
    written_s = round(first_s - moment_s, 3)
    if written_s in apart_s.values():
        apart_s = {name: written_s if each_s == first_s else each_s for name, each_s in apart_s.items()}
    usual_s = Counter(apart_s.values()).most_common(1)[0][0]
    return {name: round(each_s - usual_s, 3) for name, each_s in apart_s.items()}


def _text(time_s: float, anchor: Reference | None) -> str:
    """The time as text; times are not negative if they are absolute."""
    rounded_s = round(time_s, 3) + 0.0
    return text_of(max(0.0, rounded_s) if anchor is None else replace(anchor, offset_s=rounded_s))


MOST_MISTAKES = 100
"""The maximum number of reported mistakes, and of foreign names, per file."""

_MOST_IN_MESSAGE = 5
_XML_LINE_END = re.compile(r"\r\n?|\n")
_DEFAULT_LIMITS = ReadingLimits()


def read_bml(
    content: bytes, path: Path, limits: ReadingLimits = _DEFAULT_LIMITS
) -> tuple[Document, tuple[Notice, ...]]:
    """The document, and Notices: `bml_point_moved` for every behaviour of ours of which a point was moved by hand,
    `bml_foreign` for every name that is not in its dialect, `bml_namespace` where a prefix was bound, and what was
    changed to read Greta's.

    `path` names the file in messages. Raises WrongBmlError `bml_wrong` with all mistakes, and TooLargeError
    `bml_too_large`.
    """
    parsed = _parsed(content, path, limits)
    root, translated = in_core_bml(parsed.root)
    found = _dialect_of(root)
    if found is None:
        message = f"the root element is <{root.name[:100]}>; write <bml> of BML 1.0, or SmartBody's <act>"
        raise _wrong_bml(content, path, [(root.place or TagPosition(1, 1), message)])
    dialect, kind = found
    root, moves = with_following_points(root, kind)
    mistakes = list(islice(mistakes_of(root, kind, dialect), MOST_MISTAKES))
    if mistakes:
        raise _wrong_bml(content, path, mistakes)
    notices = (*translated, *_bound(parsed), *moves, *_foreign(root, kind, dialect))
    return Document(dialect.name, _element(root, kind)), notices


def _parsed(content: bytes, path: Path, limits: ReadingLimits) -> ParsedDocument:
    if len(content) > limits.max_bytes:
        message = f"{path}: {len(content)} bytes of BML; no more than {limits.max_bytes} are read"
        raise TooLargeError("bml_too_large", message, field="bml")
    try:
        return parse(content, limits)
    except NotXmlError as error:
        raise _wrong_bml(content, path, [(error.place, error.message)]) from None


def _bound(parsed: ParsedDocument) -> Iterator[Notice]:
    if parsed.is_bound:
        message = f'sbm: is not declared; it is taken as SmartBody\'s: write xmlns:sbm="{SBM}" in the root element'
        yield Notice("bml_namespace", message)


def _dialect_of(root: Element) -> tuple[Dialect, ElementKind] | None:
    kinds = ((dialect, dialect.roots.get(local_name(root.name))) for dialect in DIALECTS.values())
    return next(((dialect, kind) for dialect, kind in kinds if kind and kind.qualified == root.name), None)


def _element(element: Element, kind: ElementKind | None) -> Element:
    """The element with typed attribute values and its name in the table."""
    if kind is None or kind.free:
        parts = tuple(
            part if isinstance(part, str) else _element(part, kind_of(part, kind) if kind else None)
            for part in element.content
        )
    else:
        parts = tuple(_content(element, kind))
    if kind is None:
        return Element(element.name, _single_spaced(element.attributes), parts, element.place)
    attributes = typed_attributes(element, kind)
    others = {name: text for name, text in element.attributes.items() if name not in kind.attributes}
    return Element(kind.name, attributes | _single_spaced(others), parts, element.place)


def _content(element: Element, kind: ElementKind) -> Iterator[Element | str]:
    speaks = any(isinstance(part, str) and part.strip() for part in element.content)
    for part in element.content:
        if isinstance(part, Element):
            yield _element(part, kind_of(part, kind))
        elif speaks:
            yield part


def _single_spaced(attributes: Mapping[str, Value]) -> dict[str, Value]:
    return {name: " ".join(str(text).split()) for name, text in attributes.items()}


def _foreign(root: Element, kind: ElementKind, dialect: Dialect) -> tuple[Notice, ...]:
    """A notice for each foreign name, with the line of its first occurrence."""
    met = list(_foreign_names(root, kind, dialect))
    counts = Counter(name for name, _ in met)
    lines = {name: place.line for name, place in reversed(met)}
    return tuple(
        Notice(
            "bml_foreign",
            f"{name} (line {lines[name]}, {count} in all) is not part of {dialect.title}; it is kept unchanged",
        )
        for name, count in counts.most_common(MOST_MISTAKES)
    )


def _foreign_names(element: Element, kind: ElementKind, dialect: Dialect) -> Iterator[tuple[str, TagPosition]]:
    place = element.place or TagPosition(1, 1)
    for name in element.attributes:
        if name not in kind.attributes and is_foreign(name, dialect):
            yield f"the attribute {name}", place
    for name, attribute in kind.attributes.items():
        if attribute.one_of and name in element.attributes and element.attributes[name] not in attribute.one_of:
            yield f"{name}={element.attributes[name]!r}", place
    if kind.free:
        return
    for part in element.children:
        inside = kind_of(part, kind)
        if inside:
            yield from _foreign_names(part, inside, dialect)
        elif not part.name.startswith(f"{{{OURS}}}"):
            yield f"<{part.name}>", part.place or place


def _wrong_bml(content: bytes, path: Path, found: list[tuple[TagPosition, str]]) -> WrongBmlError:
    lines = _XML_LINE_END.split(content.decode(errors="replace"))
    mistakes = tuple(
        Mistake(path, place.line, place.column, message, lines[place.line - 1].replace("\t", " "))
        for place, message in found
    )
    listed = "; ".join(f"line {mistake.line}: {mistake.message}" for mistake in mistakes[:_MOST_IN_MESSAGE])
    more = f"; and {len(mistakes) - _MOST_IN_MESSAGE} more" if len(mistakes) > _MOST_IN_MESSAGE else ""
    return WrongBmlError("bml_wrong", f"{path}: {listed}{more}", mistakes=mistakes)
