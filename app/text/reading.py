"""Reads a text that is to be spoken, whatever marks it has: a text that begins with a tag is XML (`tags`), any other
has at most words between asterisks or underlines, as people write emphasis: *so*, **very much**, _not_. Such a span may
go over several words; every word in it is emphasized. A mark without its counterpart is left as it is.

Gesture Engine's utterances come from its discourse planner as such XML (Hartmann, Mancini & Pelachaud 2002, §5).
"""

import re
from collections.abc import Callable

from ..model import Speaking
from .tag_table import TagTable
from .tags import SpokenText, read_tagged

_BEGINS_WITH_TAG = re.compile(r"\ufeff?\s*<[A-Za-z_?!]")

_OPENING = re.compile(r"^([\"'“‘«(\[]*)(\*{1,3}|_{1,3})(?=[^\W_])")
_CLOSING = re.compile(r"(?<=[\w.,;:!?…])(\*{1,3}|_{1,3})([\"'”’»)\].,;:!?…—–-]*)$")


def read_marked(text: str, load_table: Callable[[], TagTable]) -> SpokenText:
    """The words of a marked text, numbered as in a plain one, and what its marks say; the table is only
    loaded for tags. Raises InputError `tags_wrong` with line and column."""
    if not _BEGINS_WITH_TAG.match(text):
        plain, emphasized = without_marks(text)
        return SpokenText(plain, Speaking(emphasized=emphasized))
    return read_tagged(text, load_table())


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
