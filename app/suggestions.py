"""Suggests known names in place of one that is not known."""

from collections.abc import Collection, Iterable
from difflib import get_close_matches
from itertools import islice

from .errors import LONGEST_SHOWN

MOST_COMPARED = 5000
"""Known names beyond these are not compared: a file may define any number."""


def nearest_names(name: str, known: Iterable[str], *, most: int = 1) -> tuple[str, ...]:
    """The known names that are like `name`, the nearest first, `most` at most."""
    return tuple(get_close_matches(name[:LONGEST_SHOWN], sorted(islice(known, MOST_COMPARED)), n=most))


def did_you_mean(name: str, known: Collection[str], *, most: int = 1, otherwise: str = "") -> str:
    """The end of a message on an unknown name: a question for the nearest known names, else `otherwise`."""
    near = nearest_names(name, known, most=most)
    return f"; did you mean {' or '.join(map(repr, near))}?" if near else otherwise
