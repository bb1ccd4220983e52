from itertools import pairwise

import pytest

from tests.support.shared_data import MOTION_PAGE, needs
from understudy.behavior.speech.visemes import LEAST_ARTICULATION, visemes
from understudy.model import Interval, Phone, Viseme, Word
from understudy.model.tables import OPENINGS, PHONES, SILENCE

FIFTEEN = ["sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "I", "O", "U"]
"""motion.md, "Visemes"."""

CONSONANTS = "P B M F V TH DH T D K G NG CH JH SH ZH S Z N L R HH Y W"
VOWELS = "AA AE AH AO AW AY EH ER EY IH IY OW OY UH UW"
"""The 39 phones of the aligner's dictionary."""


def word(phones: str, *, start_s: float = 0.5, emphasis: float | None = None, index: int = 0) -> Word:
    """A word whose phones take a tenth of a second each."""
    spoken = tuple(
        Phone(label, Interval(start_s + number / 10, start_s + (number + 1) / 10))
        for number, label in enumerate(phones.split())
    )
    return Word(index, phones, Interval(start_s, start_s + len(spoken) / 10 or 0.1), spoken, emphasis=emphasis)


def labels(phones: str) -> list[str]:
    return [shape.label for shape in shapes(word(phones))]


def shapes(*words: Word, duration_s: float = 2.0) -> tuple[Viseme, ...]:
    return visemes(words, duration_s)[0]


def test_the_shapes_are_the_fifteen() -> None:
    assert [SILENCE, *PHONES] == FIFTEEN
    assert OPENINGS.keys() == set(FIFTEEN)
    assert all(0 <= opening <= 1 for opening in OPENINGS.values())


@pytest.mark.parametrize(
    ("phones", "expected"),
    [
        ("M AA S", ["sil", "PP", "aa", "SS", "sil"]),
        ("HH IY", ["sil", "I", "sil"]),
        ("HH", ["sil"]),
        ("AO HH", ["sil", "O", "sil"]),
        ("B P", ["sil", "PP", "sil"]),
        ("S ZH", ["sil", "SS", "CH", "sil"]),
    ],
)
def test_phones_have_their_shapes(phones: str, expected: list[str]) -> None:
    found = labels(phones)
    assert [label for label, last in zip(found, [None, *found], strict=False) if label != last] == expected


def test_every_phone_but_hh_has_a_shape() -> None:
    shaped = [phone for phones in PHONES.values() for phone in phones]
    assert len(shaped) == len(set(shaped))
    assert set(shaped) == {*CONSONANTS.split(), *VOWELS.split()} - {"HH"}


def test_shapes_follow_one_another_from_first_to_last() -> None:
    found = shapes(word("K AE T"), word("S IH T S", start_s=1.2, index=1), duration_s=1.5)
    assert (found[0].interval.start_s, found[-1].interval.end_s) == (0.0, 1.5)
    assert all(one.interval.end_s == other.interval.start_s for one, other in pairwise(found))
    assert all(shape.interval.duration_s > 0 for shape in found)
    assert [shape.label for shape in found if shape.label == SILENCE] == [SILENCE, SILENCE]


@pytest.mark.parametrize(
    ("emphasis", "articulation"),
    [(None, LEAST_ARTICULATION), (0.0, LEAST_ARTICULATION), (0.5, 0.8), (1.0, 1.0)],
)
def test_vowels_open_wider_the_more_the_word_is_emphasised(emphasis: float | None, articulation: float) -> None:
    _, lips, vowel, _ = shapes(word("P AA", emphasis=emphasis))
    assert vowel.articulation == pytest.approx(articulation)
    assert vowel.opening == pytest.approx(OPENINGS["aa"] * articulation)
    assert lips.articulation == 1.0


def test_words_without_phones_are_silent_and_told() -> None:
    mute = Word(0, "so", Interval(0.5, 0.8))
    unspoken = Word(1, "—")
    found, notices = visemes((mute, unspoken), 1.0)
    assert found == (Viseme(SILENCE, Interval(0.0, 1.0), 0.0, 0.0),)
    assert [(notice.code, "1 words" in notice.message, "'so'" in notice.message) for notice in notices] == [
        ("visemes_missing", True, True)
    ]


def test_nothing_passes_the_end() -> None:
    assert shapes(word("AA S"), duration_s=0.55)[-1].interval.end_s == 0.55


@needs(MOTION_PAGE)
def test_the_page_that_says_so_says_so() -> None:
    line = MOTION_PAGE.read_text().split("ARPABET: ")[1].split(".")[0]
    assert line == "; ".join(" ".join((shape, *phones)) for shape, phones in PHONES.items())


def test_the_breath_of_a_p_has_the_shape_of_what_follows() -> None:
    """The aligner's P ends with its breath; the lips have parted at its burst."""
    _, lips, vowel, _ = shapes(word("P AA"))
    assert lips.interval == Interval(0.5, 0.567)
    assert vowel.interval == Interval(0.567, 0.7)


@pytest.mark.parametrize("phones", ["B AA", "M AA"])
def test_lips_part_at_the_end_of_what_has_no_breath(phones: str) -> None:
    _, lips, _, _ = shapes(word(phones))
    assert lips.interval == Interval(0.5, 0.6)


def test_a_p_that_ends_its_word_is_shut_to_its_end() -> None:
    assert shapes(word("AA P"))[2].interval == Interval(0.6, 0.7)
