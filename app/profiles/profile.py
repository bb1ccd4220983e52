"""A speaker's way of gesturing (NGS §3.2), as learnt from annotation or edited by hand.

Probabilities are in [0, 1]; times are seconds; rates are a minute of speech. A tag is a communicative function, `class`
or `class.subtype` ("deixis.self"); the tag of a class stands for its subtypes that were not seen, and `any` for classes
that were not.

Communicative functions as semantic tags (NGS §3.2): the thin layer between words and gestures.
"""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field

from ..model import PLAIN, Function, Hand
from .annotation.model import PathForm, Position, TaggedWords

ANY_TAG = "any"

FIRST = "first"
"""What comes before the first gesture of a recording, in the tables of what follows what."""


@dataclass(frozen=True, slots=True)
class Spread:
    """A mean and a standard deviation."""

    mean: float
    deviation: float = 0.0


@dataclass(frozen=True, slots=True)
class TagHabit:
    """How often a tag was met, and P(g∣s) by lexeme: how likely it comes with each; the sum is how likely with any."""

    occurrences: int
    lexemes: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class LexemeHabit:
    """How one gesture is made: its share of all gestures, P(hand∣g), its strokes, how long its main stroke ends after
    its word does, and how often it is an independent hold."""

    share: float
    hands: Mapping[Hand, float]
    strokes: Spread
    offset_s: Spread
    held: float = 0.0


@dataclass(frozen=True, slots=True)
class Occurrence:
    """A gesture that was made, as the GestureDB keeps it: where its stroke started and ended, and by which way."""

    lexeme: str
    hand: Hand
    start: Position
    end: Position
    path: PathForm = PathForm.STRAIGHT


@dataclass(frozen=True, slots=True)
class FormHabit:
    """An entry of the animation lexicon: what of a lexeme's form is the speaker's own, the rest being the library's.
    `size` scales the movement."""

    size: float = 1.0


@dataclass(frozen=True, slots=True)
class UnitHabit:
    """Of gestures that are nearer than `merge_within_s`, end of stroke to start of stroke, in a segment of speech, the
    share `joined` is one unit: of those after a unit's first gesture, after its second, … the last share after all
    that follow. `sizes` are the shares of units of 1, 2, … 6 and more gestures."""

    merge_within_s: float
    joined: tuple[float, ...]
    sizes: tuple[float, ...]

    def joined_after(self, size: int) -> float:
        """How often a unit of so many gestures, 1 at least, goes on."""
        return self.joined[min(size, len(self.joined)) - 1]


@dataclass(frozen=True, slots=True)
class PhaseHabit:
    """How long the phases last that a gesture's clip leaves open."""

    preparation_s: Spread
    hold_s: Spread
    retraction_s: Spread
    after_stroke_s: Spread


@dataclass(frozen=True, slots=True)
class RestHabit:
    """Where the hands rest after a unit, by how soon the next begins: within `near_s`, after `far_s`, or between."""

    near: str = "clasped"
    medium: str = "at_side"
    far: str = "in_pockets"
    near_s: float = 3.0
    far_s: float = 10.0


@dataclass(frozen=True, slots=True)
class HeadHabit:
    """Movements of the head a minute of speech by kind, the share of time in which the eyes are on the listener, and
    the postures between which the body changes; None and empty where nobody marked them."""

    per_minute: Mapping[str, float] = field(default_factory=dict)
    eye_contact: float | None = None
    postures: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Smoothing:
    """How probabilities were smoothed: the strength of each prior, in observations; `held_out` is the log-likelihood
    that chose that of tags, nats a tag, `blind` that of a table which does not tell tags apart."""

    tags: float
    sequence: float
    hands: float
    hand_sequence: float
    held_out: float
    blind: float


@dataclass(frozen=True, slots=True)
class Lead:
    """By how much strokes come before the times that the words give (NGS §3.3, step 13)."""

    main_s: float = 0.3
    after_s: float = 0.12


@dataclass(frozen=True, slots=True)
class Profile:
    """Whose gestures these are.

    `follows` is P(g_i∣g_i−1) and `hand_follows` the same of hands, `FIRST` before the first; what a row does not name
    shares what the row leaves.
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
        """What is known of a tag, else of its class, else of any."""
        return self.tags.get(name) or self.tags.get(name.partition(".")[0]) or self.tags.get(ANY_TAG)


def tag_of(function: Function) -> str:
    """The tag of a function: its class, and its subtype where the class has several."""
    return function.class_name if function.subtype == PLAIN else f"{function.class_name}.{function.subtype}"


def tags_of(functions: Iterable[Function]) -> tuple[TaggedWords, ...]:
    """The tags of the functions that were kept."""
    return tuple(TaggedWords(tag_of(each), each.first, each.last) for each in functions if each.kept)


def every_tag(functions: Mapping[str, Collection[str]]) -> frozenset[str]:
    """The tags that functions can have, by class and subtype; a class alone stands for its subtypes."""
    subtypes = {f"{name}.{subtype}" for name, own in functions.items() for subtype in own if subtype != PLAIN}
    return frozenset({*functions, *subtypes})
