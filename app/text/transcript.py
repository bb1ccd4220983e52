"""Splits a transcript into words at white space, numbered from 0, in the transcript's own spelling.

A dash or an emoticon that stands alone is a word too and keeps its number, though nothing is spoken for it.
"""

import re
import unicodedata

from ..errors import InputError, TooLargeError
from ..model import Word

MAX_CHARACTERS = 20_000
"""Longest transcript accepted."""

MAX_PUNCTUATION_RUN = 8
"""Longest run of punctuation (neither letter nor digit) that is passed to a parser (`with_short_runs`)."""

MAX_WORD_CHARACTERS = 100
"""Longest word accepted, its punctuation runs shortened; tokenizers take quadratic time over longer ones."""

MAX_WORDS = 2500
"""Most words of a transcript, about a quarter of an hour of speech: some rules compare every word with every other."""

MAX_WRITTEN_CHARACTERS = 1000
"""Longest word accepted including its punctuation as written, for the sake of other code that reads it."""

_ALLOWED_CONTROLS = frozenset("\t\n\v\f\r")
_UNWRITABLE = frozenset("\ufffe\uffff")
_LONG_PUNCTUATION_RUN = re.compile(rf"([\W_]{{{MAX_PUNCTUATION_RUN}}})[\W_]+")


def read_transcript(text: str, *, max_characters: int = MAX_CHARACTERS) -> tuple[Word, ...]:
    """The words of `text`, without times.

    A byte order mark at the start is no part of the text. Raises TooLargeError `text_too_long`, and InputError
    `text_surrogate`, `text_control_character` (white space apart), `text_empty` and `text_word_too_long`.
    """
    if len(text) > max_characters:
        raise TooLargeError(
            "text_too_long", f"the text has {len(text)} characters; at most {max_characters} are allowed", field="text"
        )
    text = text.removeprefix("\ufeff")
    for position, character in enumerate(text):
        _check_character(character, position)
    words = tuple(Word(index, word) for index, word in enumerate(text.split()))
    if not words:
        raise InputError("text_empty", "the text has no words; send the words that are spoken", field="text")
    if len(words) > MAX_WORDS:
        message = f"the text has {len(words)} words; at most {MAX_WORDS} are allowed"
        raise TooLargeError("text_too_long", message, field="text")
    for word in words:
        _check_length(word)
    return words


def with_short_runs(word: str) -> str:
    """`word` with every run of punctuation cut to `MAX_PUNCTUATION_RUN` characters, for the parser."""
    return _LONG_PUNCTUATION_RUN.sub(r"\1", word)


def _check_character(character: str, position: int) -> None:
    category = unicodedata.category(character)
    if category == "Cs":
        raise InputError(
            "text_surrogate",
            f"character {position} of the text is the lone surrogate U+{ord(character):04X}; send well-formed Unicode",
            field="text",
        )
    if character in _UNWRITABLE or (category == "Cc" and character not in _ALLOWED_CONTROLS):
        raise InputError(
            "text_control_character",
            f"character {position} of the text is the control character U+{ord(character):04X}; "
            "only spaces, tabs and line breaks may stand between words",
            field="text",
        )


def _check_length(word: Word) -> None:
    for length, most in (
        (len(word.text), MAX_WRITTEN_CHARACTERS),
        (len(with_short_runs(word.text)), MAX_WORD_CHARACTERS),
    ):
        if length > most:
            raise InputError(
                "text_word_too_long",
                f"word {word.index} ({word.text[:20]}…) has {length} characters; separate words by spaces, "
                f"a word may have {most}",
                field="text",
            )
