"""Lids and looks follow the eye joints."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.words.speaking import SKELETON, TABLES, shown, still, times
from understudy.model import Behavior, FloatArray, Schedule, SyncPoints
from understudy.realizer.face.face import face_weights
from understudy.realizer.face.face_tables import INDEX
from understudy.realizer.geometry.rotations import from_axis_angle


def turned(axis: tuple[float, float, float], degrees: float, behaviors: tuple[Behavior, ...] = ()) -> FloatArray:
    """The face, in the mean of its frames, of a body whose eyes are turned so."""
    body = still(times(0.5))
    eyes = SKELETON.chain("leftEye", "rightEye")
    body.rotations[:, eyes] = from_axis_angle(axis, np.full((len(body.times_s), 2), np.deg2rad(degrees)))
    return np.asarray(face_weights(TABLES, Schedule(behaviors, 0.5), body, SKELETON, seed=1).mean(axis=0))


def weight(shapes: FloatArray, name: str) -> float:
    return float(shapes[INDEX[name]])


@pytest.mark.parametrize("side", ["Left", "Right"])
def test_lids_go_down_with_the_eyes_and_up_with_them(side: str) -> None:
    down, ahead, up = (turned((1.0, 0.0, 0.0), degrees) for degrees in (25, 0, -25))
    assert weight(down, "eyeLookDown" + side) == pytest.approx(25 / TABLES.eyes.down_deg, abs=0.01)
    assert weight(up, "eyeLookUp" + side) == pytest.approx(25 / TABLES.eyes.up_deg)
    assert weight(down, "eyeBlink" + side) > weight(ahead, "eyeBlink" + side) + 0.05
    assert weight(up, "eyeWide" + side) > weight(ahead, "eyeWide" + side) + 0.05


def test_both_eyes_look_to_the_same_side() -> None:
    left = turned((0.0, 1.0, 0.0), 20)
    assert weight(left, "eyeLookOutLeft") == pytest.approx(20 / TABLES.eyes.out_deg)
    assert weight(left, "eyeLookInRight") == pytest.approx(20 / TABLES.eyes.in_deg)
    assert weight(left, "eyeLookInLeft") == weight(left, "eyeLookOutRight") == 0


def test_a_shut_lid_is_pushed_no_further_by_a_look_down() -> None:
    shut = replace(shown("CLOSE_EYES", amount=1.0), sync=SyncPoints(start=-1.0, ready=-0.5, relax=2.0, end=3.0))
    shapes = turned((1.0, 0.0, 0.0), 25, (shut,))
    assert weight(shapes, "eyeBlinkLeft") == pytest.approx(1)
    assert weight(shapes, "eyeLookDownLeft") == pytest.approx(0)
    assert weight(shapes, "eyeWideLeft") == pytest.approx(0)
