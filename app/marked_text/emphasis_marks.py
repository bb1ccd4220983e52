"""Words between asterisks or underlines, as people write emphasis: *so*, **very much**, _not_.

A span may go over several words; every word in it is emphasized. A mark without its counterpart is left as it is.
"""

import re

_OPENING = re.compile(r"^([\"'“‘«(\[]*)(\*{1,3}|_{1,3})(?=[^\W_])")
_CLOSING = re.compile(r"(?<=[\w.,;:!?…])(\*{1,3}|_{1,3})([\"'”’»)\].,;:!?…—–-]*)$")


def without_marks(text: str) -> tuple[str, frozenset[int]]:
    """The text without its marks, with single spaces between words, and the indices of the words they emphasize."""
    words = text.split()
    emphasized: set[int] = set()
    opened = -1
    for index, word in enumerate(words):
        if opened < 0 and _OPENING.search(word):
            opened = index
        if opened >= 0 and _closes(words[opened], word):
            words[opened] = _OPENING.sub(r"\1", words[opened])
            words[index] = _CLOSING.sub(r"\2", words[index])
            emphasized.update(range(opened, index + 1))
            opened = -1
    return (" ".join(words) if emphasized else text), frozenset(emphasized)


def _closes(opening: str, word: str) -> bool:
    """Whether the word ends with the mark with which the other begins."""
    begins, ends = _OPENING.search(opening), _CLOSING.search(word)
    return bool(begins and ends and begins[2] == ends[1])
