"""A directed line as it may be given to a performer, with its analysis (`held_out.py`)."""

from dataclasses import dataclass

from understudy.model import Analysis

from .directed import DirectedLine

WORDS, PLAIN, DELIVERED = "words alone", "said plainly", "delivered"


@dataclass(frozen=True, slots=True)
class Case:
    """A line, how it is given, and its analysis."""

    line: DirectedLine
    way: str
    analysis: Analysis
