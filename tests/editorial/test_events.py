"""Events are what the motion shows, with the words and reasons they belong to."""

import csv
import io
from dataclasses import replace
from pathlib import Path

import pytest

from tests.support.motion.editorial import LEAD_IN_S, REALIZED, SCHEDULE
from understudy.editorial.events import timeline_events, to_elan, to_event_table, to_textgrid, tracks_of
from understudy.model import SyncPoints


def test_functions_last_as_long_as_their_words() -> None:
    negation, emphasis = (event for event in timeline_events(SCHEDULE, REALIZED) if event.tier == "functions")
    assert (negation.label, negation.start_s, negation.end_s) == ("negation/plain", 1.5, 1.9)
    assert (negation.text, negation.rule) == ("No", "negation_by_word")
    assert (emphasis.text, emphasis.first, emphasis.last) == ("I have", 1, 2)


def test_movements_are_as_realized_with_what_they_show() -> None:
    gesture = next(event for event in timeline_events(SCHEDULE, REALIZED) if event.id == "gesture1")
    assert gesture.points["stroke"] == REALIZED["gesture1"].stroke
    assert (gesture.function, gesture.rule, gesture.hand, gesture.text) == (
        "negation/plain",
        "show_negation",
        "right",
        "No",
    )
    blink = next(event for event in timeline_events(SCHEDULE, REALIZED) if event.id == "eyes1")
    assert blink.reasons == {"id": "eyes1"}


def test_what_the_motion_does_not_show_is_no_event() -> None:
    shown = {name: sync for name, sync in REALIZED.items() if name != "head1"}
    assert "head1" not in {event.id for event in timeline_events(SCHEDULE, shown)}


def test_tracks_are_in_the_time_of_the_recording_and_begin_with_it() -> None:
    early = {**REALIZED, "gesture1": SyncPoints(0.2, 1.8, ready=1.0, stroke=1.5, relax=1.6)}
    tracks = tracks_of(timeline_events(SCHEDULE, early), clock_starts_s=LEAD_IN_S, words=SCHEDULE.words)
    named = {track.name: track.spans for track in tracks}
    assert named["words"][0].start_s == pytest.approx(1.0)
    assert named["words"][0].label == "No"
    assert named["gesture"][0].start_s == 0.0
    assert named["gesture"][0].end_s == pytest.approx(1.3)
    assert named["gesture.rule"][0].label == "show_negation"
    assert not [span for spans in named.values() for span in spans if span.start_s < 0]


def test_a_schedule_of_others_has_no_functions_but_their_ids() -> None:
    others = replace(SCHEDULE, functions=(), words=())
    gesture = next(event for event in timeline_events(others, REALIZED) if event.id == "gesture1")
    assert (gesture.function, gesture.text) == ("f1", "")


TRACKS = tracks_of(timeline_events(SCHEDULE, REALIZED), clock_starts_s=LEAD_IN_S, words=SCHEDULE.words)
TIERS = {"words", "functions", "gesture", "head", "face", "face_2", "eyes", "gesture.rule", "face.function"}
GESTURE = (pytest.approx(0.5), pytest.approx(2.1), "NEGATION")
"""Half a second earlier than in the performance, which has a lead-in."""


def test_praat_finds_a_tier_for_functions_and_every_channel(tmp_path: Path) -> None:
    from praatio import textgrid  # type: ignore[import-untyped]

    path = tmp_path / "line.TextGrid"
    path.write_bytes(to_textgrid(TRACKS, 3.5))
    grid = textgrid.openTextgrid(str(path), includeEmptyIntervals=False)
    assert set(grid.tierNames) >= TIERS
    assert (grid.minTimestamp, grid.maxTimestamp) == (0.0, 3.5)
    assert tuple(grid.getTier("gesture").entries[0]) == GESTURE
    assert [entry.label for entry in grid.getTier("functions").entries] == ["negation/plain", "emphasis/voice"]
    assert grid.getTier("gesture.rule").entries[0].label == "show_negation"
    assert [entry.label for entry in grid.getTier("words").entries] == ["No", "I", "have", "seen"]


def test_elan_finds_the_same_tiers_and_the_recording(tmp_path: Path) -> None:
    elan = pytest.importorskip("pympi.Elan", reason="pympi-ling is not installed (test extra)")
    path = tmp_path / "line.eaf"
    path.write_bytes(to_elan(TRACKS, "line.wav"))
    found = elan.Eaf(str(path))
    assert set(found.get_tier_names()) >= TIERS
    (start_ms, end_ms, label), *_ = found.get_annotation_data_for_tier("gesture")
    assert (start_ms / 1000, end_ms / 1000, label) == GESTURE
    assert found.get_annotation_data_for_tier("gesture.function")[0][2] == "negation/plain"
    assert found.media_descriptors[0]["MEDIA_URL"] == "line.wav"


@pytest.mark.parametrize("end_s", [3.5, 0.0])
def test_the_grid_is_as_long_as_what_is_in_it(end_s: float) -> None:
    assert f"xmax = {max(end_s, 2.6):g}".encode() in to_textgrid(TRACKS, end_s)


def rows(realized: dict[str, SyncPoints]) -> dict[str, dict[str, str]]:
    content = to_event_table(timeline_events(SCHEDULE, realized), clock_starts_s=LEAD_IN_S).decode()
    return {row["id"]: row for row in csv.DictReader(io.StringIO(content))}


def test_a_row_has_the_points_in_the_time_of_the_recording_and_the_reasons() -> None:
    told = rows(dict(REALIZED))
    gesture = told["gesture1"]
    assert (gesture["tier"], gesture["label"], gesture["hand"]) == ("gesture", "NEGATION", "right")
    assert (gesture["start_s"], gesture["stroke_s"], gesture["end_s"]) == ("0.500", "1.000", "2.100")
    assert (gesture["words"], gesture["function"], gesture["rule"]) == ("No", "negation/plain", "show_negation")
    assert told["eyes1"]["stroke_s"] == ""
    assert told["f2"]["label"] == "emphasis/voice"


def test_what_is_before_the_recording_has_times_below_zero() -> None:
    assert rows({**REALIZED, "eyes1": SyncPoints(0.1, 0.3)})["eyes1"]["start_s"] == "-0.400"
