"""An OpenTimelineIO timeline (.otio) of a scene: recordings and behaviours as clips, for editing programs.

The format is JSON with named schemata (OpenTimelineIO 0.17), so no library is needed to write it. Times are frames of
the scene from its first; clips of a track that overlap go onto further ones ("Ann gesture 2").
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

Json = dict[str, Any]


@dataclass(frozen=True, slots=True)
class TimelineClip:
    """A clip: its name, first frame and the frame after its last, the file that it plays from `offset_frames` on
    (empty: none), what is known of it, and markers by their frames."""

    name: str
    start: int
    end: int
    file: str = ""
    offset_frames: int = 0
    about: Mapping[str, Any] = field(default_factory=dict)
    markers: tuple[tuple[str, int], ...] = ()


@dataclass(frozen=True, slots=True)
class TimelineTrack:
    """A track: what it is called, "Audio" or "Video", and its clips."""

    name: str
    kind: str
    clips: tuple[TimelineClip, ...]


def to_otio(name: str, tracks: Sequence[TimelineTrack], rate_hz: float, first_frame: int) -> bytes:
    """The timeline; `first_frame` is the scene's frame at which it begins."""
    timed = _Clock(rate_hz, first_frame)
    written = [timed.track(row_name, track.kind, row) for track in tracks for row_name, row in _rows(track)]
    timeline = {
        "OTIO_SCHEMA": "Timeline.1",
        "name": name,
        "metadata": {},
        "global_start_time": timed.time(first_frame),
        "tracks": {"OTIO_SCHEMA": "Stack.1", **_item("tracks", None), "children": written},
    }
    return json.dumps(timeline, indent=1, ensure_ascii=False).encode() + b"\n"


@dataclass(frozen=True, slots=True)
class _Clock:
    """Frames as times of OpenTimelineIO."""

    rate_hz: float
    first_frame: int

    def time(self, frame: int) -> Json:
        return {"OTIO_SCHEMA": "RationalTime.1", "rate": self.rate_hz, "value": float(frame)}

    def range(self, start: int, count: int) -> Json:
        return {"OTIO_SCHEMA": "TimeRange.1", "start_time": self.time(start), "duration": self.time(count)}

    def track(self, name: str, kind: str, clips: Sequence[TimelineClip]) -> Json:
        return {"OTIO_SCHEMA": "Track.1", **_item(name, None), "kind": kind, "children": list(self._filled(clips))}

    def _filled(self, clips: Sequence[TimelineClip]) -> Iterator[Json]:
        """The clips with gaps between them; what begins before the timeline is cut."""
        reached = self.first_frame
        for clip in clips:
            if clip.start > reached:
                yield {"OTIO_SCHEMA": "Gap.1", **_item("", self.range(0, clip.start - reached))}
            start = max(clip.start, reached)
            yield self._clip(clip, start)
            reached = max(clip.end, start + 1)

    def _clip(self, clip: TimelineClip, start: int) -> Json:
        count = max(clip.end - start, 1)
        media: Json = {"OTIO_SCHEMA": "MissingReference.1", "name": "", "metadata": {}, "available_range": None}
        if clip.file:
            media |= {"OTIO_SCHEMA": "ExternalReference.1", "target_url": clip.file}
        offset = clip.offset_frames + start - clip.start
        item = _item(clip.name, self.range(offset, count), {"understudy": dict(clip.about)} if clip.about else {})
        item["markers"] = [self._marker(name, frame - start + offset) for name, frame in clip.markers]
        referring = {"media_references": {"DEFAULT_MEDIA": media}, "active_media_reference_key": "DEFAULT_MEDIA"}
        return {"OTIO_SCHEMA": "Clip.2", **item, **referring}

    def _marker(self, name: str, frame: int) -> Json:
        fields = {"OTIO_SCHEMA": "Marker.2", "name": name, "color": "RED" if name == "stroke" else "YELLOW"}
        return {**fields, "marked_range": self.range(frame, 0), "comment": "", "metadata": {}}


def _rows(track: TimelineTrack) -> Iterator[tuple[str, list[TimelineClip]]]:
    """The clips in rows without overlaps, each with its name."""
    rest = sorted(track.clips, key=lambda clip: (clip.start, clip.end))
    number = 1
    while rest:
        row: list[TimelineClip] = []
        over: list[TimelineClip] = []
        for clip in rest:
            (over if row and clip.start < max(row[-1].end, row[-1].start + 1) else row).append(clip)
        yield (track.name if number == 1 else f"{track.name} {number}"), row
        rest, number = over, number + 1


def _item(name: str, source_range: Json | None, metadata: Json | None = None) -> Json:
    """The fields that everything on a timeline has."""
    base = {"name": name, "source_range": source_range, "metadata": metadata or {}}
    return {**base, "markers": [], "effects": [], "enabled": True}
