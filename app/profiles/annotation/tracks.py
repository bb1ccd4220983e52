"""Tracks as every format of annotation has them: named rows of spans, each with a label and perhaps attributes.

Times are seconds. A track `phrases.hand` gives the attribute `hand` of the spans of `phrases`: formats whose spans have
only labels (ELAN, TextGrid) write attributes so, each in the time of its span. Tracks `tags`, `tags_2`, … are one, for
spans that overlap need a row each where a tool draws them.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from .in_time import InTime

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
