"""What is compared, and what raters are asked: the main paper's modes (§5), NGS's units and singletons (§4.1)."""

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType

from ..model import Mode

UNITS, SINGLETONS = "U", "S"
"""Gestures joined to units, and each gesture back at rest before the next."""


class Comparison(StrEnum):
    """What differs between the clips of a line."""

    MODES = "modes"
    UNITS = "units"


CONDITIONS: Mapping[Comparison, tuple[str, ...]] = MappingProxyType(
    {Comparison.MODES: tuple(mode.value for mode in Mode), Comparison.UNITS: (UNITS, SINGLETONS)}
)
"""The clips of a line, in the order of the papers' tables."""

LOWEST, HIGHEST = 1, 10
"""The grades of the form: not at all appropriate, very appropriate (§5)."""

NATURAL = "natural"
DIMENSIONS = (NATURAL, "friendly", "nervous", "extroverted", "competent", "trustworthy")
"""In which of two clips the character is more of it (NGS §4.1)."""

UNDECIDED = "undecided"

UNDERSTOOD = "understood"
"""Beside the dimensions: how much of the speech was understood, from 1 (nothing) to 3 (all)."""

MOST_UNDERSTOOD = 3


class Choice(StrEnum):
    """A rater's choice of one clip of a line, or of none."""

    BEST = "best"
    WORST = "worst"
    NEITHER = ""
