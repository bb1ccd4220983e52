"""Finds where sentences begin: at punctuation or, in a line without any, after long pauses.

Parsers find sentence boundaries in unpunctuated speech badly (F about 40), so they are given. In a punctuated line a
pause is a hesitation and ends nothing.
"""

import re
from itertools import pairwise

from ..model import Word

LONG_PAUSE_S = 0.5
"""The shortest pause between two words that ends a sentence in an unpunctuated line."""

_END = re.compile(r"[.!?…]+[\"'”’)\]*]*$")
_TRAILING_OFF = re.compile(r"(\.{2,}|…)[\"'”’)\]*]*$")
_ABBREVIATION = re.compile(r"\W*((?i:mr|mrs|ms|dr|prof|st|sr|jr|vs|lt|sgt|capt)|[A-HJ-Z]|(\w\.)+\w)\.")
_CAPITAL_FIRST = re.compile(r"[^\w]*[A-Z0-9]")


def sentence_starts(words: tuple[Word, ...]) -> frozenset[int]:
    """The indices of the words that begin a sentence; the first word always does."""
    pairs = tuple(pairwise(words))
    by_punctuation = {following.index for word, following in pairs if _ends_sentence(word.text, following.text)}
    by_pause = {following.index for word, following in pairs if _pause_s(word, following) >= LONG_PAUSE_S}
    is_punctuated = by_punctuation or any(_END.search(word.text) for word in words[-1:])
    return frozenset({word.index for word in words[:1]} | (by_punctuation if is_punctuated else by_pause))


def _ends_sentence(text: str, following: str) -> bool:
    """Whether the punctuation after a word ends a sentence; an ellipsis does only before a capital."""
    if not _END.search(text) or _ABBREVIATION.fullmatch(text):
        return False
    return not _TRAILING_OFF.search(text) or bool(_CAPITAL_FIRST.match(following))


def _pause_s(word: Word, following: Word) -> float:
    if word.interval is None or following.interval is None:
        return 0.0
    return following.interval.start_s - word.interval.end_s
