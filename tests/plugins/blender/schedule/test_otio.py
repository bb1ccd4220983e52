"""The timeline of a scene, as editing programs read it."""

import json
from typing import Any

from plugins.blender.schedule.otio import TimelineClip, TimelineTrack, to_otio

SOUND = TimelineClip("line", 10, 40, "file:///line.wav", 5, {"text": "No."})
NOD = TimelineClip("head: nod", 12, 20, about={"words": "No."}, markers=(("stroke", 15),))
SHAKE = TimelineClip("head: shake", 18, 30)


def written() -> Any:  # noqa: ANN401 -- JSON
    tracks = [TimelineTrack("sound 1", "Audio", (SOUND,)), TimelineTrack("Ann head", "Video", (SHAKE, NOD))]
    return json.loads(to_otio("Scene", tracks, 24.0, 1))


def places(track: Any) -> list[tuple[str, int]]:  # noqa: ANN401 -- JSON
    """Where the clips of a track begin, in frames of the timeline."""
    found, reached = [], 0
    for child in track["children"]:
        if child["OTIO_SCHEMA"] == "Clip.2":
            found.append((child["name"], reached))
        reached += int(child["source_range"]["duration"]["value"])
    return found


def test_clips_begin_where_they_lie_in_the_scene() -> None:
    sound, head, head_2 = written()["tracks"]["children"]
    assert (sound["kind"], places(sound)) == ("Audio", [("line", 9)])
    assert (head["name"], places(head)) == ("Ann head", [("head: nod", 11)])
    assert (head_2["name"], places(head_2)) == ("Ann head 2", [("head: shake", 17)])


def test_a_sound_plays_its_file_from_its_offset() -> None:
    clip = written()["tracks"]["children"][0]["children"][1]
    assert clip["media_references"]["DEFAULT_MEDIA"]["target_url"] == "file:///line.wav"
    assert (clip["source_range"]["start_time"]["value"], clip["source_range"]["duration"]["value"]) == (5, 30)
    assert clip["metadata"] == {"understudy": {"text": "No."}}


def test_sync_points_are_markers_of_the_clip() -> None:
    (marker,) = written()["tracks"]["children"][1]["children"][1]["markers"]
    assert (marker["name"], marker["marked_range"]["start_time"]["value"]) == ("stroke", 3)


def test_what_begins_before_the_timeline_is_cut() -> None:
    early = TimelineTrack("sound 1", "Audio", (SOUND,))
    (track,) = json.loads(to_otio("Scene", [early], 24.0, 20))["tracks"]["children"]
    (clip,) = track["children"]
    assert (clip["source_range"]["start_time"]["value"], clip["source_range"]["duration"]["value"]) == (15, 20)
