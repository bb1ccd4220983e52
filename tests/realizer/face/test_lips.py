"""The mouth speaks: closures, what neighbours do to each other, stress, silence."""

from itertools import pairwise

import numpy as np
import pytest

from benchmarks.realizer.face.lip_closure import SHUT, lip_closures, lip_opening
from tests.support.words.speaking import SKELETON, START_S, TABLES, faced, middle_s, said, shape, still, times
from understudy.behavior.speech import visemes
from understudy.model import FloatArray, Interval, Phone, Schedule, Viseme, Word
from understudy.realizer.face.blendshapes import face_weights
from understudy.realizer.face.face_tables import INDEX, VISEMES, Dominance
from understudy.realizer.face.lips import (
    GLIDES,
    HORIZON_S,
    LEAD_S,
    Segments,
    blend,
    lip_sync,
    viseme_weights,
    with_glides,
)

VOWELS = ["AA", "AE", "IY", "AO", "UW", "ER"]


@pytest.mark.parametrize("vowel", VOWELS)
@pytest.mark.parametrize("consonant", ["P", "B", "M", "F", "V"])
@pytest.mark.parametrize("phone_s", [0.05, 0.08, 0.15])
def test_lips_close_for_every_bilabial_and_labiodental(consonant: str, vowel: str, phone_s: float) -> None:
    spoken = said(f"{vowel} {consonant} {vowel}", phone_s=phone_s)
    times_s = times(2.0)
    [closure] = lip_closures(spoken, faced(spoken), times_s)
    assert closure.closed is not None
    phone = closure.viseme.interval
    assert closure.closed.start_s == pytest.approx(phone.start_s, abs=0.04)
    assert closure.closed.end_s == pytest.approx(phone.end_s, abs=0.04)
    assert closure.closed.start_s < phone.start_s + 0.01, "lips lead the sound"


@pytest.mark.parametrize("vowel", VOWELS)
def test_the_mouth_opens_between_two_closures(vowel: str) -> None:
    spoken = said(f"M {vowel} M")
    opening = lip_opening(faced(spoken))
    assert opening[round(60 * (START_S + 0.15))] > 3 * SHUT


@pytest.mark.parametrize("consonant", ["T", "K", "N", "S"])
def test_a_consonant_takes_the_rounding_of_its_vowel(consonant: str) -> None:
    two, tea = said(f"{consonant} UW"), said(f"{consonant} IY")
    label = two[1].label
    round_, spread = (shape(faced(each), "mouthPucker", middle_s(each, label)) for each in (two, tea))
    assert round_ > spread + 0.1


def test_rounding_begins_before_its_vowel_does() -> None:
    spoken = said("S T UW", phone_s=0.08)
    pucker = faced(spoken)[:, INDEX["mouthPucker"]]
    half = np.flatnonzero(pucker > pucker.max() / 2)[0] / 60
    assert half < START_S + 2 * 0.08 - LEAD_S


def test_a_stressed_vowel_opens_the_jaw_wider() -> None:
    wide, narrow = (faced(said("D AA D", emphasis=ratio)).max(axis=0) for ratio in (1.0, 0.0))
    assert wide[INDEX["jawOpen"]] > 1.3 * narrow[INDEX["jawOpen"]]


def test_vowels_open_the_jaw_in_their_order() -> None:
    peaks = [faced(said(f"T {vowel} T")).max(axis=0)[INDEX["jawOpen"]] for vowel in ("UW", "IY", "EH", "AA")]
    assert peaks == sorted(peaks)


def test_every_vowel_of_usual_length_reaches_most_of_its_shape() -> None:
    for vowel, name in (("UW", "mouthPucker"), ("AO", "mouthFunnel"), ("IY", "mouthStretchLeft")):
        spoken = said(f"D {vowel} D", phone_s=0.09)
        label = spoken[2].label
        whole = TABLES.visemes.targets[VISEMES.index(label), INDEX[name]]
        assert shape(faced(spoken), name, middle_s(spoken, label)) > 0.75 * whole


def test_lips_are_at_rest_before_and_after_speech_and_get_there_smoothly() -> None:
    spoken = said("B AA")
    shapes = faced(spoken)
    opening = lip_opening(shapes)
    assert opening[: round(60 * START_S)].max() < 2 * SHUT
    assert opening[round(60 * (START_S + 0.5)) :].max() < 2 * SHUT
    after = opening[round(60 * (START_S + 0.2)) :]
    assert np.abs(np.diff(after)).max() < 0.1


def test_the_mouth_is_never_more_closed_than_open() -> None:
    shapes = faced(said("P AA F IY M UW B AO V EH P S CH R TH L K"), end_s=3.0)
    assert (shapes[:, INDEX["mouthClose"]] <= shapes[:, INDEX["jawOpen"]] + 1e-12).all()
    assert shapes[:, INDEX["mouthClose"]].max() > 0.05


def test_gaps_between_visemes_are_silence() -> None:
    alone = (Viseme("aa", Interval(0.5, 0.7), 1.0, 1.0), Viseme("O", Interval(1.2, 1.4), 1.0, 0.5))
    speech = lip_sync(TABLES.visemes, alone, times(2.0))
    assert speech.lips[round(60 * 0.95)] > 0.95
    assert speech.lips[round(60 * 0.6)] < 0.05


@pytest.mark.parametrize("gap_s", [0.001, 0.01, 0.03])
def test_a_gap_that_nobody_hears_does_not_shut_the_mouth(gap_s: float) -> None:
    parted = (Viseme("aa", Interval(0.5, 0.7), 1.0, 1.0), Viseme("aa", Interval(0.7 + gap_s, 0.9), 1.0, 1.0))
    opening = lip_sync(TABLES.visemes, parted, times(1.5)).shapes[:, INDEX["jawOpen"]]
    assert opening[round(60 * 0.6) : round(60 * 0.85)].min() > 0.7 * opening.max()


def test_a_face_without_speech_has_its_mouth_shut() -> None:
    speech = lip_sync(TABLES.visemes, (), times(1.0))
    assert np.allclose(speech.lips, 1)
    assert np.allclose(speech.shapes[:, INDEX["jawOpen"]], 0)


def test_visemes_that_overlap_or_come_out_of_order_are_still_a_face() -> None:
    muddled = (Viseme("aa", Interval(0.5, 1.0), 1.0, 1.0), Viseme("O", Interval(0.4, 0.7), 1.0, 0.5))
    assert np.isfinite(lip_sync(TABLES.visemes, muddled, times(2.0)).shapes).all()


SENTENCE = "HH AW M EH N IY P IY P AH L V UW D B AO T"


def test_viseme_weights_are_shares_of_one_mouth() -> None:
    weights = viseme_weights(TABLES.visemes, said(SENTENCE, phone_s=0.07), times(2.5))
    assert weights.shape == (len(times(2.5)), 15)
    assert weights.min() >= 0
    assert np.allclose(weights.sum(axis=1), 1), "a stressed word is articulated wholly"
    half = viseme_weights(TABLES.visemes, said(SENTENCE, emphasis=0.0), times(3.0))
    assert half.sum(axis=1).max() <= 1 + 1e-9
    assert half.sum(axis=1).min() < 0.8


@pytest.mark.parametrize("phone_s", [0.06, 0.07, 0.12])
def test_no_viseme_is_passed_over_and_closures_are_whole(phone_s: float) -> None:
    spoken, times_s = said(SENTENCE, phone_s=phone_s), times(3.0, 120)
    weights = viseme_weights(TABLES.visemes, spoken, times_s)
    for viseme in spoken:
        own = VISEMES.index(viseme.label)
        during = weights[(times_s >= viseme.interval.start_s) & (times_s <= viseme.interval.end_s)]
        assert (during.argmax(axis=1) == own).any(), viseme
        if viseme.label in {"PP", "FF"}:
            assert during[:, own].max() > 0.99


TIMES_S = np.arange(0, 2, 0.001)


def dominance(*strengths: float, before_s: float = 0.03, after_s: float = 0.03) -> Dominance:
    """A kind of segment for each strength, and one articulator."""
    strength = np.array(strengths, dtype=np.float64)[:, None]
    return Dominance(strength, np.full_like(strength, before_s), np.full_like(strength, after_s), np.array([0.02]))


def segments(*ends_s: float) -> Segments:
    """One of each kind, from 0 to the last end."""
    bounds_s = np.array([0.0, *ends_s])
    return Segments(np.arange(len(ends_s)), bounds_s[:-1], bounds_s[1:], np.ones(len(ends_s)))


def course(table: Dominance, said: Segments, *targets: float) -> FloatArray:
    return blend(table, said, np.array(targets)[:, None], np.zeros(1, dtype=np.int64), TIMES_S)[:, 0]


def test_equals_meet_in_the_middle_at_their_bound() -> None:
    values = course(dominance(1, 1), segments(1, 2), 0, 1)
    assert values[1000] == pytest.approx(0.5, abs=0.02)
    assert values[:900].max() < 0.05
    assert values[1100:].min() > 0.95


def test_the_stronger_one_is_heard_beyond_its_bounds() -> None:
    values = course(dominance(1, 20, 1), segments(0.9, 1.1, 2), 0, 1, 0)
    assert values[880] > 0.7
    assert values[1120] > 0.7
    weak = course(dominance(1, 0.1, 1), segments(0.95, 1.05, 2), 0, 1, 0)
    assert weak.max() < 0.35


def test_anticipation_reaches_further_than_carrying_over_when_it_fades_slower() -> None:
    values = course(dominance(1, 1, 1, before_s=0.09, after_s=0.02), segments(0.9, 1.1, 2), 0, 1, 0)
    assert values[850] > values[1150] + 0.1


def test_values_lie_between_their_neighbours_and_do_not_jump() -> None:
    values = course(dominance(1, 30, 0.2, 2), segments(0.5, 0.55, 0.6, 2), 0.2, 0.9, 0.1, 0.4)
    assert values.min() >= 0.1
    assert values.max() <= 0.9
    assert np.abs(np.diff(values)).max() < 0.05


def test_beyond_the_horizon_there_is_nothing() -> None:
    near, far = (course(dominance(1, 1, 90), segments(1, 1 + HORIZON_S, 2), 0, 0, target) for target in (0, 1))
    assert np.array_equal(near[:1000], far[:1000])
    assert far[1990] > 0.9


def test_articulators_mind_their_own_say() -> None:
    table = Dominance(np.array([[1, 1.0], [9, 0.1]]), np.full((2, 2), 0.03), np.full((2, 2), 0.03), np.zeros(2))
    targets = np.array([[0.0, 0.0], [1.0, 1.0]])
    blended = blend(table, segments(1, 2), targets, np.array([0, 1]), TIMES_S)
    assert blended[1000, 0] > 0.8
    assert blended[1000, 1] < 0.2


def word(phones: str, phone_s: float = 0.2) -> Word:
    spoken = tuple(
        Phone(label, Interval(0.5 + k * phone_s, 0.5 + (k + 1) * phone_s)) for k, label in enumerate(phones.split())
    )
    return Word(0, phones, Interval(0.5, spoken[-1].interval.end_s), spoken, 1.0)


def glided(phones: str) -> tuple[Viseme, ...]:
    said = word(phones)
    return with_glides(visemes((said,), 2.0)[0], (said,))


@pytest.mark.parametrize("diphthong", sorted(GLIDES))
def test_a_diphthong_ends_in_the_shape_to_which_it_glides(diphthong: str) -> None:
    _, _, vowel, glide, _, _ = glided(f"T {diphthong} T")
    assert glide.label == GLIDES[diphthong]
    assert vowel.interval.end_s == glide.interval.start_s == pytest.approx(0.82)
    assert glide.interval.end_s == pytest.approx(0.9)
    assert glide.opening < vowel.opening


def test_each_diphthong_of_a_shared_viseme_glides() -> None:
    labels = [viseme.label for viseme in glided("AA AY AW T")]
    assert labels == ["sil", "aa", "I", "aa", "U", "DD", "sil"]


@pytest.mark.parametrize("phones", ["T AA T", "AY AA OW", "HH AW", "P AY"])
def test_no_time_is_lost_or_said_twice(phones: str) -> None:
    shapes = glided(phones)
    assert shapes[0].interval.start_s == 0
    assert shapes[-1].interval.end_s == 2
    for last, following in pairwise(shapes):
        assert last.interval.end_s == pytest.approx(following.interval.start_s)
        assert following.interval.duration_s > 0


def test_visemes_without_phones_are_left_as_they_are() -> None:
    shapes = visemes((word("T AY"),), 2.0)[0]
    assert with_glides(shapes, ()) is shapes


def test_how_ends_rounder_than_ha() -> None:
    how, ha = (word(f"HH {vowel}") for vowel in ("AW", "AA"))
    rounding = []
    for spoken in (how, ha):
        schedule = Schedule((), 2.0, (spoken,), visemes((spoken,), 2.0)[0])
        shapes = face_weights(TABLES, schedule, still(times(2.0)), SKELETON, seed=1)
        rounding.append(shapes[round(60 * 0.85), INDEX["mouthPucker"]])
    assert rounding[0] > rounding[1] + 0.2
