"""An author's edits of one line: plain values, as docs/edits.md describes them.

Edits name nothing by a running number alone. A word is meant by its number and its text, a behaviour by its channel,
the word that it begins on and what it is, a moment by an edge of a word: so edits outlive another recording and other
rules. Offsets are seconds, positive ones later.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import StrEnum

from ..model import Channel, Hand, Level, Mode

MARKS = ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end")
"""The sync points, in the order in which they must fall."""


class Edge(StrEnum):
    """Where in a word."""

    START = "start"
    END = "end"


class WordMark(StrEnum):
    """What an author says of a word: the hands must mean something on it, or hands and head be at rest."""

    IMPORTANT = "important"
    STILL = "still"


class Omission(StrEnum):
    """Why a behaviour is not made: nobody wants it, or nobody wants it now."""

    DELETED = "deleted"
    MUTED = "muted"


@dataclass(frozen=True, slots=True)
class WordReference:
    """A word by its number and its text; without the text the number alone counts."""

    word: int
    text: str | None = None


@dataclass(frozen=True, slots=True)
class MarkPlace:
    """A moment of the line: `offset_s` after an edge of a word."""

    at: WordReference
    offset_s: float = 0.0
    edge: Edge = Edge.START


@dataclass(frozen=True, slots=True)
class Marks:
    """The sync points that were moved, each where it is now; None leaves it to follow the others."""

    start: MarkPlace | None = None
    ready: MarkPlace | None = None
    stroke_start: MarkPlace | None = None
    stroke: MarkPlace | None = None
    stroke_end: MarkPlace | None = None
    relax: MarkPlace | None = None
    end: MarkPlace | None = None

    def in_order(self) -> Iterator[tuple[str, MarkPlace]]:
        """Those that were moved, by name."""
        places = ((name, getattr(self, name)) for name in MARKS)
        return ((name, place) for name, place in places if place is not None)


@dataclass(frozen=True, slots=True)
class BehaviorReference:
    """A behaviour as the line has it without edits.

    `at` is the first of its words. `function` is the class of the function that it shows, `family` what it is meant to
    be read as, `lexeme` its BML word: any one of them that is the same will do. Of several such the one that begins
    nearest to `offset_s` after its word does is meant.
    """

    channel: Channel
    at: WordReference
    function: str | None = None
    family: str | None = None
    lexeme: str | None = None
    offset_s: float | None = None


@dataclass(frozen=True, slots=True)
class BehaviorEdit:
    """What is other about one behaviour: `of` names one of the line's, `add` is the channel of a new one, on word `on`.

    A `lock` has the behaviour made even where the choice would no longer make it, as it is described here.
    """

    of: BehaviorReference | None = None
    add: Channel | None = None
    on: WordReference | None = None
    lexeme: str | None = None
    hand: Hand | None = None
    amount: float | None = None
    direction: str | None = None
    marks: Marks = Marks()
    omit: Omission | None = None
    lock: bool = False

    @property
    def channel(self) -> Channel:
        channel = self.of.channel if self.of else self.add
        assert channel is not None, "an edit is of a behaviour, or adds one"
        return channel

    @property
    def word(self) -> WordReference:
        """The word that the behaviour belongs to."""
        word = self.of.at if self.of else self.on
        assert word is not None, "what is added is on a word"
        return word


@dataclass(frozen=True, slots=True)
class HeardTime:
    """When a word was heard that an author corrects, seconds of the recording."""

    start_s: float
    end_s: float


@dataclass(frozen=True, slots=True)
class WordEdit:
    """What is other about one word: its mark, and its time, seconds of the recording. A corrected time holds for the
    recording in which the word was `heard` then."""

    at: WordReference
    mark: WordMark | None = None
    start_s: float | None = None
    end_s: float | None = None
    heard: HeardTime | None = None


@dataclass(frozen=True, slots=True)
class LineSettings:
    """Options that the author set for this line; None leaves them as they are asked for."""

    character: str | None = None
    agitation: Level | None = None
    seed: int | None = None
    stillness: float | None = None
    mode: Mode | None = None


@dataclass(frozen=True, slots=True)
class Edits:
    """All that an author changed in a line."""

    line: LineSettings = field(default_factory=LineSettings)
    words: tuple[WordEdit, ...] = ()
    behaviors: tuple[BehaviorEdit, ...] = ()


NO_EDITS = Edits()
