"""Contact sheets are PNG, and show the poses they are given."""

import io
from dataclasses import replace

import numpy as np
import pytest

from understudy.model import Behavior, Channel, FloatArray, Interval, Schedule, SyncPoints, Word
from understudy.model.figure import Looks, Physique
from understudy.realizer.body.motion import SHAPES, BodyMotion, Motion
from understudy.realizer.body.proportions import Proportions
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle
from understudy.realizer.pictures.contact_sheet import (
    BACKGROUND,
    BODY_HEIGHT,
    CELL_WIDTH,
    Still,
    draw_characters,
    draw_sheet,
    draw_stills,
    moments_of,
)

pytest.importorskip("matplotlib", reason="contact sheets need matplotlib")

BODY = Skeleton.standing()


def t_pose(frames: int = 1) -> FloatArray:
    return np.tile(IDENTITY, (frames, len(BODY.names), 1))


def pixels(png: bytes) -> FloatArray:
    from matplotlib.image import imread

    return np.asarray(imread(io.BytesIO(png)), dtype=np.float64)


def test_a_sheet_has_the_pose_of_each_moment() -> None:
    rotations = t_pose(31)
    rotations[15:, BODY.index["leftUpperArm"]] = from_axis_angle((0.0, 0.0, 1.0), np.array(-1.3))
    body = BodyMotion(np.arange(31) / 30, rotations, np.tile([0.0, HIPS_HEIGHT_M, 0.0], (31, 1)))
    motion = Motion(30, body, np.zeros((31, len(SHAPES))), {"b1": SyncPoints(0.0, 1.0)})
    picture = pixels(draw_sheet(motion, BODY, [(0.0, "up"), (1.0, "down")], faces=False))
    up, down = np.split(picture[:300], 2, axis=1)
    assert np.abs(up - down).max() > 0.3
    same = pixels(draw_sheet(motion, BODY, [(0.0, "up"), (0.4, "up")], faces=False))
    first, second = np.split(same[:300], 2, axis=1)
    assert np.allclose(first, second)


def test_many_poses_wrap_into_rows() -> None:
    one = pixels(draw_stills([Still("a", t_pose()[0])], BODY, faces=False))
    many = pixels(draw_stills([Still("a", t_pose()[0])] * 3, BODY, faces=False, columns=2))
    assert many.shape[0] == 2 * one.shape[0]
    assert many.shape[1] == 2 * one.shape[1]


def behavior(name: str, kind: Channel, lexeme: str) -> Behavior:
    return Behavior(name, kind, lexeme, SyncPoints(0, 1), 0, 0, 1.0)


REALIZED = {
    "face1": SyncPoints(0.5, 1.5, ready=0.8),
    "gesture1": SyncPoints(0.1, 1.0, ready=0.2, stroke=0.6),
    "head1": SyncPoints(0.5, 0.9, ready=0.55, stroke=0.65),
    "blink1": SyncPoints(0.9, 1.0),
    "shift1": SyncPoints(1.7, 1.9),
}
SCHEDULE = Schedule(
    (
        behavior("face1", Channel.FACE, "RAISE_BROWS"),
        behavior("head1", Channel.HEAD, "NOD"),
        behavior("gesture1", Channel.GESTURE, "NEGATION"),
        behavior("blink1", Channel.EYES, "BLINK"),
        behavior("shift1", Channel.POSTURE, "SHIFT"),
        behavior("dropped1", Channel.GESTURE, "BEAT"),
    ),
    2.0,
    words=(Word(0, "No,", Interval(0.4, 0.7)), Word(1, "never", Interval(0.7, 1.2))),
)


def played(realized: dict[str, SyncPoints]) -> Motion:
    body = BodyMotion(np.arange(61) / 30, t_pose(61), np.tile([0.0, HIPS_HEIGHT_M, 0.0], (61, 1)))
    return Motion(30, body, np.zeros((61, len(SHAPES))), realized)


def test_moments_are_the_peaks_in_order_with_the_words_said_and_neighbours_together() -> None:
    assert moments_of(played(REALIZED), SCHEDULE) == (
        (0.6, "NEGATION + NOD\n“No,”"),
        (0.8, "RAISE_BROWS\n“never”"),
        (1.7, "SHIFT\n"),
    )


def test_where_there_is_no_room_for_all_moments_gestures_stay() -> None:
    assert [time_s for time_s, _caption in moments_of(played(REALIZED), SCHEDULE, at_most=1)] == [0.6]


def test_a_motion_in_which_nothing_is_asked_for_has_one_moment() -> None:
    assert moments_of(played({}), SCHEDULE) == ((0.0, "\n"),)


def test_motion_that_nothing_is_said_of_is_shown_at_equal_distances() -> None:
    motion = played({})
    times_s = motion.body.times_s
    found = [time_s for time_s, _caption in moments_of(motion, replace(SCHEDULE, behaviors=()), at_most=3)]
    assert found == [times_s[0], times_s[round((len(times_s) - 1) / 2)], times_s[-1]]


def test_the_taller_stands_higher_in_the_picture() -> None:
    image = pytest.importorskip("matplotlib.image", reason="pictures need matplotlib")
    bodies = {
        name: (Skeleton.standing(Proportions(Physique(height_m=height_m))), Looks())
        for name, height_m in (("small", 1.5), ("tall", 1.9))
    }
    picture = image.imread(io.BytesIO(draw_characters(bodies)))[..., :3]
    assert picture.shape[1] == 2 * CELL_WIDTH
    ground = BACKGROUND ** (1 / 2.2)
    tops = []
    for column in range(2):
        front = picture[:BODY_HEIGHT, column * CELL_WIDTH : (column + 1) * CELL_WIDTH]
        drawn = (abs(front - ground) > 0.1).any(axis=2).any(axis=1)
        tops.append(int(drawn.argmax()))
    per_m = BODY_HEIGHT / 2.12
    assert tops[0] - tops[1] == pytest.approx(0.4 * per_m, abs=3)
