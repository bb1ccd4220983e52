"""The behaviour-to-BML table (paper §3.5), read from lexicon/behaviors.yaml.

An entry gives the channel of a behaviour, its BML lexeme, and the durations of its phases. Times are seconds. All
mistakes in the file are reported at once, with their places.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from pathlib import Path
from types import MappingProxyType
from typing import Annotated

from pydantic import AfterValidator, Field

from ...authored_folders import tables_of
from ...errors import AuthoringError, did_you_mean
from ...model import Channel, Hand, Level
from ...model.limits import Forms
from ...model.tables import ACTION_UNITS, CORE_LEXEMES, GAZE_LEXEMES, GazeDirection
from ...yaml_files import Entry, Source

STROKED = frozenset({Channel.GESTURE, Channel.HEAD})
"""The channels whose behaviours have a stroke; behaviours on the others reach a state, keep it and leave it."""

DRIFTS = ("drift_left", "drift_right", "drift_turn_left", "drift_turn_right", "drift_up", "drift_down")
"""The entries for the head's constant small movement."""

UNASKED = ("blink", "breath", "gaze_opening", "saccade", "look_aside", *DRIFTS)
"""The entries for idle behaviour."""

EMPHASIS_OF_STROKE = 0.61
"""The position of the point of emphasis within the stroke (hand-labelled gestures, docs/references.md)."""


class Anchor(StrEnum):
    """The word of a movement's span that the stroke falls on: the most stressed, the first or the last."""

    STRESSED = "stressed"
    FIRST = "first"
    LAST = "last"


@dataclass(frozen=True, slots=True)
class PhaseDuration:
    """The duration of a phase: at least `shortest_s`, `usual_s` if there is room (a hold: at most `usual_s`)."""

    shortest_s: float
    usual_s: float


@dataclass(frozen=True, slots=True)
class Timing:
    """The phases of a behaviour (paper Table 3); `alignment` is the share of the stroke before the stressed vowel,
    `emphasis` the share before its point of emphasis."""

    preparation: PhaseDuration
    stroke: PhaseDuration
    hold: PhaseDuration
    retraction: PhaseDuration
    alignment: float = 1.0
    emphasis: float = EMPHASIS_OF_STROKE


@dataclass(frozen=True, slots=True)
class BriefGesture:
    """A gesture with a smaller and shorter stroke than usual, for lack of time: its forms by hand, and its timing."""

    timing: Timing
    forms: Mapping[Hand, Forms]


@dataclass(frozen=True, slots=True)
class BehaviorEntry:
    """An entry of the table. A gesture whose `hand` is None takes the hand in use, or the one the character prefers.
    At the levels of agitation `one_hand_at` one hand makes what both make otherwise, at `both_hands_at` both make what
    one does. `forms` are those of the gesture library by hand, where they are known, and `brief` is the gesture with a
    shortened stroke."""

    name: str
    channel: Channel
    lexeme: str
    timing: Timing
    anchor: Anchor = Anchor.STRESSED
    hand: Hand | None = None
    amount: float | None = None
    repetitions: int | None = None
    target: str | None = None
    direction: str | None = None
    one_hand_at: tuple[Level, ...] = ()
    both_hands_at: tuple[Level, ...] = ()
    forms: Mapping[Hand, Forms] = field(default_factory=dict)
    brief: BriefGesture | None = None

    def at(self, level: Level) -> "BehaviorEntry":
        """The entry with the hand, or hands, of that level."""
        if level in self.one_hand_at and self.hand is Hand.BOTH:
            return replace(self, hand=None)
        return replace(self, hand=Hand.BOTH) if level in self.both_hands_at else self


def _in_order(durations: tuple[float, float]) -> tuple[float, float]:
    if durations[0] > durations[1]:
        raise ValueError(f"the shortest ({durations[0]:g}) is longer than the usual ({durations[1]:g})")
    return durations


_Seconds = Annotated[float, Field(ge=0, le=10, allow_inf_nan=False)]
_Durations = Annotated[tuple[_Seconds, _Seconds], AfterValidator(_in_order)]
_Lexeme = Annotated[str, Field(pattern=r"^[A-Z][A-Z0-9_]*$")]
_Amount = Annotated[float, Field(ge=0, le=1)]
_Repetitions = Annotated[int, Field(ge=1, le=10)]
_Name = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]*$")]


class TimingEntry(Entry):
    """A timing as authors write it: [shortest, usual] of each phase."""

    preparation: _Durations
    stroke: _Durations | None = None
    hold: _Durations
    retraction: _Durations
    alignment: float | None = Field(default=None, ge=0, le=1)

    def timing(self) -> Timing:
        return Timing(
            preparation=PhaseDuration(*self.preparation),
            stroke=PhaseDuration(*(self.stroke or (0.0, 0.0))),
            hold=PhaseDuration(*self.hold),
            retraction=PhaseDuration(*self.retraction),
            alignment=1.0 if self.alignment is None else self.alignment,
        )


class BehaviorChange(Entry):
    """What a character may change in an entry; None leaves it as it is."""

    lexeme: _Lexeme | None = None
    timing: str | None = None
    anchor: Anchor | None = None
    hand: Hand | None = None
    amount: _Amount | None = None
    repetitions: _Repetitions | None = None
    target: _Name | None = None
    direction: GazeDirection | None = None


class BehaviorLine(BehaviorChange):
    """An entry as authors write it."""

    channel: Channel
    lexeme: _Lexeme
    timing: str
    one_hand_at: tuple[Level, ...] = ()
    both_hands_at: tuple[Level, ...] = ()


class _TableAddition(Entry):
    """A file of an author's that is added to the table; an entry of the same name takes the place of the table's."""

    timings: dict[_Name, TimingEntry] = Field(default_factory=dict)
    behaviors: dict[_Name, BehaviorLine] = Field(default_factory=dict)


class _TableFile(_TableAddition):
    timings: dict[_Name, TimingEntry]
    behaviors: dict[_Name, BehaviorLine]


@dataclass(frozen=True, slots=True)
class BehaviorTable:
    """The checked lines of the table and its timings, by name."""

    lines: Mapping[str, BehaviorLine]
    timings: Mapping[str, TimingEntry]

    def entry(self, name: str, change: BehaviorChange | None = None) -> BehaviorEntry:
        """The entry `name` with the values of `change`; `mistakes_of` must have found nothing in it."""
        line = changed(self.lines[name], change)
        return BehaviorEntry(
            name=name,
            channel=line.channel,
            lexeme=line.lexeme,
            timing=self.timings[line.timing].timing(),
            anchor=line.anchor or Anchor.STRESSED,
            hand=line.hand,
            amount=line.amount,
            repetitions=line.repetitions,
            target=line.target,
            direction=line.direction,
            one_hand_at=line.one_hand_at,
            both_hands_at=line.both_hands_at,
        )


def load_table(path: Path) -> BehaviorTable:
    """The table with what authors add to it (`tables_of`); raises AuthoringError with every mistake."""
    source, *added = map(Source, tables_of(path))
    file = source.validated(_TableFile)
    mistakes = [
        source.mistake(("behaviors",), f"the behaviour {name!r} is missing; the body needs it for itself")
        for name in UNASKED
        if name not in file.behaviors
    ]
    parts: list[tuple[Source, _TableAddition]] = [(source, file)]
    parts += [(each, each.validated(_TableAddition)) for each in added]
    timings = {name: timing for _source, part in parts for name, timing in part.timings.items()}
    for written, part in parts:
        for name, line in part.behaviors.items():
            mistakes += [
                written.mistake(("behaviors", name, key), message) for key, message in mistakes_of(line, timings)
            ]
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    lines = {name: line for _source, part in parts for name, line in part.behaviors.items()}
    return BehaviorTable(MappingProxyType(lines), MappingProxyType(timings))


def changed(line: BehaviorLine, change: BehaviorChange | None) -> BehaviorLine:
    """The line with the values that are set in `change`; a hand that is set there is the hand at every level."""
    if change is None:
        return line
    at_every_level = {"one_hand_at": (), "both_hands_at": ()} if change.hand else {}
    return line.model_copy(update=change.model_dump(exclude_none=True) | at_every_level)


def mistakes_of(line: BehaviorLine, timings: Mapping[str, TimingEntry]) -> Iterator[tuple[str, str]]:
    """The contradictions in a line: the key at fault, and the message."""
    channel = line.channel
    if line.timing in timings:
        yield from _stroke_mistakes(channel, timings[line.timing])
    else:
        yield "timing", f"unknown timing {line.timing!r}{did_you_mean(line.timing, timings)}"
    for key, channels in _KEYS_OF_CHANNELS.items():
        if getattr(line, key) is not None and channel not in channels:
            yield key, f"{key} is for {' and '.join(sorted(channels))}, this is {channel}"
    yield from _hand_mistakes(line)
    if channel in (Channel.FACE, Channel.EYES) and line.lexeme not in _FACES:
        yield "lexeme", f"no face is called {line.lexeme!r}{did_you_mean(line.lexeme, _FACES)}"
    if channel is Channel.GAZE:
        yield from _gaze_mistakes(line)


_FACES = CORE_LEXEMES | ACTION_UNITS.keys()

_KEYS_OF_CHANNELS: Mapping[str, frozenset[Channel]] = MappingProxyType(
    {
        "hand": frozenset({Channel.GESTURE}),
        "repetitions": frozenset({Channel.HEAD}),
        "amount": frozenset({Channel.GESTURE, Channel.HEAD, Channel.GAZE, Channel.FACE, Channel.EYES}),
        "target": frozenset({Channel.GAZE}),
        "direction": frozenset({Channel.GAZE}),
    }
)


def _hand_mistakes(line: BehaviorLine) -> Iterator[tuple[str, str]]:
    if line.one_hand_at and line.hand is not Hand.BOTH:
        yield "one_hand_at", "one_hand_at is for what both hands make: give it `hand: both`"
    if line.both_hands_at and (line.hand is not None or line.channel is not Channel.GESTURE):
        yield "both_hands_at", "both_hands_at is for gestures without a `hand` of their own"


def _gaze_mistakes(line: BehaviorLine) -> Iterator[tuple[str, str]]:
    if line.lexeme not in GAZE_LEXEMES:
        yield "lexeme", f"a gaze is one of {', '.join(sorted(GAZE_LEXEMES))}, not {line.lexeme!r}"
    if line.target is None:
        yield "target", "a gaze needs a target, such as `listener`"
    if (line.direction is None) != (line.amount is None):
        yield "direction", "direction and amount (the angle in parts of 60 degrees) go together"


def _stroke_mistakes(channel: Channel, timing: TimingEntry) -> Iterator[tuple[str, str]]:
    if channel in STROKED and (timing.stroke is None or timing.alignment is None):
        yield "timing", f"{channel} has a stroke: give its timing `stroke` and `alignment`"
    if channel not in STROKED and timing.stroke is not None:
        yield "timing", f"{channel} has no stroke: its timing may not have one"
