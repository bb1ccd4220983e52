"""Reads ANVIL's annotation files (.anvil): XML with a `track` a row and an `el` a span.

An element of a primary track has times; one of a track on another (`ref`) has the numbers of that track's elements,
the first and the last (`span`), or one (`singleton`). An `attribute` with the track's own value (`type`, `lexeme`,
`token` …) is the label; `value-link`s are numbers of elements of another track, such as a phrase's affiliate.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from lxml import etree

from .mistakes import AnnotationError, AnnotationMistake
from .tracks import LABELS, Track, TrackSpan, number_of, track_name, track_of, xml_root

_NUMBER = re.compile(r"\d{1,9}", re.ASCII)
_LABEL_NAMES = ("type", "lexeme", "token", "text", "tag", "name", "rest", "phase")
"""The attribute that is the label, where it is not called as `LABELS` says."""


@dataclass(frozen=True, slots=True)
class _Link:
    """An attribute that names elements of another track, from the first to the last."""

    track: str
    first: str
    last: str


def read_anvil(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tracks of a file; raises AnnotationError with every element that has no time, or links to nothing."""
    reading = _AnvilTracks(path)
    for track in xml_root(content, path, "annotation").iter("track"):
        reading.read(track)
    tracks = tuple(reading.tracks())
    if reading.mistakes:
        raise AnnotationError(reading.mistakes)
    return tracks


class _AnvilTracks:
    """The tracks so far, their elements by number, and the links of elements, which may name tracks that follow."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._spans: dict[str, dict[int, TrackSpan]] = {}
        self._links: dict[tuple[str, int], Mapping[str, _Link]] = {}
        self._timeless: set[tuple[str, str]] = set()
        self.mistakes: list[AnnotationMistake] = []

    def read(self, track: etree._Element) -> None:
        """Keeps the elements of a track, after those that it refers to."""
        name, refers = track.get("name", ""), track.get("ref", "")
        spans = self._spans.setdefault(name, {})
        if refers and refers not in self._spans:
            self._wrong(name, None, f"refers to the track {refers!r}, which is not above it")
            return
        for place, element in enumerate(track.iter("el")):
            number = int(number_of(element, "index") or place)
            times = _times(element, track.get("type", "primary"), self._spans.get(refers, {}))
            if times is None:
                told = f"element {number} has no time, or refers to an element that is not there"
                self._wrong(name, element, told)
                self._timeless.add((name, str(number)))
                continue
            said = {each.get("name", "").strip().lower(): _value(each) for each in element.iter("attribute")}
            attributes = {key: value for key, value in said.items() if isinstance(value, str)}
            self._links[name, number] = {key: value for key, value in said.items() if isinstance(value, _Link)}
            spans[number] = TrackSpan(*times, _label(track_name(name), attributes), attributes)

    def tracks(self) -> Iterator[Track]:
        """What was read, every link as the numbers of what it names."""
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
                told = f"{attribute} names elements {link.first} to {link.last} of {link.track!r}: there are no such"
                self.mistakes.append(AnnotationMistake(self._path, told, name, span.start_s))
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
    """The numbers from 0, in order of time, of the elements that have a label, as words have them."""
    labelled = [number for number, span in sorted(spans.items(), key=lambda each: each[1].start_s) if span.label]
    yield from ((number, place) for place, number in enumerate(labelled))


def _label(track: str, attributes: Mapping[str, str]) -> str:
    names = (LABELS.get(track, "label"), *_LABEL_NAMES)
    return next((attributes[name] for name in names if name in attributes), "")
