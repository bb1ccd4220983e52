"""How often and when a listener's head moves, as measured on people, read from `lexicon/acting/head_rates.yaml`.

Probabilities are in [0, 1], times seconds. The file is written by `training/head_rates.py`; all mistakes in it are
reported at once, with their places.
"""

from dataclasses import dataclass
from pathlib import Path

from pydantic import Field

from ...yaml_files import Entry, Source


@dataclass(frozen=True, slots=True)
class HeadRates:
    """The probabilities of a nod at a speaker's pause, of one at punctuation without a pause, and of mirroring a head
    movement; the mean and standard deviation of a nod's delay after the end of the phrase."""

    nods_after_pause: float
    nods_after_phrase: float
    mirrored: float
    delay_s: float
    delay_spread_s: float

    @classmethod
    def load(cls, path: Path) -> "HeadRates":
        """Raises AuthoringError with every mistake."""
        return cls(**Source(path).validated(_HeadRatesFile).model_dump())


class _HeadRatesFile(Entry):
    nods_after_pause: float = Field(ge=0, le=1)
    nods_after_phrase: float = Field(ge=0, le=1)
    mirrored: float = Field(ge=0, le=1)
    delay_s: float = Field(ge=0, le=5)
    delay_spread_s: float = Field(ge=0, le=5)
