"""The phrases and stresses of a line, with hand-made words of .4 s with a vowel in their second half."""

from dataclasses import replace
from itertools import pairwise

import pytest

from tests.support.motion.gesture_clips import gesture
from tests.support.shared_data import MOTION_PAGE, needs
from tests.support.words.by_hand import function, spoken
from understudy.behavior.speech import LEAST_ARTICULATION, emphases_s, expanded_in_rhemes, phrases, visemes
from understudy.model import Function, Interval, Phone, Viseme, Word
from understudy.model.tables import OPENINGS, PHONES, SILENCE


def later(words: tuple[Word, ...], first: int, delay_s: float) -> tuple[Word, ...]:
    """The words with a pause before word `first`."""
    return tuple(
        replace(word, interval=Interval(word.interval.start_s + delay_s, word.interval.end_s + delay_s))
        if word.index >= first and word.interval
        else word
        for word in words
    )


def test_a_phrase_ends_at_a_pause_or_with_a_sentence() -> None:
    words = later(spoken("one two three. Four five", start_s=0.0), 4, 0.3)
    assert [(round(p.start_s, 3), round(p.end_s, 3)) for p in phrases(words)] == [(0, 1.2), (1.2, 1.6), (1.9, 2.3)]


@pytest.mark.parametrize(("pause_s", "count"), [(0.19, 1), (0.21, 2)])
def test_a_pause_of_a_fifth_of_a_second_parts_phrases(pause_s: float, count: int) -> None:
    assert len(phrases(later(spoken("one two"), 1, pause_s))) == count


def test_without_times_there_are_no_phrases() -> None:
    assert phrases((Word(0, "one"),)) == ()


def test_emphases_lie_where_the_vowels_of_emphasised_words_begin() -> None:
    words = spoken("one two three", start_s=0.0, stressed=(0, 2))
    words = (words[0], replace(words[1], stressed_ratio=0.9, prominence=0.9), words[2])
    assert emphases_s(words) == pytest.approx((0.2, 1.0))


RHEME = replace(function("information", "rheme", 1, 4), given=True)


@pytest.mark.parametrize(
    ("function", "asked_s"),
    [
        (RHEME, (0.7, 1.5)),
        (replace(RHEME, last=2), (0.7,)),
        (replace(RHEME, first=3), None),
        (replace(RHEME, given=False), None),
        (replace(RHEME, subtype="theme"), None),
    ],
)
def test_a_gesture_in_a_rheme_strikes_again_on_its_later_emphases(
    function: Function, asked_s: tuple[float, ...] | None
) -> None:
    """Vowels of the emphasised words 0, 1, 2 and 4 begin at .2, .6, 1.0 and 1.8 s; the stroke ends at .3 s, on the
    second word."""
    words = spoken("one two three four five six", start_s=0.0, stressed=(0, 1, 2, 4))
    struck = gesture("g", 0.1, 0.5)
    struck = replace(struck, first=1, last=1, sync=replace(struck.sync, stroke_end=0.3))
    (found,) = expanded_in_rhemes([struck], words, [function])
    assert found.after_strokes_s == (asked_s and pytest.approx(asked_s))


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
