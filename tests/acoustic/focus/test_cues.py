"""The cues of words with known length, pitch, level and pauses."""

from dataclasses import replace

import numpy as np

from understudy.acoustic.focus.cues import CUES, cues
from understudy.model import Contours, FloatArray, Interval, Phone, Word

COUNT = 5
WORD_S = 0.3
USUAL_S = {"AA": 0.3}
WORDS = tuple(
    Word(index, "ah", interval, (Phone("AA", interval),))
    for index, interval in enumerate(Interval(index * WORD_S, (index + 1) * WORD_S) for index in range(COUNT))
)
FRAMES = 160
THIRD = slice(60, 90)


def contours(f0_hz: FloatArray | None = None, energy_db: FloatArray | None = None) -> Contours:
    """A level voice where not said otherwise."""
    return Contours(
        np.full(FRAMES, -20.0) if energy_db is None else energy_db,
        np.full(FRAMES, 120.0) if f0_hz is None else f0_hz,
        np.zeros((FRAMES, 12)),
        np.zeros((FRAMES, 40), np.float32),
    )


def of(name: str, words: tuple[Word, ...] = WORDS, heard: Contours | None = None) -> list[float]:
    return [round(value, 3) for value in cues(words, heard or contours(), USUAL_S)[:, CUES.index(name)].tolist()]


def test_a_level_line_has_no_cues_but_its_ends() -> None:
    found = cues(WORDS, contours(), USUAL_S)
    ends = {CUES.index(name) for name in ("first", "last", "phones")}
    assert np.allclose(found[:, [column for column in range(len(CUES)) if column not in ends]], 0)
    assert of("first") == [1, 0, 0, 0, 0]
    assert of("last") == [0, 0, 0, 0, 1]


def test_a_high_word_stands_over_what_is_before_and_after_it() -> None:
    f0_hz = np.full(FRAMES, 120.0)
    f0_hz[THIRD] = 120 * 2 ** (6 / 12)
    high = contours(f0_hz)
    assert of("pitch", heard=high) == [0, 0, 2, 0, 0]
    assert of("pitch over before", heard=high) == [0, 0, 2, -0.667, -0.5]
    assert of("pitch over after", heard=high) == [-0.5, -0.667, 2, 0, 0]


def test_pitch_is_drawn_on_through_what_is_unvoiced_and_errors_of_an_octave_are_limited() -> None:
    f0_hz = np.full(FRAMES, 120.0)
    f0_hz[THIRD] = 0
    assert not any(of("pitch", heard=contours(f0_hz)))
    f0_hz[THIRD] = 120 * 8
    assert max(of("pitch", heard=contours(f0_hz))) == 4.0
    assert not any(of("pitch", heard=contours(np.zeros(FRAMES))))


def test_a_loud_word_and_the_level_of_the_recording() -> None:
    energy_db = np.full(FRAMES, -20.0)
    energy_db[THIRD] = -14.0
    assert of("level", heard=contours(energy_db=energy_db)) == [0, 0, 1, 0, 0]
    assert np.allclose(
        cues(WORDS, contours(energy_db=energy_db), USUAL_S), cues(WORDS, contours(energy_db=energy_db - 30), USUAL_S)
    )


def test_length_is_that_of_phones_or_of_letters_where_these_are_not_known() -> None:
    late = (*WORDS[:-1], replace(WORDS[-1], interval=Interval(1.2, 1.6)))
    lengthened = of("length", tuple(replace(word, phones=()) for word in late))
    assert lengthened[:-1] == [0, 0, 0, 0]
    assert lengthened[-1] > 0
    slow = tuple(
        replace(
            word,
            phones=(Phone("AA", Interval(word.index * WORD_S, word.index * WORD_S + (0.2, 0.3)[word.index == 2])),),
        )
        for word in WORDS
    )
    assert of("longest phone", slow)[2] > 0


def test_pauses_within_the_line_count_for_both_sides() -> None:
    after = tuple(
        replace(word, interval=Interval(word.index * WORD_S + 0.1, (word.index + 1) * WORD_S + 0.1))
        for word in WORDS[3:]
    )
    assert of("pause after", (*WORDS[:3], *after)) == [0, 0, 0.5, 0, 0]
    assert of("pause before", (*WORDS[:3], *after)) == [0, 0, 0, 0.5, 0]


def test_a_single_word_and_words_beyond_the_recording_have_cues() -> None:
    assert cues(WORDS[:1], contours(), USUAL_S).shape == (1, len(CUES))
    beyond = replace(WORDS[1], interval=Interval(5.0, 5.3))
    assert np.isfinite(cues((WORDS[0], beyond), contours(), USUAL_S)).all()
