"""What white space separates is a word; what cannot be a transcript is refused with its code."""

import pytest

from understudy.errors import InputError, TooLargeError
from understudy.text.transcript import (
    MAX_PUNCTUATION_RUN,
    MAX_WORD_CHARACTERS,
    MAX_WORDS,
    MAX_WRITTEN_CHARACTERS,
    read_transcript,
    with_short_runs,
)


def _texts(text: str) -> list[str]:
    return [word.text for word in read_transcript(text)]


def test_words_are_numbered_from_0_and_keep_their_spelling() -> None:
    words = read_transcript("  “I guess—not…”\tI\u00a0think\r\n— so!  ", max_characters=100)
    assert [word.text for word in words] == ["“I", "guess—not…”", "I", "think", "—", "so!"]
    assert [word.index for word in words] == list(range(6))
    assert all(word.interval is None and word.phones == () for word in words)


def test_a_byte_order_mark_is_no_part_of_the_text() -> None:
    assert _texts("\ufeffHello") == ["Hello"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "text_empty"),
        (" \n\t ", "text_empty"),
        ("a\x00b", "text_control_character"),
        ("a \x1b[31m", "text_control_character"),
        ("a \x85 b", "text_control_character"),
        ("a \uffff", "text_control_character"),
        ("a \ud83d b", "text_surrogate"),
        ("x" * (MAX_WORD_CHARACTERS + 1), "text_word_too_long"),
        ("a." * MAX_WORD_CHARACTERS, "text_word_too_long"),
        ("No" + "!" * MAX_WRITTEN_CHARACTERS, "text_word_too_long"),
        ("N" + "\u0301" * MAX_WRITTEN_CHARACTERS + "o", "text_word_too_long"),
    ],
)
def test_what_is_no_transcript_is_refused(text: str, code: str) -> None:
    with pytest.raises(InputError) as caught:
        read_transcript(text)
    assert caught.value.code == code
    assert caught.value.field == "text"
    assert "\n" not in caught.value.message


def test_limits_hold_just_above_and_not_just_below() -> None:
    assert _texts("x" * MAX_WORD_CHARACTERS) == ["x" * MAX_WORD_CHARACTERS]
    assert len(read_transcript("a b c", max_characters=5)) == 3
    with pytest.raises(TooLargeError, match="6 characters; at most 5") as caught:
        read_transcript("a b cd", max_characters=5)
    assert caught.value.code == "text_too_long"
    assert len(read_transcript("a " * MAX_WORDS)) == MAX_WORDS
    with pytest.raises(TooLargeError, match="2501 words; at most 2500"):
        read_transcript("a " * (MAX_WORDS + 1))


def test_long_runs_of_punctuation_are_accepted_and_shortened_for_parsers() -> None:
    shouted = "No" + "!" * 900
    assert _texts(shouted) == [shouted]
    assert with_short_runs(shouted) == "No" + "!" * MAX_PUNCTUATION_RUN
    assert with_short_runs("_" * 50 + "a" + "?!" * 50) == "_" * 8 + "a" + "?!" * 4
    assert with_short_runs("don't—ever") == "don't—ever"
