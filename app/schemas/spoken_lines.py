"""A line without a recording, from its marked text and what else came with it (`understudy say`, `POST /perform`
without audio)."""

from collections.abc import Sequence
from dataclasses import replace

from ..marked_text.reading import read_marked
from ..model import Direction, GivenFunction, Line, Timings
from ..models import load_tag_table


def spoken_line(
    text: str,
    timings: Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    direction: Direction | None = None,
) -> Line:
    """The line; what its tags ask for comes beside the functions and notes that were given.

    Raises InputError `tags_wrong`, AuthoringError for the table of tags.
    """
    spoken = read_marked(text, load_tag_table)
    if spoken.demands:
        notes = direction or Direction()
        direction = replace(notes, demands=(*notes.demands, *spoken.demands))
    return Line(None, spoken.text, timings, (*functions, *spoken.functions), direction, spoken.speaking)
