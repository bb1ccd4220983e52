"""Clips, read from what Understudy itself writes and sampled at other rates."""

import numpy as np
import pytest

from plugins.blender.motion.clip import read_clip
from tests.plugins.blender.clips import Z, about, clip


def turning(frames: int, per_frame_rad: float) -> list[list[float]]:
    """A joint that turns steadily about Z."""
    angles = per_frame_rad * np.arange(frames)
    return [[0, 0, float(np.sin(angle / 2)), float(np.cos(angle / 2))] for angle in angles]


def test_a_child_is_turned_with_its_parents() -> None:
    both = clip({"leftUpperArm": turning(2, 0.4), "leftLowerArm": turning(2, 0.2)})
    assert np.allclose(both.world_rotations()["leftHand"][1], about(Z, 0.6))


def test_the_t_pose_stands_on_the_floor() -> None:
    places = clip().t_pose_m()
    assert places["hips"].tolist() == [0, 0.95, 0]
    assert places["leftToes"][1] == pytest.approx(0.02)
    assert places["leftHand"][0] == -places["rightHand"][0] > 0.6


def test_another_rate_has_its_frames_on_its_own_beat() -> None:
    """At 24 frames a second frame 1 is 1.25 frames of 30 later: the arm has turned 1.25 times as far."""
    slow = clip({"leftUpperArm": turning(31, 0.05)}).at_rate(24)
    assert (slow.frames, slow.start_s, slow.end_s) == (25, 0.0, 1.0)
    assert np.allclose(slow.world_rotations()["leftUpperArm"][1], about(Z, 1.25 * 0.05), atol=1e-5)


def test_a_lead_in_begins_before_the_recording() -> None:
    early = clip({"head": turning(31, 0.01)}, audio_offset_s=-0.51).at_rate(10)
    assert early.start_s == -0.5
    assert early.end_s == pytest.approx(0.4)
    assert np.allclose(early.world_rotations()["head"][0], about(Z, 0.003), atol=1e-6)


def test_times_of_events_are_those_of_the_recording() -> None:
    event = {"behavior": "head1", "point": "start", "time_s": 0.7}
    (found,) = clip(audio_offset_s=-0.5, events=[event]).events
    assert found.time_s == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"<html>", "not JSON"),
        (b"[]", "not an understudy-clip"),
        (b'{"format":"understudy-clip","version":2}', "version 1"),
    ],
)
def test_what_is_no_clip_is_refused_by_name(content: bytes, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        read_clip(content)
