"""An author's edits of one line: plain values, as docs/edits.md describes them.

Nothing is identified by a running number alone: a word is identified by its number and its text, a behaviour by its
channel, the word it begins on and what it shows, a moment by the edge of a word. So edits survive a new recording and
changed rules. Offsets are seconds, positive ones later.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import StrEnum

from .body import Channel, Hand
from .choice import Mode
from .voice.affect import AffectTrack
from .voice.speech import Level

MARKS = ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end")
"""The sync points, in the order in which they must fall."""


class Edge(StrEnum):
    """Where in a word."""

    START = "start"
    END = "end"


class WordMark(StrEnum):
    """How a word is marked: the hands must show something on it, or hands and head must rest."""

    IMPORTANT = "important"
    STILL = "still"


class Omission(StrEnum):
    """Why a behaviour is not made: removed for good, or switched off for now."""

    DELETED = "deleted"
    MUTED = "muted"


@dataclass(frozen=True, slots=True)
class WordReference:
    """A word, identified by its number and its text; without a text by its number alone."""

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
    """Where the author moved sync points to; a point that is None follows the others."""

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
    """A behaviour of the unedited line.

    `at` is the first of its words, `function` the class of the function it shows, `family` the gesture family it
    belongs to, `lexeme` its BML lexeme; one of the three has to match. Of several matches the one that begins nearest
    to `offset_s` after the start of its word is taken.
    """

    channel: Channel
    at: WordReference
    function: str | None = None
    family: str | None = None
    lexeme: str | None = None
    offset_s: float | None = None


@dataclass(frozen=True, slots=True)
class BehaviorEdit:
    """A change to one behaviour: `of` identifies an existing one, `add` is the channel of a new one on the word `on`.

    A behaviour with `lock` is made as described here even where it would no longer be chosen.
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
    """When the aligner heard a word whose time the author corrected, in seconds of the recording."""

    start_s: float
    end_s: float


@dataclass(frozen=True, slots=True)
class WordEdit:
    """A change to one word: its mark, or its time in seconds of the recording. A corrected time is valid for the
    recording in which the word was `heard` at that time."""

    at: WordReference
    mark: WordMark | None = None
    start_s: float | None = None
    end_s: float | None = None
    heard: HeardTime | None = None


@dataclass(frozen=True, slots=True)
class LineSettings:
    """Options the author set for this line; None keeps the value of the request."""

    character: str | None = None
    agitation: Level | None = None
    seed: int | None = None
    stillness: float | None = None
    mode: Mode | None = None
    affect: AffectTrack | None = None


@dataclass(frozen=True, slots=True)
class Edits:
    """Everything an author changed in a line."""

    line: LineSettings = field(default_factory=LineSettings)
    words: tuple[WordEdit, ...] = ()
    behaviors: tuple[BehaviorEdit, ...] = ()


NO_EDITS = Edits()
