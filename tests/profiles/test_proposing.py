"""Phases found in a motion: our own, whose strokes are known, and one by hand."""

from pathlib import Path

import numpy as np
import pytest

from understudy.model import Behavior, Channel, FloatArray, Hand, Schedule, SyncPoints
from understudy.models import Understudy
from understudy.profiles.annotation.elan import write_elan
from understudy.profiles.annotation.model import AnnotationError
from understudy.profiles.annotation.reading import annotation_of, read_annotations
from understudy.profiles.annotation.tracks import Track, TrackSpan, rows_of, with_attribute_tracks
from understudy.profiles.proposing import UNKNOWN, WristPaths, proposed_tracks, proposed_units, read_wrists
from understudy.realization import MotionFormat, RealizedSchedule, write_motion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.realizing import realize

RATE_HZ = 50.0


def _path(stations: list[tuple[float, float]], seconds: float) -> FloatArray:
    """A hand that is at heights (time, metres) and moves smoothly between."""
    times_s = np.arange(round(seconds * RATE_HZ)) / RATE_HZ
    height = np.zeros_like(times_s)
    for (start_s, from_m), (end_s, to_m) in zip(stations[::2], stations[1::2], strict=True):
        u = np.clip((times_s - start_s) / (end_s - start_s), 0, 1)
        height += (to_m - from_m) * (u**3 * (10 - 15 * u + 6 * u * u))
    return np.stack([np.zeros_like(height), height, np.zeros_like(height)], axis=1)


def test_a_gesture_by_hand() -> None:
    """Up in .4 s, a stroke of .3 s, a hold of .5 s, and back; the other hand rests."""
    right = _path([(2.0, 0.0), (2.4, 0.4), (2.4, 0.4), (2.7, 0.2), (3.2, 0.2), (3.8, 0.0)], 6.0)
    [unit] = proposed_units(WristPaths(RATE_HZ, np.zeros_like(right), right))
    [phrase] = unit.phrases
    assert [phase.kind.value for phase in phrase.phases] == ["preparation", "stroke", "hold"]
    assert (phrase.left, phrase.right) == (False, True)
    stroke = phrase.phases[1].interval
    assert (stroke.start_s, stroke.end_s) == pytest.approx((2.4, 2.7), abs=0.08)
    assert unit.retraction.interval.end_s == pytest.approx(3.8, abs=0.1)


def test_a_hand_that_passes_its_rest_ends_a_unit_there() -> None:
    """Up, and in one movement from as far above its rest to as far below: the units meet where it passes, at 3.25 s."""
    right = _path([(1.0, 0.0), (1.5, 0.4), (3.0, 0.4), (3.5, -0.4), (5.0, -0.4), (5.5, 0.0)], 9.0)
    tracks = proposed_tracks(proposed_units(WristPaths(RATE_HZ, np.zeros_like(right), right)))
    words = Track("words", (TrackSpan(0.0, 9.0, "oh"),))
    up, down = annotation_of((words, *tracks[1:]), Path("x")).units
    assert (up.interval.end_s, down.interval.start_s) == pytest.approx((3.25, 3.25), abs=0.03)


def _gesture(number: int, stroke_s: float) -> Behavior:
    sync = SyncPoints(
        stroke_s - 0.8, stroke_s + 1.3, stroke_start=stroke_s - 0.3, stroke=stroke_s, relax=stroke_s + 0.6
    )
    return Behavior(f"g{number}", Channel.GESTURE, "OPEN_HAND", sync, 0, 0, 5.0, hand=Hand.RIGHT)


def test_our_own_motion_is_found_again(understudy: Understudy) -> None:
    """Gestures so far apart that hands go down between them. In shorter gaps they rest before the belly, where strokes
    pass on their way out: a hand that passes its rest ends a unit there (as above), so that a unit may be found in two.
    """
    strokes_s = (8.0, 16.0, 24.0)
    schedule = Schedule(tuple(_gesture(*each) for each in enumerate(strokes_s)), 32.0)
    realizer = understudy.realizer
    motion = realize(realizer, schedule)
    bvh = write_motion(RealizedSchedule(schedule, motion), realizer, MotionFormat.BVH)
    units = list(proposed_units(read_wrists(bvh, Path("x.bvh"))))
    assert len(units) == len(strokes_s)
    for unit, stroke_s in zip(units, strokes_s, strict=True):
        mains = [phase.interval for phase in unit.phrases[0].phases if phase.kind.value == "stroke"]
        assert mains[0].start_s - 0.25 < stroke_s < mains[-1].end_s + 0.25


def test_wrists_are_where_the_skeleton_has_them(understudy: Understudy) -> None:
    motion = realize(understudy.realizer, Schedule((), 1.0))
    bvh = write_motion(RealizedSchedule(Schedule((), 1.0), motion), understudy.realizer, MotionFormat.BVH)
    wrists = read_wrists(bvh, Path("x.bvh"))
    skeleton = Skeleton.standing()
    assert len(wrists.left_m) == 60
    assert wrists.frame_rate_hz == pytest.approx(60)
    reach_m = float(np.linalg.norm(wrists.left_m, axis=1).max())
    assert 0.1 < reach_m < 1.0
    assert wrists.left_m[0, 0] == pytest.approx(-wrists.right_m[0, 0], abs=0.1)
    assert skeleton.offsets_m.shape[1] == 3


def test_what_is_proposed_is_an_annotation_to_be_named(tmp_path: Path) -> None:
    right = _path([(2.0, 0.0), (2.4, 0.4), (2.4, 0.4), (2.7, 0.2), (3.2, 0.2), (3.8, 0.0)], 6.0)
    units = proposed_units(WristPaths(RATE_HZ, np.zeros_like(right), right))
    words = Track("words", (TrackSpan(2.0, 2.5, "oh"), TrackSpan(2.5, 3.0, "no")))
    tracks = proposed_tracks(units, (words,))
    [phrase] = annotation_of(tracks, Path("x")).phrases
    assert (phrase.lexeme, phrase.hand, phrase.affiliate) == (UNKNOWN, Hand.RIGHT, (1, 1))
    path = tmp_path / "a.eaf"
    path.write_bytes(write_elan([row for track in with_attribute_tracks(tracks) for row in rows_of(track)]))
    with pytest.raises(AnnotationError, match="the library has no gesture 'UNKNOWN'"):
        read_annotations([path], {"BEAT"})


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"hello", "does not begin with HIERARCHY"),
        (b"HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation }", "no lines .Frames"),
        (
            b"HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 1 Zrotation End Site { OFFSET 0 1 0 } } "
            b"MOTION Frames: 1 Frame Time: 0.1 0",
            "no joint is called left hand or wrist; there are Hips",
        ),
    ],
)
def test_what_is_no_motion_of_hands_is_told(content: bytes, told: str) -> None:
    with pytest.raises(AnnotationError, match=told):
        read_wrists(content, Path("x.bvh"))
