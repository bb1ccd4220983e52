"""Where speech begins and ends, by what is voiced: a stretch of it is a phrase until it has been silent for a while.

Times are seconds of the stream. A phrase's begin is told `BEGIN_FRAMES` voiced frames after it, its end
`PAUSE_FRAMES` after the last voiced one.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from ..model import FRAME_SHIFT_S, FloatArray

BEGIN_FRAMES = 4
"""Fewer voiced frames in a row are a click, and no voice."""

PAUSE_FRAMES = 30


@dataclass(frozen=True, slots=True)
class PhraseEdge:
    """A phrase `begins`, or ends, at `at_s`."""

    at_s: float
    begins: bool


class Phrases:
    """Takes f0 a row each `FRAME_SHIFT_S` (0: unvoiced) and tells where phrases begin and end."""

    def __init__(self) -> None:
        self._frames = self._voiced = 0
        self._silent = PAUSE_FRAMES
        self.began_s: float | None = None
        """Where the phrase began that still goes on."""

    def hear(self, f0_hz: FloatArray) -> tuple[PhraseEdge, ...]:
        return tuple(edge for f0 in f0_hz.tolist() for edge in self._frame(voiced=f0 > 0))

    def _frame(self, *, voiced: bool) -> Iterator[PhraseEdge]:
        self._frames += 1
        self._voiced = self._voiced + 1 if voiced else 0
        self._silent = 0 if voiced else self._silent + 1
        if self.began_s is None and self._voiced == BEGIN_FRAMES:
            self.began_s = (self._frames - BEGIN_FRAMES) * FRAME_SHIFT_S
            yield PhraseEdge(self.began_s, begins=True)
        elif self.began_s is not None and self._silent == PAUSE_FRAMES:
            self.began_s = None
            yield PhraseEdge((self._frames - PAUSE_FRAMES) * FRAME_SHIFT_S, begins=False)
