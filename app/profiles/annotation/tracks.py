"""Annotation tracks, common to all formats: named sequences of spans with a label and optional attributes. Also decodes
the text of annotation files, parses XML with line numbers, and indexes spans by time, so that an hour of annotation is
read in seconds.

Times are seconds. A track `phrases.hand` contains the attribute `hand` of the spans of `phrases` at the same times;
formats whose spans have only labels (ELAN, TextGrid) store attributes this way. Tracks `tags`, `tags_2`, … are merged,
since annotation tools need separate rows for overlapping spans.
"""

import re
from bisect import bisect_left, bisect_right
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import accumulate
from math import isfinite
from pathlib import Path
from types import MappingProxyType
from typing import Generic, TypeVar

from lxml import etree

from .model import AnnotationError, AnnotationMistake

Thing = TypeVar("Thing")


@dataclass(frozen=True, slots=True, eq=False)
class InTime(Generic[Thing]):
    """An index of intervals, which may overlap, ordered by start. `latest_ends` is the running maximum of the ends."""

    things: tuple[Thing, ...]
    starts: tuple[float, ...]
    ends: tuple[float, ...]
    latest_ends: tuple[float, ...]

    @classmethod
    def of(cls, things: Iterable[Thing], times: Callable[[Thing], tuple[float, float]]) -> "InTime[Thing]":
        """An index of these items; `times` returns the start and end of an item."""
        timed = sorted(((*times(thing), thing) for thing in things), key=lambda each: each[:2])
        ends = tuple(end for _start, end, _thing in timed)
        starts = tuple(start for start, _end, _thing in timed)
        return cls(tuple(thing for _start, _end, thing in timed), starts, ends, tuple(accumulate(ends, max)))

    def touching(self, start: float, end: float) -> tuple[Thing, ...]:
        """The items that overlap the interval."""
        first, after = bisect_right(self.latest_ends, start), bisect_left(self.starts, end)
        return tuple(self.things[place] for place in range(first, after) if self.ends[place] > start)

    def within(self, start: float, end: float) -> tuple[Thing, ...]:
        """The items within the interval."""
        first, after = bisect_left(self.starts, start), bisect_right(self.starts, end)
        return tuple(self.things[place] for place in range(first, after) if self.ends[place] <= end)

    def any_holds(self, start: float, end: float) -> bool:
        """Whether the interval lies within one of the items."""
        begun = bisect_right(self.starts, start)
        return begun > 0 and self.latest_ends[begun - 1] >= end


def decoded(content: bytes, path: Path) -> str:
    """The text without its byte order mark; raises AnnotationError with the position of the first invalid byte."""
    encoding = "utf-16" if content.startswith((BOM_UTF16_BE, BOM_UTF16_LE)) else "utf-8-sig"
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        message = f"line {line}: byte {error.start} is not {encoding.upper().removesuffix('-SIG')}; save it as UTF-8"
        raise AnnotationError([AnnotationMistake(path, message)]) from None


def xml_root(content: bytes, path: Path, expected: str) -> etree._Element:
    """The root of a document, which must be an element `expected`; namespaces are removed. Raises AnnotationError."""
    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
    try:
        root = etree.fromstring(content, parser)
    except etree.XMLSyntaxError as error:
        raise AnnotationError([AnnotationMistake(path, f"not XML: {error.msg}")]) from None
    for element in root.iter("{*}*"):
        element.tag = etree.QName(element).localname
    if root.tag != expected:
        raise AnnotationError([AnnotationMistake(path, f"the document is <{root.tag}>; <{expected}> is expected")])
    return root


def number_of(element: etree._Element, name: str) -> float | None:
    """An attribute as a number; None if it is missing or not a number."""
    try:
        number = float(element.get(name, ""))
    except ValueError:
        return None
    return number if isfinite(number) else None


TRACK_NAMES: Mapping[str, str] = MappingProxyType(
    {
        "word": "words",
        "speech": "words",
        "transcription": "words",
        "tag": "tags",
        "function": "tags",
        "functions": "tags",
        "segment": "segments",
        "utterance": "segments",
        "utterances": "segments",
        "phase": "phases",
        "g-phase": "phases",
        "phrase": "phrases",
        "g-phrase": "phrases",
        "unit": "units",
        "g-unit": "units",
        "postures": "posture",
        "heads": "head",
    }
)
"""Our name of a track by common names of it."""

NEEDED = ("phases", "phrases", "units", "words")
KNOWN = frozenset({*NEEDED, "tags", "segments", "head", "gaze", "posture"})
PHRASE_ATTRIBUTES = frozenset({"lexeme", "hand", "path", "from", "to", "affiliate", "tag"})
"""The attributes of a phrase."""
_NUMBERED = re.compile(r"_\d+$")
LABELS: Mapping[str, str] = MappingProxyType(
    {"words": "text", "tags": "tag", "phases": "phase", "phrases": "lexeme", "units": "rest"}
)
"""The name of a span's label by track, for formats that name labels."""


@dataclass(frozen=True, slots=True)
class TrackSpan:
    """An interval of a track, with its label and attributes."""

    start_s: float
    end_s: float
    label: str
    attributes: Mapping[str, str] = field(default_factory=dict)

    @property
    def middle_s(self) -> float:
        return (self.start_s + self.end_s) / 2


@dataclass(frozen=True, slots=True)
class Track:
    """A sequence of spans, in order of time."""

    name: str
    spans: tuple[TrackSpan, ...]


def track_name(name: str) -> str:
    """Our name for a track: without a prefix (`gesture.phrase`), except for tracks of phrase attributes."""
    parts = [_NUMBERED.sub("", part) for part in name.strip().lower().replace(" ", "_").split(".")]
    if len(parts) > 1 and parts[-1] in PHRASE_ATTRIBUTES:
        return f"{TRACK_NAMES.get(parts[-2], parts[-2])}.{parts[-1]}"
    return TRACK_NAMES.get(parts[-1], parts[-1])


def track_of(name: str, spans: Iterable[TrackSpan]) -> Track:
    """The track under our name, with its spans in order of time."""
    return Track(track_name(name), tuple(sorted(spans, key=lambda span: (span.start_s, span.end_s))))


def rows_of(track: Track) -> Iterator[Track]:
    """The track split into rows without overlapping spans: `tags`, `tags_2`, …"""
    rest, number = track.spans, 1
    while rest or number == 1:
        row: list[TrackSpan] = []
        over: list[TrackSpan] = []
        for span in rest:
            (over if row and span.start_s < row[-1].end_s else row).append(span)
        yield Track(track.name if number == 1 else f"{track.name}_{number}", tuple(row))
        rest, number = tuple(over), number + 1


def merged(tracks: Iterable[Track]) -> Iterator[Track]:
    """The tracks; tracks of the same name are merged."""
    by_name: dict[str, list[TrackSpan]] = {}
    for track in tracks:
        by_name.setdefault(track.name, []).extend(track.spans)
    yield from (track_of(name, spans) for name, spans in by_name.items())


def with_attribute_tracks(tracks: Iterable[Track]) -> Iterator[Track]:
    """The tracks, with attributes of spans as separate tracks: the inverse of `with_attributes`."""
    for track in tracks:
        yield replace(track, spans=tuple(replace(span, attributes={}) for span in track.spans))
        names = dict.fromkeys(name for span in track.spans for name in span.attributes)
        for name in names:
            said = (span for span in track.spans if name in span.attributes)
            yield Track(
                f"{track.name}.{name}",
                tuple(replace(span, label=span.attributes[name], attributes={}) for span in said),
            )


def with_attributes(tracks: Iterable[Track]) -> Iterator[Track]:
    """The tracks, with the labels of attribute tracks as attributes of the spans at the same time."""
    tracks = tuple(merged(tracks))
    for track in tracks:
        if "." not in track.name:
            own = [(name, _by_middle(each)) for name, each in _attribute_tracks(track, tracks)]
            yield replace(track, spans=tuple(_attributed(span, own) for span in track.spans))


def stray_attributes(tracks: Iterable[Track]) -> Iterator[tuple[Track, TrackSpan]]:
    """The spans of attribute tracks at whose time there is no span to have the attribute."""
    tracks = tuple(merged(tracks))
    for track in tracks:
        spans = InTime.of(track.spans, lambda span: (span.start_s, span.end_s))
        for _name, each in _attribute_tracks(track, tracks):
            yield from ((each, span) for span in each.spans if not spans.any_holds(span.middle_s, span.middle_s))


def _attribute_tracks(track: Track, tracks: Iterable[Track]) -> Iterator[tuple[str, Track]]:
    """The attribute tracks of a track, by the name of the attribute."""
    for each in tracks:
        if each.name.startswith(f"{track.name}."):
            yield each.name.rpartition(".")[2], each


def _by_middle(track: Track) -> InTime[TrackSpan]:
    return InTime.of((span for span in track.spans if span.label), lambda span: (span.middle_s, span.middle_s))


def _attributed(span: TrackSpan, tracks: Iterable[tuple[str, InTime[TrackSpan]]]) -> TrackSpan:
    found = {name: each.label for name, track in tracks for each in track.within(span.start_s, span.end_s)}
    return replace(span, attributes={**span.attributes, **found}) if found else span
