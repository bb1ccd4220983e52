"""Diphthongs glide to their second vowel, wherever visemes are shared or cut."""

from itertools import pairwise

import pytest

from tests.support.words.speaking import SKELETON, TABLES, still, times
from understudy.behavior.speech.visemes import visemes
from understudy.model import Interval, Phone, Schedule, Viseme, Word
from understudy.realizer.face.diphthongs import GLIDES, with_glides
from understudy.realizer.face.face import face_weights
from understudy.realizer.face.face_tables import INDEX


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
    for said in (how, ha):
        schedule = Schedule((), 2.0, (said,), visemes((said,), 2.0)[0])
        shapes = face_weights(TABLES, schedule, still(times(2.0)), SKELETON, seed=1)
        rounding.append(shapes[round(60 * 0.85), INDEX["mouthPucker"]])
    assert rounding[0] > rounding[1] + 0.2
