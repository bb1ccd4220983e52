"""How a line without a recording is paced, read from `lexicon/pacing.yaml`; every mistake in it is reported at once,
with its place."""

from pathlib import Path
from typing import Annotated, Self

from pydantic import Field, field_validator

from ...yaml_files import Entry, Source

FILE = "pacing.yaml"
ELLIPSIS = "…"

_CLOSING = "\"'“”‘’«»()[]{}*_"
_Pause = Annotated[float, Field(ge=0, le=10, strict=False)]
_Factor = Annotated[float, Field(ge=0.5, le=3, strict=False)]


class PauseTable(Entry):
    """Silences in seconds, and factors of usual durations; comments in the file explain them."""

    begin_s: _Pause
    end_s: _Pause
    between_words_s: _Pause
    pauses_s: dict[str, _Pause]
    before_pause: _Factor
    emphasized: _Factor

    @field_validator("pauses_s")
    @classmethod
    def _single_marks(cls, pauses_s: dict[str, float]) -> dict[str, float]:
        """The pauses by mark; raises ValueError for what is no single punctuation mark."""
        for mark in pauses_s:
            if len(mark) != 1 or mark.isalnum() or mark.isspace():
                raise ValueError(f"{mark!r} is no punctuation mark; give one character")
        return pauses_s

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises AuthoringError with every mistake."""
        return Source(path).validated(cls)

    def after(self, text: str) -> float:
        """The pause after a word as it is written, or in place of one that is punctuation alone; 0 for none."""
        written = text.replace("...", ELLIPSIS).rstrip(_CLOSING)
        marks = written[len(written.rstrip("".join(self.pauses_s))) :]
        return max((self.pauses_s[mark] for mark in marks), default=0.0)
