"""The gesture script (NGS §3.3, step 16): what the hands do, when, and where.

Times are seconds on the performance's clock.
"""

from dataclasses import dataclass

from ...model import Hand, Interval
from ..annotation.model import PathForm, Position


@dataclass(frozen=True, slots=True)
class ScriptedGesture:
    """A gesture: its strokes, the main one first, of which an independent hold (`held`) has one without movement.

    `tag` and words `first` to `last` are what it shows; the stroke falls on `word`. It begins at `start_s`, relaxes at
    `relax_s` and is over at `end_s`, where the next of its unit begins or the hands are at rest. `start` and `end` are
    where the main stroke leads from and to, as the speaker made it once; its point of emphasis is at `emphasis_s`,
    `amount` is its size in [0, 1]. `tracks` are offset tracks that an author added (NGS §3.4), in the words of the
    gesture language. One that is not made says why in `reason`.
    """

    id: str
    lexeme: str
    hand: Hand
    tag: str
    first: int
    last: int
    word: int
    start_s: float
    strokes: tuple[Interval, ...]
    relax_s: float
    end_s: float
    held: bool = False
    emphasis_s: float | None = None
    amount: float | None = None
    start: Position | None = None
    end: Position | None = None
    path: PathForm = PathForm.STRAIGHT
    tracks: tuple[str, ...] = ()
    kept: bool = True
    reason: str | None = None


@dataclass(frozen=True, slots=True)
class ScriptedUnit:
    """Gestures between two rests, by id, and where the hands rest after them."""

    gestures: tuple[str, ...]
    start_s: float
    end_s: float
    rest: str


@dataclass(frozen=True, slots=True)
class GestureScript:
    """What a line's hands do by a profile; gestures in order of time, those that were given up among them."""

    profile: str
    seed: int
    gestures: tuple[ScriptedGesture, ...]
    units: tuple[ScriptedUnit, ...]

    @property
    def made(self) -> tuple[ScriptedGesture, ...]:
        return tuple(gesture for gesture in self.gestures if gesture.kept)
