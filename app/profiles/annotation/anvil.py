"""Reads ANVIL's annotation files (.anvil): XML with a `track` element for each track and an `el` for each span.

The elements of a primary track have times. The elements of a secondary track refer (`ref`) to elements of another track
by number: to the first and the last (`span`), or to one (`singleton`). The label is the `attribute` with the track's
main value (`type`, `lexeme`, `token` …). `value-link`s are numbers of elements of another track, such as a phrase's
affiliate.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from lxml import etree

from .model import AnnotationError, AnnotationMistake
from .tracks import LABELS, Track, TrackSpan, number_of, track_name, track_of, xml_root

_NUMBER = re.compile(r"\d{1,9}", re.ASCII)
_LABEL_NAMES = ("type", "lexeme", "token", "text", "tag", "name", "rest", "phase")
"""The attributes that may be the label if there is none with the name in `LABELS`."""


@dataclass(frozen=True, slots=True)
class _Link:
    """An attribute that refers to elements of another track, from the first to the last."""

    track: str
    first: str
    last: str


def read_anvil(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tracks of a file; raises AnnotationError with every element without a time, and every broken link."""
    reading = _AnvilTracks(path)
    for track in xml_root(content, path, "annotation").iter("track"):
        reading.read(track)
    tracks = tuple(reading.tracks())
    if reading.mistakes:
        raise AnnotationError(reading.mistakes)
    return tracks


class _AnvilTracks:
    """The tracks read so far, their elements by number, and the links of elements, which may refer to later tracks."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._spans: dict[str, dict[int, TrackSpan]] = {}
        self._links: dict[tuple[str, int], Mapping[str, _Link]] = {}
        self._timeless: set[tuple[str, str]] = set()
        self.mistakes: list[AnnotationMistake] = []

    def read(self, track: etree._Element) -> None:
        """Reads the elements of a track, after those of the track it refers to."""
        name, refers = track.get("name", ""), track.get("ref", "")
        spans = self._spans.setdefault(name, {})
        if refers and refers not in self._spans:
            self._wrong(name, None, f"refers to the track {refers!r}, which is not above it")
            return
        for place, element in enumerate(track.iter("el")):
            number = int(number_of(element, "index") or place)
            times = _times(element, track.get("type", "primary"), self._spans.get(refers, {}))
            if times is None:
                message = f"element {number} has no time, or refers to an element that is not there"
                self._wrong(name, element, message)
                self._timeless.add((name, str(number)))
                continue
            said = {each.get("name", "").strip().lower(): _value(each) for each in element.iter("attribute")}
            attributes = {key: value for key, value in said.items() if isinstance(value, str)}
            self._links[name, number] = {key: value for key, value in said.items() if isinstance(value, _Link)}
            spans[number] = TrackSpan(*times, _label(track_name(name), attributes), attributes)

    def tracks(self) -> Iterator[Track]:
        """The tracks, with every link resolved to numbers of words or elements."""
        numbers = {name: dict(_numbers(spans)) for name, spans in self._spans.items()}
        for name, spans in self._spans.items():
            yield track_of(name, [self._linked(name, number, span, numbers) for number, span in spans.items()])

    def _linked(self, name: str, number: int, span: TrackSpan, numbers: Mapping[str, Mapping[int, int]]) -> TrackSpan:
        found = {}
        for attribute, link in self._links[name, number].items():
            known = numbers.get(link.track, {})
            ends = [known.get(int(each)) if _NUMBER.fullmatch(each) else None for each in (link.first, link.last)]
            if {(link.track, link.first), (link.track, link.last)} & self._timeless:
                continue
            if None in ends:
                message = f"{attribute} names elements {link.first} to {link.last} of {link.track!r}: there are no such"
                self.mistakes.append(AnnotationMistake(self._path, message, name, span.start_s))
            else:
                found[attribute] = f"{ends[0]}-{ends[1]}"
        return replace(span, attributes={**span.attributes, **found}) if found else span

    def _wrong(self, track: str, element: etree._Element | None, message: str) -> None:
        where = "" if element is None else f"line {element.sourceline}: "
        self.mistakes.append(AnnotationMistake(self._path, f"{where}{message}", track))


def _times(element: etree._Element, kind: str, referred: Mapping[int, TrackSpan]) -> tuple[float, float] | None:
    start, end = number_of(element, "start"), number_of(element, "end")
    if kind == "singleton":
        start = end = number_of(element, "ref")
    if start is None or end is None:
        return None
    if not kind.startswith("s"):
        return start, end
    if int(start) not in referred or int(end) not in referred:
        return None
    return referred[int(start)].start_s, referred[int(end)].end_s


def _value(attribute: etree._Element) -> str | _Link:
    links = list(attribute.iter("value-link"))
    if not links:
        return (attribute.text or "").strip()
    first, last = (each.get("ref-index", "") for each in (links[0], links[-1]))
    return _Link(links[0].get("ref-track", ""), first, last)


def _numbers(spans: Mapping[int, TrackSpan]) -> Iterator[tuple[int, int]]:
    """Numbers the elements that have a label from 0 in order of time, as words are numbered."""
    labelled = [number for number, span in sorted(spans.items(), key=lambda each: each[1].start_s) if span.label]
    yield from ((number, place) for place, number in enumerate(labelled))


def _label(track: str, attributes: Mapping[str, str]) -> str:
    names = (LABELS.get(track, "label"), *_LABEL_NAMES)
    return next((attributes[name] for name in names if name in attributes), "")
