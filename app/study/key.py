"""What each clip of a study shows, which raters must not know: the file that stays with whoever runs the study."""

from collections.abc import Mapping
from dataclasses import dataclass

KEY_NAME = "key.csv"
KEY_COLUMNS = ("clip", "line", "condition")


@dataclass(frozen=True, slots=True)
class Shown:
    """What a clip shows: a line in a condition."""

    line: str
    condition: str


Key = Mapping[str, Shown]
"""What clips show, by name."""
