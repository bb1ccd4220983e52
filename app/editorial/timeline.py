"""Exports an OpenTimelineIO timeline (.otio): the recording, and each movement and function as a clip with markers.

Conventions: times are frames of the motion, from the performance's start; the recording's clip begins after the
lead-in. Clips of movements have no media; their metadata `understudy`, and that of their markers, one at each sync
point, has id, words, function and rule. Clips of a tier that overlap go to further tracks, `face`, `face 2`. The format
is JSON with named schemata (OpenTimelineIO 0.17), so no library is needed to write it.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from ..model.formats import AudioFile
from .events import FUNCTIONS, TIERS, TimelineEvent

Json = str | int | float | bool | None | Mapping[str, "Json"] | Sequence["Json"]

_COLOURS = {"stroke": "RED", "stroke_start": "ORANGE", "stroke_end": "ORANGE", "start": "GREEN", "end": "GREEN"}


def to_otio(
    events: Sequence[TimelineEvent],
    frame_rate_hz: int,
    *,
    lead_in_s: float,
    duration_s: float,
    audio: AudioFile | None = None,
) -> bytes:
    """The timeline; the recording lasts from `lead_in_s` to `duration_s`."""
    at = _Clock(frame_rate_hz)
    tracks = [_recording(at, lead_in_s, duration_s, audio)]
    for tier in TIERS:
        for number, row in enumerate(_rows([event for event in events if event.tier == tier], at), start=1):
            tracks.append(_track(tier if number == 1 else f"{tier} {number}", "Video", list(_filled(row, at))))
    timeline = {
        "OTIO_SCHEMA": "Timeline.1",
        "name": "understudy",
        "metadata": {},
        "global_start_time": at.time(0),
        "tracks": {"OTIO_SCHEMA": "Stack.1", **_item("tracks", None), "children": tracks},
    }
    return json.dumps(timeline, indent=1, ensure_ascii=False).encode() + b"\n"


@dataclass(frozen=True, slots=True)
class _Clock:
    """Seconds to times of OpenTimelineIO, in whole frames."""

    rate_hz: int

    def frame(self, time_s: float) -> int:
        return round(time_s * self.rate_hz)

    def time(self, frame: int) -> Json:
        return {"OTIO_SCHEMA": "RationalTime.1", "rate": float(self.rate_hz), "value": float(frame)}

    def range(self, start: int, count: int) -> Json:
        return {"OTIO_SCHEMA": "TimeRange.1", "start_time": self.time(start), "duration": self.time(count)}


def _item(name: str, source_range: Json, metadata: Json = None, markers: Sequence[Json] = ()) -> dict[str, Json]:
    """The fields that everything on a timeline has."""
    return {
        "name": name,
        "source_range": source_range,
        "metadata": metadata or {},
        "markers": markers,
        "effects": [],
        "enabled": True,
    }


def _track(name: str, kind: str, children: Sequence[Json]) -> Json:
    return {"OTIO_SCHEMA": "Track.1", **_item(name, None), "kind": kind, "children": children}


def _gap(at: _Clock, count: int) -> Json:
    return {"OTIO_SCHEMA": "Gap.1", **_item("", at.range(0, count))}


def _clip(name: str, media: Json, item: Mapping[str, Json]) -> Json:
    references: Json = {"DEFAULT_MEDIA": media}
    referring = {"media_references": references, "active_media_reference_key": "DEFAULT_MEDIA"}
    return {"OTIO_SCHEMA": "Clip.2", **item, "name": name, **referring}


def _recording(at: _Clock, lead_in_s: float, duration_s: float, audio: AudioFile | None) -> Json:
    begin, count = at.frame(lead_in_s), at.frame(duration_s) - at.frame(lead_in_s)
    media: dict[str, Json] = {"OTIO_SCHEMA": "MissingReference.1", "name": "", "metadata": {}, "available_range": None}
    if audio:
        media |= {"OTIO_SCHEMA": "ExternalReference.1", "target_url": audio.name, "available_range": at.range(0, count)}
    clip = _clip("recording", media, _item("recording", at.range(0, count)))
    return _track("recording", "Audio", [*([_gap(at, begin)] if begin else []), clip])


def _rows(events: Sequence[TimelineEvent], at: _Clock) -> Iterator[list[TimelineEvent]]:
    """The events in rows without overlaps; at least one row."""
    rest, first = list(events), True
    while rest or first:
        row: list[TimelineEvent] = []
        over: list[TimelineEvent] = []
        for event in rest:
            taken = row and at.frame(event.start_s) < _end(row[-1], at)
            (over if taken else row).append(event)
        yield row
        rest, first = over, False


def _end(event: TimelineEvent, at: _Clock) -> int:
    """The frame after a clip's last; every clip lasts at least one frame."""
    return max(at.frame(event.end_s), at.frame(event.start_s) + 1)


def _filled(row: Sequence[TimelineEvent], at: _Clock) -> Iterator[Json]:
    """The clips with gaps between them."""
    reached = 0
    for event in row:
        start = at.frame(event.start_s)
        if start > reached:
            yield _gap(at, start - reached)
        yield _event_clip(event, at)
        reached = _end(event, at)


def _event_clip(event: TimelineEvent, at: _Clock) -> Json:
    start = at.frame(event.start_s)
    why: Json = {"understudy": {**event.reasons, "first": event.first, "last": event.last}}
    points = event.points or {"start": event.start_s}
    markers: list[Json] = [
        {
            "OTIO_SCHEMA": "Marker.2",
            "name": event.label if event.tier == FUNCTIONS else point,
            "color": _COLOURS.get(point, "YELLOW"),
            "marked_range": at.range(at.frame(time_s) - start, 0),
            "comment": "",
            "metadata": why,
        }
        for point, time_s in points.items()
    ]
    media: Json = {"OTIO_SCHEMA": "MissingReference.1", "name": "", "metadata": {}, "available_range": None}
    return _clip(event.label, media, _item(event.label, at.range(0, _end(event, at) - start), why, markers))
