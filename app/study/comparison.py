"""The comparisons of the papers' studies, and the questions that raters answer.

The main paper compares modes (§5). NGS compares units with singletons (§4.1) and speakers with each other (§3.5). RTS
compares ways to drive motion by a voice (§3.2). AHG announces a test of the affect in the voice (§5). The key of a
study names the line and the condition of each clip; it stays with the experimenter, hidden from raters.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType

from ..model import Mode

UNITS, SINGLETONS = "U", "S"
"""The conditions of `Comparison.UNITS`: gestures joined to units, and gestures with a rest after each."""


class Comparison(StrEnum):
    """What differs between the clips of a line."""

    MODES = "modes"
    UNITS = "units"
    WAYS = "ways"
    AFFECT = "affect"
    SPEAKERS = "speakers"


OFFLINE, LIVE, RANDOM = "offline", "live", "random"
"""A motion model's motion for a complete recording, for a live one, and with units drawn at random (RTS §3.2)."""

BOTH, PROSODY, AFFECT = "both", "prosody", "affect"
"""What drives the motion (AHG §3: S1, S3, S5)."""

CONDITIONS: Mapping[Comparison, tuple[str, ...]] = MappingProxyType(
    {
        Comparison.MODES: tuple(mode.value for mode in Mode),
        Comparison.UNITS: (UNITS, SINGLETONS),
        Comparison.WAYS: (OFFLINE, LIVE, RANDOM),
        Comparison.AFFECT: (BOTH, PROSODY, AFFECT),
        Comparison.SPEAKERS: (),
    }
)
"""The conditions of each comparison, in the order of the papers' tables. The conditions of `Comparison.SPEAKERS` are
the names of the profiles."""

PAIRED = frozenset({Comparison.WAYS, Comparison.AFFECT})
"""Comparisons by pairs of clips: raters choose the better clip, or neither, and say by how much it is better."""

MUCH = 2
"""The end of the preference scale, which runs from -2 (the first clip is much better) to 2 (the second is) (RTS
§3.2)."""

LOWEST, HIGHEST = 1, 10
"""The ends of the rating scale: not at all appropriate, very appropriate (§5)."""

NATURAL = "natural"

DIMENSIONS = (NATURAL, "friendly", "nervous", "extroverted", "competent", "trustworthy")
"""Dimensions by which raters compare the character of two clips (NGS §4.1)."""

UNDECIDED = "undecided"

UNDERSTOOD = "understood"
"""The additional question: how much of the speech was understood, from 1 (nothing) to 3 (all)."""

MOST_UNDERSTOOD = 3


class RaterChoice(StrEnum):
    """A rater's choice of one clip of a line, or of none."""

    BEST = "best"
    WORST = "worst"
    NEITHER = ""


KEY_NAME = "key.csv"
KEY_COLUMNS = ("clip", "line", "condition")


@dataclass(frozen=True, slots=True)
class Shown:
    """The content of a clip: a line in a condition."""

    line: str
    condition: str


Key = Mapping[str, Shown]
"""The content of each clip by the clip's name."""
