"""Events are what the motion shows, with the words and reasons they belong to."""

from dataclasses import replace

import pytest

from tests.support.motion.editorial import LEAD_IN_S, REALIZED, SCHEDULE
from understudy.editorial.events import timeline_events, tracks_of
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
