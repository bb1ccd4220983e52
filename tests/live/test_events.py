"""What begins, told in time and in order."""

import numpy as np
import pytest

from tests.acoustic.pitch.test_streaming import LINE
from understudy.acoustic.pitch.streaming import LATEST_S as PITCH_LATEST_S
from understudy.files import resource_folder
from understudy.live.ear import StreamingVoice
from understudy.live.movements import LATEST_S, LiveEvent, LiveEvents
from understudy.model import SAMPLE_RATE_HZ
from understudy.prosody_gestures.live_gestures import DECIDED_S
from understudy.prosody_gestures.voice_model import VoiceModel

MODEL = VoiceModel.load(resource_folder("models") / "prosody_gestures" / "voice.npz")
CHUNK = 640


def told(*, decided: bool = False) -> list[LiveEvent]:
    live, voice, heard_s = LiveEvents(MODEL, decided=decided), StreamingVoice(), 0.0
    events: list[LiveEvent] = []
    for first in range(0, len(LINE), CHUNK):
        heard_s = (first + CHUNK) / SAMPLE_RATE_HZ
        events += live.hear(*voice.hear(LINE[first : first + CHUNK]), heard_s)
    return [*events, *live.hear(*voice.finish(), heard_s), *live.finish(heard_s)]


@pytest.mark.parametrize("decided", [False, True])
def test_a_line_has_strokes_and_all_parts_begin_at_its_start(decided: bool) -> None:
    events = told(decided=decided)
    assert {event.decided for event in events} == {decided}
    assert {event.part for event in events if event.start_s == 0} == {"hands", "head", "brows"}
    assert any(event.state == "stroke" for event in events)
    for part in ("hands", "head", "brows"):
        starts = [event.start_s for event in events if event.part == part]
        assert starts == sorted(starts)


def test_each_is_told_in_time() -> None:
    chunk_s = CHUNK / SAMPLE_RATE_HZ
    assert max(event.heard_s - event.start_s for event in told()) <= LATEST_S + chunk_s
    assert max(event.heard_s - event.start_s for event in told(decided=True)) <= PITCH_LATEST_S + DECIDED_S + chunk_s


def test_what_is_announced_is_mostly_what_is_decided() -> None:
    """Of a line's moments, hands are in the state that was announced for them in more than two thirds, preparations
    aside, which are announced early."""
    paths = []
    for decided in (False, True):
        hands = [event for event in told(decided=decided) if event.part == "hands"]
        starts = np.array([event.start_s for event in hands])
        moments = np.arange(0.0, len(LINE) / SAMPLE_RATE_HZ, 0.025)
        paths.append([hands[place].state for place in np.searchsorted(starts, moments, side="right") - 1])
    alike = [one == other for one, other in zip(*paths, strict=True) if one != "preparation"]
    assert len(alike) > len(paths[0]) / 2
    assert np.mean(alike) > 2 / 3


def test_the_same_sound_has_the_same_events() -> None:
    assert told() == told()


def test_nothing_heard_is_nothing_told() -> None:
    live = LiveEvents(MODEL)
    assert live.hear(np.empty(0), np.empty(0), 0.0) == ()
    assert live.finish(0.0) == ()
