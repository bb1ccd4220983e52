"""An annotation as it is used: what a speaker said and how their hands, head and eyes went with it (NGS §3.1).

Times are seconds from the start of the recording, words are numbered from 0. Phases lie in phrases, phrases in units;
only a unit's retraction belongs to no phrase, for it is the unit's (Kendon).
"""

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from ...model import Hand, Interval, Word


class PhaseKind(StrEnum):
    """What the hand does in a phase; an independent hold is a phrase without a stroke."""

    PREPARATION = "preparation"
    STROKE = "stroke"
    HOLD = "hold"
    INDEPENDENT_HOLD = "independent_hold"
    RETRACTION = "retraction"


class PathForm(StrEnum):
    """The form of a stroke's way."""

    STRAIGHT = "straight"
    CURVED = "curved"


class Swivel(StrEnum):
    """How far the elbow is from the body."""

    TOUCH = "touch"
    NORMAL = "normal"
    OUT = "out"
    RAISED = "raised"


@dataclass(frozen=True, slots=True)
class Position:
    """Where a hand is: sectors across, in height and away from the body, in the gesture language's words (`XP`, `YCC`,
    `ZMiddle`), seen from the hand's own side; and the arm's swivel."""

    sideways: str
    height: str
    depth: str
    swivel: Swivel = Swivel.NORMAL

    def __str__(self) -> str:
        return f"{self.sideways} {self.height} {self.depth} {self.swivel}"


@dataclass(frozen=True, slots=True)
class Phase:
    """A phase and its time."""

    kind: PhaseKind
    interval: Interval


@dataclass(frozen=True, slots=True)
class GesturePhrase:
    """A gesture: its form, the words that it means (`affiliate`, first and last), and its phases in order of time.

    `start` and `end` are where the hand is when the main stroke starts and ends; `tag` is the semantic tag, where the
    annotation says it.
    """

    interval: Interval
    lexeme: str
    hand: Hand
    phases: tuple[Phase, ...]
    path: PathForm = PathForm.STRAIGHT
    start: Position | None = None
    end: Position | None = None
    affiliate: tuple[int, int] | None = None
    tag: str | None = None

    @property
    def strokes(self) -> tuple[Interval, ...]:
        """The main stroke, then the after-strokes; none where the gesture is an independent hold."""
        return tuple(phase.interval for phase in self.phases if phase.kind is PhaseKind.STROKE)

    @property
    def main_s(self) -> Interval:
        """The main stroke, or the independent hold."""
        return next(
            phase.interval for phase in self.phases if phase.kind in (PhaseKind.STROKE, PhaseKind.INDEPENDENT_HOLD)
        )


@dataclass(frozen=True, slots=True)
class Unit:
    """Gestures between two rests, and the pose in which the hands rest after them, where it is said."""

    interval: Interval
    phrases: tuple[GesturePhrase, ...]
    retraction: Interval | None = None
    rest: str | None = None


@dataclass(frozen=True, slots=True)
class LabelledInterval:
    """A stretch of time and what happens in it."""

    interval: Interval
    label: str


@dataclass(frozen=True, slots=True)
class TaggedWords:
    """Words `first` to `last` and their semantic tag."""

    tag: str
    first: int
    last: int


@dataclass(frozen=True, slots=True)
class Annotation:
    """All that was marked in one recording. `segments` are stretches of speech between pauses, first and last words;
    `tags` is None where the file has no such track, so that the words must be understood first. `unread` are the names
    of tracks that say nothing to us."""

    path: Path
    duration_s: float
    words: tuple[Word, ...]
    segments: tuple[tuple[int, int], ...]
    tags: tuple[TaggedWords, ...] | None
    units: tuple[Unit, ...]
    head: tuple[LabelledInterval, ...] = ()
    gaze: tuple[LabelledInterval, ...] = ()
    posture: tuple[LabelledInterval, ...] = ()
    unread: tuple[str, ...] = ()

    @property
    def phrases(self) -> tuple[GesturePhrase, ...]:
        """All gestures in order of time."""
        return tuple(phrase for unit in self.units for phrase in unit.phrases)
