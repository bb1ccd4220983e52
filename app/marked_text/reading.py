"""Reads a text that is to be spoken, whatever marks it has: a text that begins with a tag is XML (`tags`), any other
has at most words between asterisks or underlines (`emphasis_marks`).

Gesture Engine's utterances come from its discourse planner as such XML (Hartmann, Mancini & Pelachaud 2002, §5).
"""

import re
from collections.abc import Callable

from ..model import Speaking
from .emphasis_marks import without_marks
from .spoken_text import SpokenText
from .tag_table import TagTable

_BEGINS_WITH_TAG = re.compile(r"\ufeff?\s*<[A-Za-z_?!]")


def read_marked(text: str, load_table: Callable[[], TagTable]) -> SpokenText:
    """The words of a marked text, numbered as in a plain one, and what its marks say; the table is only
    loaded for tags. Raises InputError `tags_wrong` with line and column."""
    if not _BEGINS_WITH_TAG.match(text):
        plain, emphasized = without_marks(text)
        return SpokenText(plain, Speaking(emphasized=emphasized))
    from .tags import read_tagged  # imported late: few texts have tags

    return read_tagged(text, load_table())
