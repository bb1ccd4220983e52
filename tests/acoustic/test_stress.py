"""Stressed ratios from hand-made contours: the frames above the paper's thresholds are counted, per word."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.shipped_rules import shipped_rules
from tests.support.words.utterances import utterance, words_of
from understudy.acoustic.stress import Measure, stress, with_emphasis
from understudy.model import EMPHASISED, Contours, FloatArray, Interval, Utterance, Word
from understudy.rules.derivation import derive_functions

FRAMES = 100


def contours(energy_db: FloatArray | None = None, f0_hz: FloatArray | None = None) -> Contours:
    """A second of even energy and f0, where not given otherwise."""
    count = len(energy_db if energy_db is not None else f0_hz if f0_hz is not None else np.zeros(FRAMES))
    flat = np.full(count, 100.0)
    return Contours(
        energy_db=flat if energy_db is None else energy_db,
        f0_hz=flat if f0_hz is None else f0_hz,
        mfcc=np.zeros((count, 12)),
        mel_db=np.zeros((count, 40), np.float32),
    )


def word(start_s: float, end_s: float, index: int = 0) -> Word:
    return Word(index=index, text="word", interval=Interval(start_s, end_s))


def raised(first: int, last: int, *, base: float = 100.0, by: float = 10.0) -> FloatArray:
    values = np.full(FRAMES, base)
    values[first : last + 1] += by
    return values


def ratios(words: tuple[Word, ...], measured: Contours) -> list[float | None]:
    return [each.stressed_ratio for each in stress(words, measured)[0]]


def test_a_word_has_the_share_of_its_frames_above_a_threshold() -> None:
    loud = raised(20, 24)
    assert ratios((word(0.0, 0.2), word(0.2, 0.3), word(0.15, 0.25)), contours(energy_db=loud)) == [0.0, 0.5, 0.5]


def test_a_frame_is_stressed_by_either_measure_and_counts_once() -> None:
    loud, high = raised(20, 24), raised(22, 27)
    assert ratios((word(0.2, 0.3),), contours(energy_db=loud, f0_hz=high)) == [0.8]


def test_thresholds_are_the_ninetieth_percentiles() -> None:
    _, thresholds = stress((), contours(energy_db=np.arange(101.0), f0_hz=np.arange(200.0, 301.0)))
    assert thresholds.energy_db == pytest.approx(90)
    assert thresholds.f0_hz == pytest.approx(290)


def test_unvoiced_frames_are_no_observations_of_f0() -> None:
    f0_hz = np.concatenate([np.zeros(300), np.linspace(100, 200, 101)])
    _, thresholds = stress((), contours(f0_hz=f0_hz))
    assert thresholds.f0_hz == pytest.approx(190)


def test_a_whisper_is_stressed_by_energy_alone() -> None:
    words, thresholds = stress((word(0.2, 0.3),), contours(energy_db=raised(20, 24), f0_hz=np.zeros(FRAMES)))
    assert thresholds.f0_hz is None
    assert words[0].stressed_ratio == 0.5


def test_nothing_stands_out_of_an_even_voice() -> None:
    assert ratios((word(0.0, 1.0),), contours()) == [0.0]


def test_frames_belong_to_one_word_of_two_that_touch() -> None:
    peak = raised(30, 30)
    assert ratios((word(0.25, 0.30), word(0.30, 0.35)), contours(energy_db=peak)) == [0.0, 0.2]


@pytest.mark.parametrize("interval", [(0.301, 0.309), (0.30, 0.30), (5.0, 6.0)])
def test_a_word_without_a_frame_has_ratio_0(interval: tuple[float, float]) -> None:
    assert ratios((word(*interval),), contours(energy_db=raised(25, 34))) == [0.0]


def test_a_word_that_is_not_timed_stays_as_it_is() -> None:
    untimed = Word(index=0, text="word")
    assert stress((untimed,), contours())[0] == (untimed,)


@given(
    energy_db=st.lists(st.floats(-90, 40), min_size=1, max_size=200),
    start_s=st.floats(0, 2),
    duration_s=st.floats(0, 2),
    gain_db=st.floats(-30, 30),
)
def test_ratios_lie_between_0_and_1_and_do_not_depend_on_the_recording_level(
    energy_db: list[float], start_s: float, duration_s: float, gain_db: float
) -> None:
    whole = np.round(np.array(energy_db))
    words = (word(start_s, start_s + duration_s),)
    (ratio,) = ratios(words, contours(energy_db=whole))
    assert ratio is not None
    assert 0 <= ratio <= 1
    assert ratios(words, contours(energy_db=whole + round(gain_db))) == [ratio]


@given(cut=st.integers(1, FRAMES - 1), seed=st.integers(0, 2**32 - 1))
def test_parts_of_a_span_have_together_as_many_stressed_frames_as_the_whole(cut: int, seed: int) -> None:
    measured = contours(energy_db=np.random.default_rng(seed).normal(size=FRAMES))
    cut_s = cut * 0.01
    before, after, whole = ratios((word(0, cut_s), word(cut_s, 1.0), word(0, 1.0)), measured)
    assert before is not None
    assert after is not None
    assert whole == pytest.approx((before * cut + after * (FRAMES - cut)) / FRAMES)
    assert whole == pytest.approx(0.1)


def heard(ratio: float | None, prominence: float | None) -> Word:
    return Word(0, "so", stressed_ratio=ratio, prominence=prominence)


def emphasis(measure: Measure, ratio: float | None, prominence: float | None) -> float | None:
    return with_emphasis((heard(ratio, prominence),), measure)[0].emphasis


@pytest.mark.parametrize(
    ("measure", "expected"),
    [
        (Measure(above_prominence=0.4), [False, True]),
        (Measure(above_prominence=0.35), [True, True]),
        (Measure("ratio"), [True, False]),
        (Measure("ratio", above_ratio=0.0), [True, True]),
        (Measure("ratio", above_ratio=1.0), [False, False]),
    ],
)
def test_words_are_emphasised_above_the_threshold_of_the_measure_that_is_set(
    measure: Measure, expected: list[bool]
) -> None:
    words = with_emphasis((heard(0.2, 0.4), heard(0.1, 0.41)), measure)
    assert [word.is_emphasised for word in words] == expected


def test_a_word_without_prominence_is_judged_by_its_ratio_and_one_not_heard_not_at_all() -> None:
    assert emphasis(Measure(), 0.3, None) == emphasis(Measure("ratio"), 0.3, 0.9)
    assert emphasis(Measure(), None, None) is None


def test_both_measures_have_their_ends_and_their_thresholds_in_common() -> None:
    for value, expected in ((0.0, 0.0), (0.4, EMPHASISED), (1.0, 1.0)):
        assert emphasis(Measure(above_prominence=0.4), 0.0, value) == expected
        assert emphasis(Measure("ratio", above_ratio=0.4), value, 0.0) == expected


@given(st.floats(0, 1), st.floats(0, 1), st.floats(0, 1))
def test_a_word_that_stands_out_more_has_no_less_emphasis(threshold: float, one: float, other: float) -> None:
    lower, higher = (emphasis(Measure(above_prominence=threshold), 0.0, value) or 0.0 for value in sorted((one, other)))
    assert 0 <= lower <= higher <= 1


def test_the_shipped_rules_emphasise_the_emphasised() -> None:
    words = (replace(word, emphasis=value) for word, value in zip(words_of("so it is"), (0.5, 0.501, 1.0), strict=True))
    functions = derive_functions(shipped_rules(), Utterance(tuple(words), utterance("", "").parse))
    assert [found.first for found in functions if found.class_name == "emphasis"] == [1, 2]
