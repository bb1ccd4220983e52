"""Clips: markers, hands and the speed of the stroke, from definitions written by hand."""

from pathlib import Path

import pytest

from tests.realizer.gestures.test_checking import frames
from tests.support.motion.gesture_files import gesture, read_one
from understudy.model import Hand, Level
from understudy.realizer.gestures.clips import EMPHASIS, clip, relative_markers
from understudy.realizer.gestures.gesture import FrameType, Markers

EVERY_MARKER = "start preparation ready stroke_start stroke stroke_end hold relax retraction end"


def markers(folder: Path, types: str) -> Markers:
    """Of a gesture with a frame of each type, one every 0.05."""
    return relative_markers(read_one(folder, frames(*types.split())).frames)


def test_markers_are_where_their_frames_are(tmp_path: Path) -> None:
    assert markers(tmp_path, EVERY_MARKER) == Markers(0, 0.1, 0.15, 0.2, 0.25, 0.35, 0.45)


@pytest.mark.parametrize(
    ("types", "expected"),
    [
        ("stroke_start stroke_end", Markers(0, 0, 0, 0.05 * EMPHASIS, 0.05, 0.05, 0.05)),
        ("preparation stroke_start stroke stroke_end", Markers(0, 0.05, 0.05, 0.1, 0.15, 0.15, 0.15)),
        ("preparation ready stroke retraction", Markers(0, 0.05, 0.05, 0.1, 0.1, 0.1, 0.15)),
        ("stroke_start stroke_end hold hold retraction end", Markers(0, 0, 0, 0.05 * EMPHASIS, 0.05, 0.15, 0.25)),
        ("stroke_start stroke stroke stroke stroke_end", Markers(0, 0, 0, 0.1, 0.2, 0.2, 0.2)),
    ],
)
def test_markers_that_no_frame_is(tmp_path: Path, types: str, expected: Markers) -> None:
    found = markers(tmp_path, types)
    for name in Markers.__slots__:
        assert getattr(found, name) == pytest.approx(getattr(expected, name)), name


def test_tempo_sets_the_time(tmp_path: Path) -> None:
    """2 s of gesture from 0.25 to 0.75 at double tempo."""
    definition = read_one(tmp_path, gesture("EXPRESSIVITY medium tempo 2"))
    made = clip(definition, Level.MEDIUM, Hand.LEFT, "TRIAL")
    assert (made.markers.stroke_start, made.markers.stroke_end) == pytest.approx((0.25, 0.75))
    assert [key.time_s for key in made.keys] == pytest.approx([0.25, 0.75])
    assert [key.type for key in made.keys] == [FrameType.STROKE_START, FrameType.STROKE_END]


def test_the_stroke_s_speed_grows_with_amplitude_and_tempo(tmp_path: Path) -> None:
    """From XC ZNear to XP ZFar: .16 m out and .22 m away in 1 s, .272 m/s."""
    definition = read_one(
        tmp_path, gesture("EXPRESSIVITY low amplitude 0.5 tempo 1\nEXPRESSIVITY high amplitude 1.5 tempo 2")
    )
    speeds = [clip(definition, level, Hand.RIGHT, "TRIAL").stroke_speed_m_s for level in Level]
    assert speeds == pytest.approx([0.136, 0.272, 0.816], abs=1e-3)


def test_a_place_left_open_is_on_the_way(tmp_path: Path) -> None:
    """The hand goes out and back in the stroke: the way counts, not the distance of its ends."""
    there = "FRAMETYPE stroke_start\nARM XC YCC ZNear\nENDFRAME\nSTARTFRAME 0.5\nFRAMETYPE stroke\nARM XP YCC ZNear"
    back = "FRAMETYPE stroke_end\nENDFRAME\nSTARTFRAME 1\nFRAMETYPE hold\nARM XC YCC ZNear"
    made = clip(read_one(tmp_path, gesture(first=there, last=back)), Level.MEDIUM, Hand.RIGHT, "TRIAL")
    assert made.stroke_speed_m_s == pytest.approx(0.16 + 0.08)


def test_arms_that_take_part(tmp_path: Path) -> None:
    one = read_one(tmp_path, gesture())
    both = read_one(tmp_path, gesture("ARMS both", last="FRAMETYPE stroke_end\nARM XP YCC ZFar\nOTHER ARM XC YCC ZFar"))
    for hand, left, right in ((Hand.LEFT, True, False), (Hand.RIGHT, False, True), (Hand.BOTH, True, True)):
        for definition in (one, both):
            for key, frame in zip(clip(definition, Level.LOW, hand, "X").keys, definition.frames, strict=True):
                assert key.right == (frame.leading if right else None)
                beside = frame.other if hand is Hand.BOTH and frame.other else frame.leading
                assert key.left == (beside if left else None)
