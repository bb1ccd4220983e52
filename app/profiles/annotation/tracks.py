"""Tracks as every format of annotation has them: named rows of spans, each with a label and perhaps attributes; how the
text of their files is read (its encoding, and XML with the line of each element); and an index of spans by time, so
that an hour of annotation is read in seconds.

Times are seconds. A track `phrases.hand` gives the attribute `hand` of the spans of `phrases`: formats whose spans have
only labels (ELAN, TextGrid) write attributes so, each in the time of its span. Tracks `tags`, `tags_2`, … are one, for
spans that overlap need a row each where a tool draws them.
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

from .mistakes import AnnotationError, AnnotationMistake

Thing = TypeVar("Thing")


@dataclass(frozen=True, slots=True, eq=False)
class InTime(Generic[Thing]):
    """Things in order of their starts; they may overlap. `latest_ends` has for each the latest end up to it."""

    things: tuple[Thing, ...]
    starts: tuple[float, ...]
    ends: tuple[float, ...]
    latest_ends: tuple[float, ...]

    @classmethod
    def of(cls, things: Iterable[Thing], times: Callable[[Thing], tuple[float, float]]) -> "InTime[Thing]":
        """The things; `times` has the start and end of one."""
        timed = sorted(((*times(thing), thing) for thing in things), key=lambda each: each[:2])
        ends = tuple(end for _start, end, _thing in timed)
        starts = tuple(start for start, _end, _thing in timed)
        return cls(tuple(thing for _start, _end, thing in timed), starts, ends, tuple(accumulate(ends, max)))

    def touching(self, start: float, end: float) -> tuple[Thing, ...]:
        """Those that share time with the stretch."""
        first, after = bisect_right(self.latest_ends, start), bisect_left(self.starts, end)
        return tuple(self.things[place] for place in range(first, after) if self.ends[place] > start)

    def within(self, start: float, end: float) -> tuple[Thing, ...]:
        """Those that lie in the stretch."""
        first, after = bisect_left(self.starts, start), bisect_right(self.starts, end)
        return tuple(self.things[place] for place in range(first, after) if self.ends[place] <= end)

    def any_holds(self, start: float, end: float) -> bool:
        """Whether the stretch lies in one of them."""
        begun = bisect_right(self.starts, start)
        return begun > 0 and self.latest_ends[begun - 1] >= end


def decoded(content: bytes, path: Path) -> str:
    """The text without its mark; raises AnnotationError with the place of the first byte that is none."""
    encoding = "utf-16" if content.startswith((BOM_UTF16_BE, BOM_UTF16_LE)) else "utf-8-sig"
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        message = f"line {line}: byte {error.start} is not {encoding.upper().removesuffix('-SIG')}; save it as UTF-8"
        raise AnnotationError([AnnotationMistake(path, message)]) from None


def xml_root(content: bytes, path: Path, expected: str) -> etree._Element:
    """The root of a document, which must be called `expected`, names without their namespaces; raises
    AnnotationError."""
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
    """An attribute as a number; None where it is missing or none."""
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
"""The names that people give to tracks, by ours."""

NEEDED = ("phases", "phrases", "units", "words")
KNOWN = frozenset({*NEEDED, "tags", "segments", "head", "gaze", "posture"})
PHRASE_ATTRIBUTES = frozenset({"lexeme", "hand", "path", "from", "to", "affiliate", "tag"})
"""What a phrase may say of itself beside its time."""
_NUMBERED = re.compile(r"_\d+$")
LABELS: Mapping[str, str] = MappingProxyType(
    {"words": "text", "tags": "tag", "phases": "phase", "phrases": "lexeme", "units": "rest"}
)
"""What the label of a span is, by track, where a format has a name for it."""


@dataclass(frozen=True, slots=True)
class TrackSpan:
    """A stretch of a track."""

    start_s: float
    end_s: float
    label: str
    attributes: Mapping[str, str] = field(default_factory=dict)

    @property
    def middle_s(self) -> float:
        return (self.start_s + self.end_s) / 2


@dataclass(frozen=True, slots=True)
class Track:
    """A row of spans, in order of time."""

    name: str
    spans: tuple[TrackSpan, ...]


def track_name(name: str) -> str:
    """Our name for a track: without what stands before (`gesture.phrase`), but for the attributes of phrases."""
    parts = [_NUMBERED.sub("", part) for part in name.strip().lower().replace(" ", "_").split(".")]
    if len(parts) > 1 and parts[-1] in PHRASE_ATTRIBUTES:
        return f"{TRACK_NAMES.get(parts[-2], parts[-2])}.{parts[-1]}"
    return TRACK_NAMES.get(parts[-1], parts[-1])


def track_of(name: str, spans: Iterable[TrackSpan]) -> Track:
    """The track by our name, its spans in order of time."""
    return Track(track_name(name), tuple(sorted(spans, key=lambda span: (span.start_s, span.end_s))))


def rows_of(track: Track) -> Iterator[Track]:
    """The track as rows in which no span overlaps another: `tags`, `tags_2`, …"""
    rest, number = track.spans, 1
    while rest or number == 1:
        row: list[TrackSpan] = []
        over: list[TrackSpan] = []
        for span in rest:
            (over if row and span.start_s < row[-1].end_s else row).append(span)
        yield Track(track.name if number == 1 else f"{track.name}_{number}", tuple(row))
        rest, number = tuple(over), number + 1


def merged(tracks: Iterable[Track]) -> Iterator[Track]:
    """The tracks, those of one name in one."""
    by_name: dict[str, list[TrackSpan]] = {}
    for track in tracks:
        by_name.setdefault(track.name, []).extend(track.spans)
    yield from (track_of(name, spans) for name, spans in by_name.items())


def with_attribute_tracks(tracks: Iterable[Track]) -> Iterator[Track]:
    """The tracks, attributes of spans as tracks of their own: the converse of `with_attributes`."""
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
    """The tracks, each span with the attributes that tracks of attributes say in its time."""
    tracks = tuple(merged(tracks))
    for track in tracks:
        if "." not in track.name:
            own = [(name, _by_middle(each)) for name, each in _attribute_tracks(track, tracks)]
            yield replace(track, spans=tuple(_attributed(span, own) for span in track.spans))


def stray_attributes(tracks: Iterable[Track]) -> Iterator[tuple[Track, TrackSpan]]:
    """The spans of tracks of attributes in whose time there is nothing to have the attribute."""
    tracks = tuple(merged(tracks))
    for track in tracks:
        spans = InTime.of(track.spans, lambda span: (span.start_s, span.end_s))
        for _name, each in _attribute_tracks(track, tracks):
            yield from ((each, span) for span in each.spans if not spans.any_holds(span.middle_s, span.middle_s))


def _attribute_tracks(track: Track, tracks: Iterable[Track]) -> Iterator[tuple[str, Track]]:
    """The tracks of a track's attributes, by the name of the attribute."""
    for each in tracks:
        if each.name.startswith(f"{track.name}."):
            yield each.name.rpartition(".")[2], each


def _by_middle(track: Track) -> InTime[TrackSpan]:
    return InTime.of((span for span in track.spans if span.label), lambda span: (span.middle_s, span.middle_s))


def _attributed(span: TrackSpan, tracks: Iterable[tuple[str, InTime[TrackSpan]]]) -> TrackSpan:
    found = {name: each.label for name, track in tracks for each in track.within(span.start_s, span.end_s)}
    return replace(span, attributes={**span.attributes, **found}) if found else span
