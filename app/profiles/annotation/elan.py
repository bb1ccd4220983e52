"""Reads and writes ELAN's annotation files (.eaf): tiers whose annotations refer to time slots, in milliseconds.

An annotation that refers to another (`REF_ANNOTATION`) has the time of the other. Slots without a time are spaced
evenly between their neighbours, as in ELAN. Parsed with lxml, because pympi-ling does not report mistakes.
"""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np
from lxml import etree

from .model import AnnotationError, AnnotationMistake
from .tracks import Track, TrackSpan, number_of, track_of, xml_root

_UNITS = "milliseconds"
_TYPE = "marked"
_SCHEMA = "http://www.mpi.nl/tools/elan/EAFv3.0.xsd"
_XSI = "http://www.w3.org/2001/XMLSchema-instance"


def read_elan(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tiers of a file; raises AnnotationError with every annotation without a time."""
    root = xml_root(content, path, "ANNOTATION_DOCUMENT")
    wrong = list(_unreadable(root, path))
    slots_s = _slots_s(root)
    times = dict(_times(root, slots_s))
    tracks = []
    for tier in root.iter("TIER"):
        name = tier.get("TIER_ID", "")
        spans = []
        for annotation in tier.iter("ALIGNABLE_ANNOTATION", "REF_ANNOTATION"):
            found = times.get(annotation.get("ANNOTATION_ID", ""))
            if found is None:
                message = f"annotation {annotation.get('ANNOTATION_ID')} refers to what has no time"
                wrong.append(AnnotationMistake(path, message, name))
                continue
            spans.append(TrackSpan(*found, (annotation.findtext("ANNOTATION_VALUE") or "").strip()))
        tracks.append(track_of(name, spans))
    if wrong:
        raise AnnotationError(wrong)
    return tuple(tracks)


def _unreadable(root: etree._Element, path: Path) -> Iterator[AnnotationMistake]:
    """The mistakes in the unit of time and in the time slots."""
    header = root.find("HEADER")
    units = _UNITS if header is None else header.get("TIME_UNITS", _UNITS)
    if units != _UNITS:
        yield AnnotationMistake(path, f"times in {units}; save it with times in {_UNITS}")
    for slot in root.iter("TIME_SLOT"):
        if slot.get("TIME_VALUE") is not None and number_of(slot, "TIME_VALUE") is None:
            message = f"line {slot.sourceline}: time slot {slot.get('TIME_SLOT_ID')} is at {slot.get('TIME_VALUE')!r}"
            yield AnnotationMistake(path, f"{message}; give {_UNITS}")


def _slots_s(root: etree._Element) -> Mapping[str, float]:
    slots = list(root.iter("TIME_SLOT"))
    known = {
        place: value / 1000 for place, slot in enumerate(slots) if (value := number_of(slot, "TIME_VALUE")) is not None
    }
    if not known:
        return {}
    times_s = np.interp(range(len(slots)), list(known), list(known.values()))
    return {slot.get("TIME_SLOT_ID", ""): float(time_s) for slot, time_s in zip(slots, times_s, strict=True)}


def _times(root: etree._Element, slots_s: Mapping[str, float]) -> Iterator[tuple[str, tuple[float, float]]]:
    """The times of annotations by id; circular references have none."""
    known: dict[str, tuple[float, float]] = {}
    for annotation in root.iter("ALIGNABLE_ANNOTATION"):
        start, end = (slots_s.get(annotation.get(f"TIME_SLOT_REF{number}", "")) for number in (1, 2))
        if start is not None and end is not None:
            known[annotation.get("ANNOTATION_ID", "")] = start, end
    waiting = {each.get("ANNOTATION_ID", ""): each.get("ANNOTATION_REF", "") for each in root.iter("REF_ANNOTATION")}
    while found := {name: known[referred] for name, referred in waiting.items() if referred in known}:
        known |= found
        waiting = {name: referred for name, referred in waiting.items() if name not in found}
    yield from known.items()


def write_elan(tracks: Sequence[Track], *, media: str = "") -> bytes:
    """The tracks as an ELAN file with a tier for each track; `media` is the recording's file name."""
    location = etree.QName(_XSI, "noNamespaceSchemaLocation")
    root = etree.Element("ANNOTATION_DOCUMENT", nsmap={"xsi": _XSI})
    for name, value in (("AUTHOR", ""), ("DATE", "1970-01-01T00:00:00+00:00"), ("FORMAT", "3.0"), ("VERSION", "3.0")):
        root.set(name, value)
    root.set(location, _SCHEMA)
    header = etree.SubElement(root, "HEADER", MEDIA_FILE="", TIME_UNITS=_UNITS)
    if media:
        etree.SubElement(header, "MEDIA_DESCRIPTOR", MEDIA_URL=media, MIME_TYPE="audio/x-wav")
    order = etree.SubElement(root, "TIME_ORDER")
    times_ms = sorted(
        {round(time_s * 1000) for track in tracks for span in track.spans for time_s in (span.start_s, span.end_s)}
    )
    slots = {time_ms: f"ts{number}" for number, time_ms in enumerate(times_ms, start=1)}
    for time_ms, name in slots.items():
        etree.SubElement(order, "TIME_SLOT", TIME_SLOT_ID=name, TIME_VALUE=str(time_ms))
    number = 0
    for track in tracks:
        tier = etree.SubElement(root, "TIER", LINGUISTIC_TYPE_REF=_TYPE, TIER_ID=track.name)
        for span in track.spans:
            number += 1
            _write_span(tier, span, f"a{number}", slots)
    etree.SubElement(
        root, "LINGUISTIC_TYPE", LINGUISTIC_TYPE_ID=_TYPE, TIME_ALIGNABLE="true", GRAPHIC_REFERENCES="false"
    )
    return bytes(etree.tostring(root, xml_declaration=True, encoding="UTF-8", pretty_print=True))


def _write_span(tier: etree._Element, span: TrackSpan, name: str, slots: Mapping[int, str]) -> None:
    annotation = etree.SubElement(
        etree.SubElement(tier, "ANNOTATION"),
        "ALIGNABLE_ANNOTATION",
        ANNOTATION_ID=name,
        TIME_SLOT_REF1=slots[round(span.start_s * 1000)],
        TIME_SLOT_REF2=slots[round(span.end_s * 1000)],
    )
    etree.SubElement(annotation, "ANNOTATION_VALUE").text = span.label
