"""The gesture profile of a speaker (NGS §3.2), learned from annotations or edited by hand.

Probabilities are in [0, 1]; times are seconds; rates are per minute of speech. The semantic tags (NGS §3.2) are
communicative functions, `class` or `class.subtype` ("deixis.self"). The tag of a class is the fallback for unseen
subtypes, `any` for unseen classes.
"""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field

from ..model import PLAIN, Function, Hand
from .annotation.model import PathForm, Position, TaggedWords

ANY_TAG = "any"

FIRST = "first"
"""The predecessor of the first gesture of a recording, in the tables of successors."""


@dataclass(frozen=True, slots=True)
class Spread:
    """A mean and a standard deviation."""

    mean: float
    deviation: float = 0.0


@dataclass(frozen=True, slots=True)
class TagHabit:
    """The number of occurrences of a tag, and P(g∣s) by lexeme; their sum is the probability of any gesture."""

    occurrences: int
    lexemes: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class LexemeHabit:
    """The habit of a lexeme: its share of all gestures, P(hand∣g), its strokes, the time from the end of its word to
    the end of its main stroke, and the share of independent holds."""

    share: float
    hands: Mapping[Hand, float]
    strokes: Spread
    offset_s: Spread
    held: float = 0.0


@dataclass(frozen=True, slots=True)
class Occurrence:
    """An entry of the GestureDB: the start, end and path of the stroke of one observed gesture."""

    lexeme: str
    hand: Hand
    start: Position
    end: Position
    path: PathForm = PathForm.STRAIGHT


@dataclass(frozen=True, slots=True)
class FormHabit:
    """An entry of the animation lexicon: the speaker's own part of a lexeme's form; the rest is the gesture library's.
    `size` scales the movement."""

    size: float = 1.0


@dataclass(frozen=True, slots=True)
class UnitHabit:
    """The habit of units. Gestures in a segment of speech that are nearer than `merge_within_s`, end of stroke to start
    of stroke, are one unit with probability `joined`: after the unit's first gesture, after its second, …; the last
    value applies to all further ones. `sizes` are the shares of units of 1, 2, … 6 and more gestures."""

    merge_within_s: float
    joined: tuple[float, ...]
    sizes: tuple[float, ...]

    def joined_after(self, size: int) -> float:
        """The probability that a unit of this many gestures (at least 1) continues."""
        return self.joined[min(size, len(self.joined)) - 1]


@dataclass(frozen=True, slots=True)
class PhaseHabit:
    """The durations of the phases that a gesture's clip does not determine."""

    preparation_s: Spread
    hold_s: Spread
    retraction_s: Spread
    after_stroke_s: Spread


@dataclass(frozen=True, slots=True)
class RestHabit:
    """The rest poses after a unit by the time until the next one: within `near_s`, after `far_s`, or between."""

    near: str = "clasped"
    medium: str = "at_side"
    far: str = "in_pockets"
    near_s: float = 3.0
    far_s: float = 10.0


@dataclass(frozen=True, slots=True)
class HeadHabit:
    """Head movements per minute of speech by kind, the share of time with gaze at the listener, and the postures of the
    body; None or empty if not annotated."""

    per_minute: Mapping[str, float] = field(default_factory=dict)
    eye_contact: float | None = None
    postures: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Smoothing:
    """The smoothing of probabilities: the strength of each prior, in observations; `held_out` is the log-likelihood by
    which that of tags was chosen, in nats per tag, `blind` the log-likelihood of a table that ignores the tag."""

    tags: float
    sequence: float
    hands: float
    hand_sequence: float
    held_out: float
    blind: float


@dataclass(frozen=True, slots=True)
class Lead:
    """The time by which strokes precede the times derived from the words (NGS §3.3, step 13)."""

    main_s: float = 0.3
    after_s: float = 0.12


@dataclass(frozen=True, slots=True)
class Profile:
    """The gesture profile of one speaker.

    `follows` is P(g_i∣g_i−1) and `hand_follows` the same for hands, with `FIRST` before the first gesture; the
    remaining probability of a row is shared among the values it does not name.
    """

    name: str
    description: str
    annotated_s: float
    gestures: int
    gestures_per_minute: float
    tags: Mapping[str, TagHabit]
    lexemes: Mapping[str, LexemeHabit]
    follows: Mapping[str, Mapping[str, float]]
    hand_follows: Mapping[str, Mapping[Hand, float]]
    units: UnitHabit
    phases: PhaseHabit
    smoothing: Smoothing
    rests: RestHabit = RestHabit()
    head: HeadHabit = HeadHabit()
    forms: Mapping[str, FormHabit] = field(default_factory=dict)
    database: tuple[Occurrence, ...] = ()
    lead: Lead = Lead()

    def tag(self, name: str) -> TagHabit | None:
        """The habit of a tag; the fallbacks are its class and `any`."""
        return self.tags.get(name) or self.tags.get(name.partition(".")[0]) or self.tags.get(ANY_TAG)


def tag_of(function: Function) -> str:
    """The tag of a function: its class, and its subtype where the class has several."""
    return function.class_name if function.subtype == PLAIN else f"{function.class_name}.{function.subtype}"


def tags_of(functions: Iterable[Function]) -> tuple[TaggedWords, ...]:
    """The tags of the kept functions."""
    return tuple(TaggedWords(tag_of(each), each.first, each.last) for each in functions if each.kept)


def every_tag(functions: Mapping[str, Collection[str]]) -> frozenset[str]:
    """The tags that functions can have, by class and subtype; a class alone stands for its subtypes."""
    subtypes = {f"{name}.{subtype}" for name, own in functions.items() for subtype in own if subtype != PLAIN}
    return frozenset({*functions, *subtypes})
