"""Phases around the moment that a behaviour is about, and the manner that the voice has there."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.motion.gesture_clips import gesture
from tests.support.words.utterances import utterance
from understudy.behavior.table.behavior_table import PhaseDuration, Timing
from understudy.behavior.timing.phases import TimingBasis, Window, placed, with_manner
from understudy.model import Channel, Interval, Manner, Utterance, Word

GESTURE = Timing(PhaseDuration(0.2, 0.5), PhaseDuration(0.2, 0.4), PhaseDuration(0.1, 1.0), PhaseDuration(0.1, 0.5))
NOD = Timing(
    PhaseDuration(0.1, 0.2), PhaseDuration(0.2, 0.4), PhaseDuration(0, 0), PhaseDuration(0.1, 0.2), alignment=0.5
)
BROWS = Timing(PhaseDuration(0.1, 0.2), PhaseDuration(0, 0), PhaseDuration(0.2, 2.0), PhaseDuration(0.1, 0.3))

seconds = st.floats(0, 4, allow_nan=False)


def test_with_room_every_phase_has_its_usual_length() -> None:
    sync = placed(TimingBasis(GESTURE, 2.0, 2.6, stroked=True), Window())
    assert sync is not None
    names = dict(sync.in_order())
    assert names == pytest.approx(
        {
            "start": 1.1,
            "ready": 1.6,
            "stroke_start": 1.6,
            "stroke": 1.6 + 0.61 * 0.4,
            "stroke_end": 2.0,
            "relax": 2.6,
            "end": 3.1,
        }
    )


def test_a_nod_is_half_way_at_the_vowel() -> None:
    sync = placed(TimingBasis(NOD, 2.0, 2.6, stroked=True), Window())
    assert sync is not None
    assert (sync.stroke_start, sync.stroke_end, sync.relax) == pytest.approx((1.8, 2.2, 2.2))


def test_what_has_no_stroke_peaks_at_the_word_and_shows_no_inner_points() -> None:
    sync = placed(TimingBasis(BROWS, 2.0, 2.6, stroked=False), Window())
    assert sync is not None
    assert dict(sync.in_order()) == pytest.approx({"start": 1.8, "ready": 2.0, "relax": 2.6, "end": 2.9})


@pytest.mark.parametrize(
    ("from_s", "preparation_s", "stroke_s"), [(1.1, 0.5, 0.4), (1.3, 0.3, 0.4), (1.45, 0.2, 0.35), (1.6, 0.2, 0.2)]
)
def test_before_the_vowel_the_preparation_gives_way_first(from_s: float, preparation_s: float, stroke_s: float) -> None:
    sync = placed(TimingBasis(GESTURE, 2.0, 2.6, stroked=True), Window(from_s))
    assert sync is not None
    assert sync.stroke_end == 2.0
    assert sync.ready == pytest.approx(2.0 - stroke_s)
    assert sync.start == pytest.approx(2.0 - stroke_s - preparation_s)


@pytest.mark.parametrize(
    ("to_s", "relax_s", "end_s"), [(3.1, 2.6, 3.1), (2.8, 2.6, 2.8), (2.5, 2.4, 2.5), (2.2, 2.1, 2.2)]
)
def test_after_the_vowel_the_retraction_gives_way_first(to_s: float, relax_s: float, end_s: float) -> None:
    sync = placed(TimingBasis(GESTURE, 2.0, 2.6, stroked=True), Window(0, to_s))
    assert sync is not None
    assert (sync.stroke_end, sync.relax, sync.end) == pytest.approx((2.0, relax_s, end_s))


@pytest.mark.parametrize("window", [Window(1.61), Window(0, 2.19), Window(1.7, 2.1)])
def test_what_cannot_be_played_is_not_placed(window: Window) -> None:
    assert placed(TimingBasis(GESTURE, 2.0, 2.6, stroked=True), window) is None


def test_a_hold_is_no_longer_than_its_longest() -> None:
    sync = placed(TimingBasis(GESTURE, 2.0, 9.0, stroked=True), Window())
    assert sync is not None
    assert sync.relax == pytest.approx(3.0)


@given(st.sampled_from([GESTURE, NOD, BROWS]), seconds, seconds, seconds, seconds)
def test_whatever_is_placed_is_in_order_and_in_its_window(
    timing: Timing, at_s: float, until_s: float, from_s: float, length_s: float
) -> None:
    window = Window(round(from_s, 3), round(from_s + length_s, 3))
    sync = placed(TimingBasis(timing, at_s, until_s, stroked=timing is not BROWS), window)
    if sync is not None:
        times = [time_s for _, time_s in sync.in_order()]
        assert times == sorted(times)
        assert window.from_s <= sync.start
        assert sync.end <= window.to_s


SOFT, LOUD = Manner(0.8, 0.9, 0.7), Manner(1.3, 1.2, 1.1)


def spoken() -> Utterance:
    words = (Word(0, "not", Interval(1.0, 1.5)), Word(1, "—"), Word(2, "THIS", Interval(1.6, 2.2)))
    return replace(utterance("not — THIS", ""), words=words, manners=(SOFT, SOFT, LOUD))


@pytest.mark.parametrize(("stroke_s", "manner"), [(0.2, SOFT), (1.2, SOFT), (1.54, SOFT), (1.58, LOUD), (5.0, LOUD)])
def test_the_word_nearest_to_the_stroke_decides(stroke_s: float, manner: Manner) -> None:
    (made,) = with_manner((gesture("g1", stroke_s, stroke_s + 0.5),), spoken())
    assert made.manner == manner


def test_other_channels_and_words_without_a_voice_have_none() -> None:
    nod = replace(gesture("h1", 1.2, 1.7), kind=Channel.HEAD)
    assert with_manner((nod,), spoken()) == (nod,)
    beat = gesture("g1", 1.2, 1.7)
    assert with_manner((beat,), replace(spoken(), manners=())) == (beat,)
