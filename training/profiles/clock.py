"""Makes up word times for lines without a recording, from a plain clock of syllables.

English is spoken at about four syllables a second; the last word before a pause is longer. The fractions are our own.
Times are seconds.
"""

import re
from collections.abc import Sequence

from understudy.model import Interval, Word

SYLLABLE_S = 0.2
WORD_S = 0.06
FINAL = 1.35
COMMA_S, SENTENCE_S = 0.22, 0.5
_VOWELS = re.compile(r"[aeiouy]+")


def spoken(words: Sequence[Word], start_s: float = 0.3) -> tuple[Word, ...]:
    """The words with the times at which they would be said, the first at `start_s`."""
    timed = []
    for word in words:
        syllables = max(1, len(_VOWELS.findall(word.text.lower().removesuffix("e"))))
        ends = word.text[-1] in ",.;:!?"
        end_s = start_s + (WORD_S + syllables * SYLLABLE_S) * (FINAL if ends else 1.0)
        timed.append(Word(word.index, word.text, Interval(round(start_s, 3), round(end_s, 3))))
        start_s = end_s + (COMMA_S if word.text.endswith(",") else SENTENCE_S if ends else 0.0)
    return tuple(timed)
