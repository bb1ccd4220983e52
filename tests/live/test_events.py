"""What begins, told in time and in order."""

import numpy as np

from tests.acoustic.pitch.test_streaming import LINE
from understudy.live.events import LATEST_S, LiveEvent, LiveEvents
from understudy.model import SAMPLE_RATE_HZ
from understudy.prosody_gestures.voice_model import VoiceModel
from understudy.resources import resource_folder

MODEL = VoiceModel.load(resource_folder("models") / "prosody_gestures" / "voice.npz")
CHUNK = 640


def told() -> list[LiveEvent]:
    live = LiveEvents(MODEL, SAMPLE_RATE_HZ)
    events = [event for first in range(0, len(LINE), CHUNK) for event in live.hear(LINE[first : first + CHUNK])]
    return [*events, *live.finish()]


def test_a_line_has_strokes_and_all_parts_begin_at_its_start() -> None:
    events = told()
    assert {event.part for event in events if event.start_s == 0} == {"hands", "head", "brows"}
    assert any(event.state == "stroke" for event in events)
    for part in ("hands", "head", "brows"):
        starts = [event.start_s for event in events if event.part == part]
        assert starts == sorted(starts)


def test_each_is_told_in_time() -> None:
    assert max(event.heard_s - event.start_s for event in told()) <= LATEST_S + CHUNK / SAMPLE_RATE_HZ


def test_the_same_sound_has_the_same_events() -> None:
    assert told() == told()


def test_nothing_heard_is_nothing_told() -> None:
    live = LiveEvents(MODEL, 48_000)
    assert live.hear(np.empty(0)) == ()
    assert len(live.finish()) <= 3
