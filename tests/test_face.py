"""The whole face: layers that meet, bounds, speed, and that it is never frozen."""

from dataclasses import replace

import numpy as np
import pytest

from app.bml.faces import ACTION_UNITS, CORE_LEXEMES
from app.model import Channel, Interval, Schedule, SyncPoints, Viseme
from app.realizer.expressions import realized_faces, unknown_faces
from app.realizer.face import ASYMMETRY, face
from app.realizer.face_tables import INDEX
from app.realizer.lip_closure import lip_closures
from app.realizer.motion import SHAPES
from tests.speaking import SKELETON, TABLES, faced, middle_s, said, shape, shown, still, times

FASTEST_PER_S = 36.0
"""A lid that closes in 50 ms at its fastest, by minimum jerk (1.875 / 0.05 s); nothing in the face is faster."""

SENTENCE = "HH AW M EH N IY P IY P AH L V UW D B AO T"


def test_every_bml_lexeme_and_every_word_of_ours_moves_the_face() -> None:
    still_face = faced()
    for lexeme in CORE_LEXEMES | ACTION_UNITS.keys():
        moved = np.abs(faced(behaviors=(shown(lexeme, amount=1.0),)) - still_face).max(axis=0)
        assert moved.max() > 0.3, lexeme


def test_raised_brows_are_raised_on_both_sides_by_their_amount_at_the_peak() -> None:
    shapes = faced(behaviors=(shown("RAISE_BROWS", amount=0.6),))
    for name in ("browInnerUp", "browOuterUpLeft", "browOuterUpRight"):
        assert shape(shapes, name, 0.4) == pytest.approx(0.6, abs=0.6 * ASYMMETRY + 0.02)


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
    shapes = face(TABLES, Schedule((blink,), 1.0), still(times_s), SKELETON, seed=1)
    whole = np.flatnonzero(shapes[:, INDEX["eyeBlinkLeft"]] > 0.999)
    assert len(whole) > 0
    assert -0.002 < times_s[whole[0]] - ready_s < 1 / rate_hz + 1e-9
    assert shapes[-1, INDEX["eyeBlinkLeft"]] < 0.05


def test_a_smile_goes_on_through_oo_but_smaller_and_never_opens_an_m() -> None:
    smile = shown("RAISE_MOUTH_CORNERS", amount=0.8, start_s=0.1)
    spoken = said("M UW M IY", phone_s=0.12)
    alone, speaking = faced(behaviors=(smile,)), faced(spoken, (smile,))
    at_s = middle_s(spoken, "U")
    assert 0.1 < shape(speaking, "mouthSmileLeft", at_s) < 0.7 * shape(alone, "mouthSmileLeft", at_s)
    assert shape(speaking, "mouthSmileLeft", middle_s(spoken, "I")) > shape(speaking, "mouthSmileLeft", at_s)
    assert all(closure.shut for closure in lip_closures(spoken, speaking, times(2.0)))


@pytest.mark.parametrize("lexeme", ["OPEN_MOUTH", "OPEN_LIPS", "AU10", "AU16", "RAISE_MOUTH_CORNERS"])
def test_no_expression_opens_a_closure(lexeme: str) -> None:
    spoken = said("AA B AA")
    shapes = faced(spoken, (shown(lexeme, amount=1.0),))
    [closure] = lip_closures(spoken, shapes, times(2.0))
    assert closure.shut is not None
    phone = closure.viseme.interval
    assert closure.shut.start_s == pytest.approx(phone.start_s, abs=0.04)


def test_an_open_mouth_is_open_in_silence() -> None:
    shapes = faced(behaviors=(shown("OPEN_MOUTH", amount=1.0),))
    assert shape(shapes, "jawOpen", 0.7) - shape(shapes, "mouthClose", 0.7) > 0.6


def test_weights_stay_between_0_and_1_and_nothing_jumps() -> None:
    everything = tuple(
        replace(shown(lexeme, amount=1.0, start_s=0.1 * (number % 9)), id=f"face{number}")
        for number, lexeme in enumerate(sorted(TABLES.words))
    )
    shapes = faced(said(SENTENCE, phone_s=0.07), everything, end_s=3.0)
    assert shapes.shape == (181, len(SHAPES))
    assert shapes.min() >= 0
    assert shapes.max() <= 1
    assert (shapes[:, INDEX["mouthClose"]] <= shapes[:, INDEX["jawOpen"]] + 1e-12).all()
    assert np.abs(np.diff(shapes, axis=0)).max() * 60 < FASTEST_PER_S


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


def test_the_face_is_never_frozen_and_never_restless() -> None:
    shapes = faced(end_s=20.0)
    step = np.abs(np.diff(shapes, axis=0))
    assert step.max(axis=1).min() > 1e-5
    assert shapes.max() < 0.06


def test_a_face_that_is_held_lives() -> None:
    held = replace(shown("RAISE_BROWS", amount=0.8), sync=SyncPoints(start=0.0, ready=0.2, relax=9.0, end=9.3))
    brow = faced(behaviors=(held,), end_s=10.0)[60 : 60 * 8, INDEX["browOuterUpLeft"]]
    assert 0.01 < np.ptp(brow) < 0.1
    assert np.abs(np.diff(brow)).max() > 0


def test_the_same_seed_makes_the_same_face_and_another_another() -> None:
    one, again, other = (
        faced(said(SENTENCE), (shown("RAISE_BROWS"),), end_s=3.0, seed=seed).tobytes() for seed in (1, 1, 2)
    )
    assert one == again
    assert one != other


def test_faces_that_were_dropped_are_not_shown_and_unknown_ones_are_told() -> None:
    lost, unknown = replace(shown("RAISE_BROWS"), kept=False), replace(shown("GRIMACE"), id="face2")
    sideless = replace(shown("AU12"), id="face3", direction="UP")
    assert np.array_equal(faced(behaviors=(lost, unknown, sideless)), faced())
    decisions = unknown_faces(TABLES.words, (lost, unknown, sideless))
    assert [(decision.behavior, decision.action) for decision in decisions] == [
        ("face2", "dropped"),
        ("face3", "dropped"),
    ]
    assert "GRIMACE" in decisions[0].reason
    assert "UP" in decisions[1].reason


def test_an_amount_beyond_the_whole_is_the_whole() -> None:
    beyond, whole = (faced(behaviors=(shown("AU1", amount=amount),)) for amount in (7.0, 1.0))
    assert np.array_equal(beyond, whole)


def test_frames_between_frames_agree_with_each_other() -> None:
    """The face is a function of time: twice the frame rate passes through the same values."""
    schedule = Schedule((shown("RAISE_BROWS", amount=0.7),), 2.0, visemes=said(SENTENCE, phone_s=0.07))
    slow, fast = (face(TABLES, schedule, still(times(2.0, rate_hz)), SKELETON, seed=1) for rate_hz in (30, 60))
    assert np.allclose(slow, fast[::2], atol=1e-9)


def test_a_long_line_is_made_piece_by_piece_and_the_pieces_fit() -> None:
    long = tuple(viseme for turn in range(30) for viseme in _later(said(SENTENCE, phone_s=0.07), turn * 2.2))
    schedule = Schedule((shown("RAISE_BROWS", start_s=33.5),), 70.0, visemes=long)
    times_s = times(70.0)
    whole = face(TABLES, schedule, still(times_s), SKELETON, seed=1)
    middle = slice(60 * 30, 60 * 40)
    assert np.allclose(whole[middle], face(TABLES, schedule, still(times_s[middle]), SKELETON, seed=1), atol=1e-9)


def test_what_is_said_later_than_the_horizon_changes_nothing_now() -> None:
    near = said(SENTENCE, phone_s=0.07)
    alone, followed = (faced(spoken, end_s=5.0) for spoken in (near, (*near, *_later(near, 2.5))))
    assert np.allclose(alone[: round(60 * 2.0)], followed[: round(60 * 2.0)], atol=1e-12)


def _later(spoken: tuple[Viseme, ...], delay_s: float) -> tuple[Viseme, ...]:
    return tuple(
        replace(each, interval=Interval(each.interval.start_s + delay_s, each.interval.end_s + delay_s))
        for each in spoken
    )
