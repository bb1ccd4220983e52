"""The key of a study: what each clip shows. It stays with the experimenter; raters must not see it."""

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
