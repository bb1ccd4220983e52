"""Expressions: BML's words and FACS units in time, on the sides they are for."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.words.speaking import SKELETON, TABLES, faced, shape, shown, still, times
from understudy.model import Channel, Schedule, SyncPoints
from understudy.model.tables import ACTION_UNITS, CORE_LEXEMES
from understudy.realizer.face.blendshapes import ASYMMETRY, face_weights
from understudy.realizer.face.expressions import LEAST_RISE_S, realized_faces, unknown_faces
from understudy.realizer.face.face_tables import INDEX

FASTEST_PER_S = 1.875 / LEAST_RISE_S
"""The speed of a minimum-jerk movement at its middle."""


def test_every_bml_lexeme_and_every_word_of_ours_moves_the_face() -> None:
    still_face = faced()
    for lexeme in CORE_LEXEMES | ACTION_UNITS.keys():
        moved = np.abs(faced(behaviors=(shown(lexeme, amount=1.0),)) - still_face).max(axis=0)
        assert moved.max() > 0.3, lexeme


def test_raised_brows_are_raised_on_both_sides_by_their_amount_at_the_peak() -> None:
    shapes = faced(behaviors=(shown("RAISE_BROWS", amount=0.6),))
    for name in ("browInnerUp", "browOuterUpLeft", "browOuterUpRight"):
        assert shape(shapes, name, 0.4) == pytest.approx(0.6, abs=0.6 * ASYMMETRY + 0.02)


@pytest.mark.parametrize(("lexeme", "name"), [("RAISE_MOUTH_CORNERS", "mouthSmile"), ("RAISE_BROWS", "browOuterUp")])
def test_the_right_side_comes_a_little_later_and_a_little_less(lexeme: str, name: str) -> None:
    left, right = (faced(behaviors=(shown(lexeme, amount=1.0),))[:, INDEX[name + side]] for side in ("Left", "Right"))
    began = [int(np.argmax(course > course.max() / 2)) for course in (left, right)]
    assert 0 < (began[1] - began[0]) / 60 < 0.06
    assert 0.8 * left.max() < right.max() < 0.99 * left.max()


def test_both_eyes_blink_at_once() -> None:
    shapes = faced(behaviors=(shown("BLINK", kind=Channel.EYES),))
    assert np.array_equal(shapes[:, INDEX["eyeBlinkLeft"]] > 0.5, shapes[:, INDEX["eyeBlinkRight"]] > 0.5)


def test_one_brow_is_one_side() -> None:
    shapes = faced(behaviors=(shown("RAISE_RIGHT_BROW", amount=1.0),))
    assert shape(shapes, "browOuterUpRight", 0.6) > 0.9
    assert shape(shapes, "browOuterUpLeft", 0.6) < 0.05


def test_units_have_sides_too() -> None:
    wink = replace(shown("AU46", amount=1.0), direction="LEFT")
    shapes = faced(behaviors=(wink,))
    assert shape(shapes, "eyeBlinkLeft", 0.6) == pytest.approx(1, abs=1e-6)
    assert shape(shapes, "eyeBlinkRight", 0.6) < 0.05


@pytest.mark.parametrize("rate_hz", [24, 30, 60])
@pytest.mark.parametrize("ready_s", [0.3, 0.317, 0.333, 0.341])
def test_a_blink_is_whole_at_its_ready_whatever_the_frame_rate(rate_hz: int, ready_s: float) -> None:
    sync = SyncPoints(start=ready_s - 0.07, ready=ready_s, relax=ready_s, end=ready_s + 0.1)
    blink = replace(shown("BLINK", kind=Channel.EYES), sync=sync)
    times_s = times(1.0, rate_hz)
    shapes = face_weights(TABLES, Schedule((blink,), 1.0), still(times_s), SKELETON, seed=1)
    whole = np.flatnonzero(shapes[:, INDEX["eyeBlinkLeft"]] > 0.999)
    assert len(whole) > 0
    assert -0.002 < times_s[whole[0]] - ready_s < 1 / rate_hz + 1e-9
    assert shapes[-1, INDEX["eyeBlinkLeft"]] < 0.05


def test_the_fastest_faces_are_slowed_to_what_a_face_can() -> None:
    at_once = replace(shown("RAISE_BROWS", amount=1.0), sync=SyncPoints(start=0.5, ready=0.5, relax=0.9, end=0.9))
    shapes = faced(behaviors=(at_once,))
    assert shape(shapes, "browInnerUp", 0.5) > 0.9
    assert np.abs(np.diff(shapes, axis=0)).max() * 60 < FASTEST_PER_S


def test_what_is_told_of_a_face_is_what_it_does() -> None:
    at_once = replace(shown("RAISE_BROWS", amount=1.0), sync=SyncPoints(start=0.5, end=0.9))
    told = realized_faces((at_once, replace(at_once, id="face2", kept=False)), 1 / 60)
    assert told.keys() == {"face1"}
    brow = faced(behaviors=(at_once,))[:, INDEX["browInnerUp"]]
    assert told["face1"].ready is not None
    assert told["face1"].relax is not None
    whole = np.flatnonzero(brow > 0.9) / 60
    assert told["face1"].ready - 0.04 < whole[0] <= told["face1"].ready
    assert told["face1"].relax <= whole[-1] < told["face1"].relax + 0.06
    assert [name for name, _ in told["face1"].in_order()] == ["start", "ready", "relax", "end"]


def test_faces_that_were_dropped_are_not_shown_and_unknown_ones_are_told() -> None:
    lost, unknown = replace(shown("RAISE_BROWS"), kept=False), replace(shown("GRIMACE"), id="face2")
    sideless = replace(shown("AU12"), id="face3", direction="UP")
    assert np.array_equal(faced(behaviors=(lost, unknown, sideless)), faced())
    decisions = unknown_faces(TABLES.lexemes, (lost, unknown, sideless))
    assert [(decision.behavior, decision.action) for decision in decisions] == [
        ("face2", "dropped"),
        ("face3", "dropped"),
    ]
    assert "GRIMACE" in decisions[0].reason
    assert "UP" in decisions[1].reason


def test_an_amount_beyond_the_whole_is_the_whole() -> None:
    beyond, whole = (faced(behaviors=(shown("AU1", amount=amount),)) for amount in (7.0, 1.0))
    assert np.array_equal(beyond, whole)
