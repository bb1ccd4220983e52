"""The annotation model: a speaker's words, and the movements of hands, head and eyes that accompany them (NGS §3.1).

Times are seconds from the start of the recording; words are numbered from 0. Phrases consist of phases, units of
phrases. The retraction belongs to the unit and to no phrase (Kendon). Mistakes of all files are reported at once, each
with its file, time and track.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from ...errors import InputError
from ...model import Hand, Interval, Word


class PhaseKind(StrEnum):
    """The kinds of gesture phases; an independent hold replaces the stroke of a phrase."""

    PREPARATION = "preparation"
    STROKE = "stroke"
    HOLD = "hold"
    INDEPENDENT_HOLD = "independent_hold"
    RETRACTION = "retraction"


class PathForm(StrEnum):
    """The form of a stroke's path."""

    STRAIGHT = "straight"
    CURVED = "curved"


class Swivel(StrEnum):
    """The distance of the elbow from the body."""

    TOUCH = "touch"
    NORMAL = "normal"
    OUT = "out"
    RAISED = "raised"


@dataclass(frozen=True, slots=True)
class Position:
    """The position of a hand: its sectors of gesture space across, in height and in depth, in the terms of the gesture
    language (`XP`, `YCC`, `ZMiddle`), relative to the hand's own side; and the swivel of the arm."""

    sideways: str
    height: str
    depth: str
    swivel: Swivel = Swivel.NORMAL

    def __str__(self) -> str:
        return f"{self.sideways} {self.height} {self.depth} {self.swivel}"


@dataclass(frozen=True, slots=True)
class Phase:
    """A gesture phase and its time."""

    kind: PhaseKind
    interval: Interval


@dataclass(frozen=True, slots=True)
class GesturePhrase:
    """A gesture: its form, its lexical affiliate (first and last word), and its phases in order of time.

    `start` and `end` are the positions of the hand at the start and end of the main stroke; `tag` is the semantic tag,
    if annotated.
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
        """The main stroke, then the after-strokes; empty for an independent hold."""
        return tuple(phase.interval for phase in self.phases if phase.kind is PhaseKind.STROKE)

    @property
    def main_s(self) -> Interval:
        """The interval of the main stroke, or of the independent hold."""
        return next(
            phase.interval for phase in self.phases if phase.kind in (PhaseKind.STROKE, PhaseKind.INDEPENDENT_HOLD)
        )


@dataclass(frozen=True, slots=True)
class Unit:
    """The gestures between two rests, and the rest pose after them, if annotated."""

    interval: Interval
    phrases: tuple[GesturePhrase, ...]
    retraction: Interval | None = None
    rest: str | None = None


@dataclass(frozen=True, slots=True)
class LabelledInterval:
    """An interval and its label."""

    interval: Interval
    label: str


@dataclass(frozen=True, slots=True)
class TaggedWords:
    """The words from `first` to `last` and their semantic tag."""

    tag: str
    first: int
    last: int


@dataclass(frozen=True, slots=True)
class Annotation:
    """The annotation of one recording. `segments` are stretches of speech between pauses, as first and last words.
    `tags` is None if there is no track of tags; they are then derived from the words. `unread` are the names of unknown
    tracks."""

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


@dataclass(frozen=True, slots=True)
class AnnotationMistake:
    """A mistake in an annotation; `time_s` is None if it concerns a whole track, `track` is empty if a whole file."""

    path: Path
    message: str
    track: str = ""
    time_s: float | None = None

    def __str__(self) -> str:
        time = "" if self.time_s is None else f" at {self.time_s:.3f} s"
        track = f" {self.track}{time}:" if self.track else ""
        return f"{self.path}:{track} {self.message}"


class AnnotationError(InputError):
    """Mistakes in annotation files; `mistakes` contains all of them."""

    names_places = True

    def __init__(self, mistakes: Iterable[AnnotationMistake]) -> None:
        self.mistakes = tuple(mistakes)
        super().__init__("annotation_wrong", "\n".join(map(str, self.mistakes)), field="annotation")
