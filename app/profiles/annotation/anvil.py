"""Reads ANVIL's annotation files (.anvil): XML with a `track` a row and an `el` a span.

An element of a primary track has times; one of a track on another (`ref`) has the numbers of that track's elements,
the first and the last (`span`), or one (`singleton`). An `attribute` with the track's own value (`type`, `lexeme`,
`token` …) is the label; `value-link`s are numbers of elements of another track, such as a phrase's affiliate.
"""

from collections.abc import Iterator, Mapping
from pathlib import Path

from lxml import etree

from .mistakes import AnnotationError, AnnotationMistake
from .tracks import LABELS, Span, Track, track_name, track_of
from .xml_reading import number_of, xml_root

_LABEL_NAMES = ("type", "lexeme", "token", "text", "tag", "name", "rest", "phase")
"""The attribute that is the label, where it is not called as `LABELS` says."""


def read_anvil(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tracks of a file; raises AnnotationError with every element that has no time."""
    root = xml_root(content, path, "annotation")
    wrong: list[AnnotationMistake] = []
    elements: dict[str, Mapping[int, Span]] = {}
    for track in root.iter("track"):
        name = track.get("name", "")
        referred = elements.get(track.get("ref", ""), {})
        elements[name] = dict(_spans(track, referred, path, wrong))
    if wrong:
        raise AnnotationError(wrong)
    return tuple(track_of(name, spans.values()) for name, spans in elements.items())


def _spans(
    track: etree._Element, referred: Mapping[int, Span], path: Path, wrong: list[AnnotationMistake]
) -> Iterator[tuple[int, Span]]:
    name = track.get("name", "")
    for place, element in enumerate(track.iter("el")):
        times = _times(element, track.get("type", "primary"), referred)
        if times is None:
            told = f"element {element.get('index', place)} has no time, or refers to an element that is not there"
            wrong.append(AnnotationMistake(path, told, name))
            continue
        attributes = dict(_attributes(element))
        label = _label(track_name(name), attributes)
        yield int(number_of(element, "index") or place), Span(*times, label, attributes)


def _times(element: etree._Element, kind: str, referred: Mapping[int, Span]) -> tuple[float, float] | None:
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


def _attributes(element: etree._Element) -> Iterator[tuple[str, str]]:
    for attribute in element.iter("attribute"):
        links = [link.get("ref-index", "") for link in attribute.iter("value-link")]
        value = f"{links[0]}-{links[-1]}" if links else (attribute.text or "").strip()
        yield attribute.get("name", "").strip().lower(), value


def _label(track: str, attributes: Mapping[str, str]) -> str:
    names = (LABELS.get(track, "label"), *_LABEL_NAMES)
    return next((attributes[name] for name in names if name in attributes), "")
