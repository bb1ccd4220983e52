"""Timelines as OpenTimelineIO itself reads them."""

import json
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("opentimelineio", reason="OpenTimelineIO is not installed (test extra)")

import opentimelineio as otio

from tests.support.motion.editorial import LEAD_IN_S, REALIZED, SCHEDULE
from understudy.editorial.events import TimelineEvent, timeline_events
from understudy.editorial.timeline import to_otio
from understudy.model.formats import AudioFile

EVENTS = timeline_events(SCHEDULE, REALIZED)
RATE_HZ = 30
CONTENT = to_otio(EVENTS, RATE_HZ, lead_in_s=LEAD_IN_S, duration_s=4.0, audio=AudioFile("../line.wav", b""))
TIMELINE = otio.adapters.read_from_string(CONTENT.decode(), "otio_json")
TRACKS = {track.name: track for track in TIMELINE.tracks}


def clip_of(behavior: str) -> Any:  # noqa: ANN401 - OpenTimelineIO has no types
    found = [clip for clip in TIMELINE.find_clips() if clip.metadata.get("understudy", {}).get("id") == behavior]
    assert len(found) == 1
    return found[0]


def test_what_is_read_and_written_again_says_the_same(tmp_path: Path) -> None:
    path = tmp_path / "line.otio"
    otio.adapters.write_to_file(TIMELINE, str(path))
    again = otio.adapters.read_from_file(str(path))
    assert again.is_equivalent_to(TIMELINE)
    assert json.loads(path.read_text())["OTIO_SCHEMA"] == json.loads(CONTENT)["OTIO_SCHEMA"] == "Timeline.1"


def test_there_is_a_track_for_every_tier_and_overlaps_have_their_own() -> None:
    assert list(TRACKS) == [
        *("recording", "functions", "gesture", "head", "gaze", "face", "face 2", "eyes", "posture"),
    ]


def test_the_recording_begins_after_the_lead_in() -> None:
    gap, recording = TRACKS["recording"]
    assert TRACKS["recording"].kind == otio.schema.TrackKind.Audio
    assert gap.duration().to_seconds() == LEAD_IN_S
    assert recording.media_reference.target_url == "../line.wav"
    assert recording.trimmed_range_in_parent().end_time_exclusive().to_seconds() == 4.0


@pytest.mark.parametrize("event", EVENTS, ids=lambda event: event.id)
def test_every_event_is_a_clip_at_its_time_with_its_reasons(event: TimelineEvent) -> None:
    clip = clip_of(event.id)
    where = clip.range_in_parent()
    assert where.start_time.to_seconds() == pytest.approx(event.start_s, abs=0.5 / RATE_HZ)
    assert where.end_time_exclusive().to_seconds() == pytest.approx(event.end_s, abs=0.5 / RATE_HZ)
    why = clip.markers[0].metadata["understudy"]
    assert (why.get("function", ""), why.get("rule", "")) == (event.function, event.rule)


def test_markers_are_the_sync_points() -> None:
    clip = clip_of("gesture1")
    told = {each.name: clip.transformed_time(each.marked_range.start_time, TIMELINE.tracks) for each in clip.markers}
    assert list(told) == ["start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"]
    assert told["stroke"].to_seconds() == pytest.approx(1.5, abs=0.5 / RATE_HZ)


def test_without_a_recording_its_clip_has_no_media() -> None:
    bare = otio.adapters.read_from_string(to_otio((), RATE_HZ, lead_in_s=0.0, duration_s=2.0).decode(), "otio_json")
    (recording,) = bare.find_clips()
    assert recording.media_reference.is_missing_reference
