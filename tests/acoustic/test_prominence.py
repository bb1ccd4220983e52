"""Prominence of syllables with known length and pitch, and of words."""

import math

import numpy as np
import pytest

from understudy.acoustic.stress import BIAS, cues, prominence, with_listeners
from understudy.model import Contours, FloatArray, Interval, Phone, Word

LEVEL_HZ = np.full(400, 120.0)


def contours(f0_hz: FloatArray = LEVEL_HZ, energy_db: FloatArray | None = None) -> Contours:
    """Of even loudness where not said otherwise."""
    count = len(f0_hz)
    return Contours(
        np.full(count, -20.0) if energy_db is None else energy_db,
        f0_hz,
        np.zeros((count, 12)),
        np.zeros((count, 40), np.float32),
    )


def word(index: int, start_s: float, *phones: tuple[str, float]) -> Word:
    """A word whose phones, given with their durations, begin at `start_s`."""
    placed = []
    for label, duration_s in phones:
        placed.append(Phone(label, Interval(start_s, start_s + duration_s)))
        start_s += duration_s
    return Word(index, "word", Interval(placed[0].interval.start_s, start_s), tuple(placed))


def in_a_row(*syllables: tuple[tuple[str, float], ...]) -> tuple[Word, ...]:
    words: list[Word] = []
    for phones in syllables:
        words.append(word(len(words), words[-1].interval.end_s if words and words[-1].interval else 0.0, *phones))
    return tuple(words)


def values(words: tuple[Word, ...], f0_hz: FloatArray = LEVEL_HZ, energy_db: FloatArray | None = None) -> list[float]:
    heard = prominence(words, contours(f0_hz, energy_db))
    return [word.prominence if word.prominence is not None else -1 for word in heard]


SHORT = (("D", 0.05), ("AH", 0.08))
LONG = (("D", 0.08), ("AE", 0.25))


def test_the_longest_word_is_the_most_prominent() -> None:
    found = values(in_a_row(SHORT, LONG, SHORT, SHORT))
    assert found.index(max(found)) == 1
    assert all(0 <= value <= 1 for value in found)


def test_of_equal_words_the_one_on_which_the_voice_rises_is_the_most_prominent() -> None:
    f0_hz = LEVEL_HZ.copy()
    f0_hz[26:39] = np.geomspace(120, 170, 13)
    found = values(in_a_row(SHORT, SHORT, SHORT, SHORT), f0_hz)
    assert found.index(max(found)) == 2


def test_of_equal_words_the_loudest_is_the_most_prominent_however_loud_the_recording() -> None:
    energy_db = np.full(400, -20.0)
    energy_db[13:26] += 8
    found = values(in_a_row(SHORT, SHORT, SHORT, SHORT), energy_db=energy_db)
    assert found.index(max(found)) == 1
    assert values(in_a_row(SHORT, SHORT, SHORT, SHORT), energy_db=energy_db - 30) == pytest.approx(found)


def test_a_flat_voice_has_its_prominent_words_as_well() -> None:
    """Half the differences in length, in log duration: more than half the prominence, in log odds."""
    lively, flat = (
        max(values(in_a_row(SHORT, (("D", 0.05), ("AE", vowel_s)), SHORT, SHORT))) for vowel_s in (0.47, 0.21)
    )
    gains = [math.log(value / (1 - value)) - BIAS for value in (lively, flat)]
    assert gains[0] / 2 < gains[1] < gains[0]


def test_a_deep_fall_tells_no_more_against_a_word_than_a_slight_one() -> None:
    def falling(semitones: float) -> float:
        f0_hz = LEVEL_HZ.copy()
        f0_hz[26:39] = np.linspace(120 * 2 ** (semitones / 24), 120 * 2 ** (-semitones / 24), 13)
        return values(in_a_row(SHORT, SHORT, SHORT, SHORT), f0_hz)[2]

    assert falling(0.5) > falling(1.5)
    assert falling(8.0) >= falling(1.5)


def test_length_before_a_pause_counts_less() -> None:
    steady = in_a_row(SHORT, LONG, SHORT, SHORT, SHORT)
    paused = (*steady[:2], *(word(index, 0.9 + 0.13 * index, *SHORT) for index in (2, 3, 4)))
    assert values(paused)[1] < values(steady)[1]


def test_a_word_is_as_prominent_as_its_most_prominent_syllable() -> None:
    apart = in_a_row(SHORT, LONG, SHORT, SHORT)
    joined = in_a_row((*SHORT, *LONG), SHORT, SHORT)
    assert values(joined)[0] == pytest.approx(values(apart)[1])


def test_the_voice_of_another_pitch_is_as_prominent() -> None:
    words = in_a_row(SHORT, LONG, SHORT)
    assert values(words, 2 * LEVEL_HZ) == pytest.approx(values(words))


def test_words_without_phones_have_no_prominence() -> None:
    words = (Word(0, "—"), *in_a_row(SHORT, LONG)[1:], Word(2, "there", Interval(1.0, 1.2)))
    assert [heard.prominence is None for heard in prominence(words, contours())] == [True, False, True]
    assert prominence((Word(0, "there", Interval(0, 1)),), contours())[0].prominence is None


@pytest.mark.parametrize("f0_hz", [np.zeros(400), np.zeros(1), LEVEL_HZ[:20]])
def test_whispers_and_short_signals_are_judged_by_what_there_is(f0_hz: FloatArray) -> None:
    found = values(in_a_row(SHORT, LONG, SHORT, SHORT), f0_hz)
    assert found.index(max(found)) == 1


def test_cues_are_relative_to_the_utterance() -> None:
    syllables = (Interval(0.0, 0.1), Interval(0.1, 0.4), Interval(0.4, 0.5))
    np.testing.assert_allclose(cues(syllables, contours()).mean(axis=0), 0, atol=1e-12)


def test_a_word_without_a_vowel_is_one_syllable() -> None:
    assert values(in_a_row((("M", 0.3),), SHORT, SHORT))[0] > 0.2


def test_what_listeners_hear_outweighs_syllables_and_words_that_they_did_not_judge_stay() -> None:
    words = tuple(Word(index, "word", prominence=value) for index, value in enumerate((0.3, 0.3, 0.6, None)))
    likely, unlikely, not_judged, without = with_listeners(words, {0: 2.0, 1: -3.0, 3: 2.0})
    assert (likely.prominence or 0) > 0.8
    assert (unlikely.prominence or 1) < 0.1
    assert (not_judged.prominence, without.prominence) == (0.6, None)


def test_syllables_still_count_where_listeners_find_words_alike() -> None:
    words = tuple(Word(index, "word", prominence=value) for index, value in enumerate((0.0, 0.2, 1.0)))
    found = [word.prominence or 0.0 for word in with_listeners(words, dict.fromkeys(range(3), -1.0))]
    assert found == sorted(found)
    assert 0 < found[0] < found[1] < found[2] < 1
