"""The whole face: layers that meet, bounds, speed, and that it is never frozen."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.realizer.face.lip_closure import lip_closures
from tests.support.examples import examples
from tests.support.words.speaking import SKELETON, TABLES, faced, middle_s, said, shape, shown, still, times
from understudy.model import Behavior, FloatArray, Interval, Schedule, SyncPoints, Viseme
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.face.blendshapes import face_weights
from understudy.realizer.face.face_tables import INDEX, VISEMES
from understudy.realizer.geometry.rotations import from_axis_angle

FASTEST_PER_S = 37.5
"""A lid that closes in 50 ms at its fastest, by minimum jerk (1.875 / 0.05 s); nothing in the face is faster."""

SENTENCE = "HH AW M EH N IY P IY P AH L V UW D B AO T"


def test_a_smile_goes_on_through_oo_but_smaller_and_never_opens_an_m() -> None:
    smile = shown("RAISE_MOUTH_CORNERS", amount=0.8, start_s=0.1)
    spoken = said("M UW M IY", phone_s=0.12)
    alone, speaking = faced(behaviors=(smile,)), faced(spoken, (smile,))
    at_s = middle_s(spoken, "U")
    assert 0.1 < shape(speaking, "mouthSmileLeft", at_s) < 0.7 * shape(alone, "mouthSmileLeft", at_s)
    assert shape(speaking, "mouthSmileLeft", middle_s(spoken, "I")) > shape(speaking, "mouthSmileLeft", at_s)
    assert all(closure.closed for closure in lip_closures(spoken, speaking, times(2.0)))


@pytest.mark.parametrize("lexeme", ["OPEN_MOUTH", "OPEN_LIPS", "AU10", "AU16", "RAISE_MOUTH_CORNERS"])
def test_no_expression_opens_a_closure(lexeme: str) -> None:
    spoken = said("AA B AA")
    shapes = faced(spoken, (shown(lexeme, amount=1.0),))
    [closure] = lip_closures(spoken, shapes, times(2.0))
    assert closure.closed is not None
    phone = closure.viseme.interval
    assert closure.closed.start_s == pytest.approx(phone.start_s, abs=0.04)


def test_an_open_mouth_is_open_in_silence() -> None:
    shapes = faced(behaviors=(shown("OPEN_MOUTH", amount=1.0),))
    assert shape(shapes, "jawOpen", 0.7) - shape(shapes, "mouthClose", 0.7) > 0.6


def test_weights_stay_between_0_and_1_and_nothing_jumps() -> None:
    everything = tuple(
        replace(shown(lexeme, amount=1.0, start_s=0.1 * (number % 9)), id=f"face{number}")
        for number, lexeme in enumerate(sorted(TABLES.lexemes))
    )
    shapes = faced(said(SENTENCE, phone_s=0.07), everything, end_s=3.0)
    assert shapes.shape == (181, len(SHAPES))
    assert shapes.min() >= 0
    assert shapes.max() <= 1
    assert (shapes[:, INDEX["mouthClose"]] <= shapes[:, INDEX["jawOpen"]] + 1e-12).all()
    assert np.abs(np.diff(shapes, axis=0)).max() * 60 < FASTEST_PER_S


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


def test_frames_between_frames_agree_with_each_other() -> None:
    """The face is a function of time: twice the frame rate passes through the same values."""
    schedule = Schedule((shown("RAISE_BROWS", amount=0.7),), 2.0, visemes=said(SENTENCE, phone_s=0.07))
    slow, fast = (face_weights(TABLES, schedule, still(times(2.0, rate_hz)), SKELETON, seed=1) for rate_hz in (30, 60))
    assert np.allclose(slow, fast[::2], atol=1e-9)


def test_a_long_line_is_made_piece_by_piece_and_the_pieces_fit() -> None:
    long = tuple(viseme for turn in range(30) for viseme in _later(said(SENTENCE, phone_s=0.07), turn * 2.2))
    schedule = Schedule((shown("RAISE_BROWS", start_s=33.5),), 70.0, visemes=long)
    times_s = times(70.0)
    whole = face_weights(TABLES, schedule, still(times_s), SKELETON, seed=1)
    middle = slice(60 * 30, 60 * 40)
    assert np.allclose(
        whole[middle], face_weights(TABLES, schedule, still(times_s[middle]), SKELETON, seed=1), atol=1e-9
    )


def test_what_is_said_later_than_the_horizon_changes_nothing_now() -> None:
    near = said(SENTENCE, phone_s=0.07)
    alone, followed = (faced(spoken, end_s=5.0) for spoken in (near, (*near, *_later(near, 2.5))))
    assert np.allclose(alone[: round(60 * 2.0)], followed[: round(60 * 2.0)], atol=1e-12)


def _later(spoken: tuple[Viseme, ...], delay_s: float) -> tuple[Viseme, ...]:
    return tuple(
        replace(each, interval=Interval(each.interval.start_s + delay_s, each.interval.end_s + delay_s))
        for each in spoken
    )


MOMENTS_S = st.floats(-1, 4)
SPOKEN = st.builds(
    lambda label, start_s, length_s, articulation, opening: Viseme(
        label, Interval(start_s, start_s + length_s), articulation, opening
    ),
    st.sampled_from(VISEMES),
    MOMENTS_S,
    st.floats(0, 1),
    st.floats(0, 1),
    st.floats(0, 1),
)
SHOWN = st.builds(
    lambda lexeme, points_s, amount: replace(
        shown(lexeme, amount=amount), sync=SyncPoints(points_s[0], points_s[3], ready=points_s[1], relax=points_s[2])
    ),
    st.sampled_from(sorted(TABLES.lexemes)),
    st.lists(MOMENTS_S, min_size=4, max_size=4).map(sorted),
    st.floats(0, 1),
)


@examples(60)
@given(st.lists(SPOKEN, max_size=12), st.lists(SHOWN, max_size=8))
def test_whatever_is_said_and_shown_it_is_a_face(spoken: list[Viseme], behaviors: list[Behavior]) -> None:
    """Also visemes that overlap, that have no length, and faces that begin before the first frame."""
    shapes = faced(tuple(spoken), tuple(behaviors), end_s=2.0)
    assert np.isfinite(shapes).all()
    assert shapes.min() >= 0
    assert shapes.max() <= 1
    assert (shapes[:, INDEX["mouthClose"]] <= shapes[:, INDEX["jawOpen"]] + 1e-12).all()


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
