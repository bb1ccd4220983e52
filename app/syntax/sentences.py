"""Finds where sentences begin: at punctuation or, in a line without any, after long pauses.

Parsers find sentence boundaries in unpunctuated speech badly (F about 40), so they are given. In a punctuated line a
pause is a hesitation and ends nothing.
"""

import re
from itertools import pairwise

from ..model import Word

LONG_PAUSE_S = 0.5
"""The shortest pause between two words that ends a sentence in an unpunctuated line."""

_CLOSING = "\"'”’)]*"
_ENDS = (".", "!", "?", "…")
_TRAILS_OFF = ("..", "…")
_ABBREVIATION = re.compile(r"\W*((?i:mr|mrs|ms|dr|prof|st|sr|jr|vs|lt|sgt|capt)|[A-HJ-Z]|(\w\.)+\w)\.")
_CAPITAL_FIRST = re.compile(r"[^\w]*[A-Z0-9]")


def sentence_starts(words: tuple[Word, ...]) -> frozenset[int]:
    """The indices of the words that begin a sentence; the first word always does."""
    pairs = tuple(pairwise(words))
    by_punctuation = {following.index for word, following in pairs if _ends_sentence(word.text, following.text)}
    by_pause = {following.index for word, following in pairs if _pause_s(word, following) >= LONG_PAUSE_S}
    is_punctuated = by_punctuation or any(_without_closing(word.text).endswith(_ENDS) for word in words[-1:])
    return frozenset({word.index for word in words[:1]} | (by_punctuation if is_punctuated else by_pause))


def _ends_sentence(text: str, following: str) -> bool:
    """Whether the punctuation after a word ends a sentence; an ellipsis does only before a capital."""
    last = _without_closing(text)
    if not last.endswith(_ENDS) or _ABBREVIATION.fullmatch(text):
        return False
    return not last.endswith(_TRAILS_OFF) or bool(_CAPITAL_FIRST.match(following))


def _without_closing(text: str) -> str:
    """The word without the quotation marks and brackets that close after it."""
    return text.rstrip(_CLOSING)


def _pause_s(word: Word, following: Word) -> float:
    if word.interval is None or following.interval is None:
        return 0.0
    return following.interval.start_s - word.interval.end_s
