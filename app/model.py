"""The values that travel through a performance, from the audio to the schedule.

Conventions: times are seconds from the start of the audio. Words are what white space separates in the transcript,
numbered from 0; `first` and `last` are word numbers, both included. Everything here is frozen: a stage that changes
a value returns a changed copy (`dataclasses.replace`).
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.floating]
SingleArray = NDArray[np.float32]

SAMPLE_RATE_HZ = 16_000
"""The rate at which every signal travels between the stages."""

FRAME_SHIFT_S = 0.010
"""One analysis frame every 10 ms: frame k is centred on k × 10 ms (paper §3.1.1, §3.1.2)."""

EMPHASISED = 0.5
"""A word's emphasis above which it counts as emphasised."""

PLAIN = "plain"
"""The subtype of a function whose class has none; it leaves as the empty string."""


class Level(StrEnum):
    """The speaker's agitation (paper §3.1): lax, modal or tense voice."""

    LOW = "low"
    MEDIUM = "medium"
    HIGH = "high"


class Channel(StrEnum):
    """The part of the body a behaviour occupies; two behaviours compete only on the same channel."""

    GESTURE = "gesture"
    HEAD = "head"
    GAZE = "gaze"
    FACE = "face"
    EYES = "eyes"
    POSTURE = "posture"


class Mode(StrEnum):
    """Where the gestures come from, as in the paper's study (§5): the meaning, the stress, or chance."""

    SEMANTIC = "semantic"
    PROSODY = "prosody"
    RANDOM = "random"


class Hand(StrEnum):
    """Which hand a gesture takes."""

    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"


@dataclass(frozen=True, slots=True)
class Interval:
    """A stretch of time, in seconds from the start of the audio."""

    start_s: float
    end_s: float

    @property
    def duration_s(self) -> float:
        return self.end_s - self.start_s


@dataclass(frozen=True, slots=True)
class Notice:
    """Something degraded, dropped or guessed on the way; `code` is stable, `message` is for people."""

    code: str
    message: str


@dataclass(frozen=True, slots=True, eq=False)
class Audio:
    """One mono signal at `SAMPLE_RATE_HZ`; full scale is ±1. Single precision once decoded, as fine as 24 bits."""

    samples: FloatArray

    @property
    def duration_s(self) -> float:
        return len(self.samples) / SAMPLE_RATE_HZ


@dataclass(frozen=True, slots=True)
class Phone:
    """A speech sound: ARPABET label without digit; `stress` is 0, 1 or 2 on vowels, None on consonants."""

    label: str
    interval: Interval
    stress: int | None = None


@dataclass(frozen=True, slots=True)
class Word:
    """A word of the transcript; without audio it has no interval, no phones and nothing of what follows.

    How it stands out, in [0, 1]: the stressed ratio is the paper's (§3.1.5), prominence is ours and needs phones, and
    emphasis is whichever of them is set, on a scale of its own (`understudy.acoustic.stress.emphasis`), by which all
    else goes. `spread` tells that its times were guessed from loudness alone.
    """

    index: int
    text: str
    interval: Interval | None = None
    phones: tuple[Phone, ...] = ()
    stressed_ratio: float | None = None
    prominence: float | None = None
    emphasis: float | None = None
    spread: bool = False

    @property
    def is_emphasised(self) -> bool:
        return self.emphasis is not None and self.emphasis > EMPHASISED


@dataclass(frozen=True, slots=True)
class Filler:
    """A sound of hesitation ("um", "uh") that was heard and is no word of the transcript."""

    text: str
    interval: Interval


@dataclass(frozen=True, slots=True, eq=False)
class Contours:
    """One row a frame (`FRAME_SHIFT_S`): energy in dB, f0 in Hz (0: unvoiced), 12 MFCC, and their Mel bands in dB."""

    energy_db: FloatArray
    f0_hz: FloatArray
    mfcc: FloatArray
    mel_db: SingleArray


@dataclass(frozen=True, slots=True)
class StressThresholds:
    """The utterance's own 90th percentiles (paper §3.1.5); `f0_hz` is None when no frame is voiced."""

    energy_db: float
    f0_hz: float | None


@dataclass(frozen=True, slots=True)
class Agitation:
    """Memberships of the three levels (paper §3.1.4), in [0, 1], summing to 1."""

    low: float
    medium: float
    high: float

    @property
    def level(self) -> Level:
        """The level of maximal membership; the calmer one on a tie."""
        return max(Level, key=lambda level: float(getattr(self, level.value)))


@dataclass(frozen=True, slots=True)
class Token:
    """A unit of the parser: a transcript word or a part of one ("do" and "n't" both have the word of "don't"). `head`
    is the index of the governing token (its own index at a root); labels are Universal Dependencies'."""

    index: int
    word: int
    text: str
    lemma: str
    part_of_speech: str
    tag: str
    dependency: str
    head: int


@dataclass(frozen=True, slots=True)
class Phrase:
    """A noun phrase or verb group: words `first` to `last`, `head` the word that governs it."""

    kind: str
    first: int
    last: int
    head: int


@dataclass(frozen=True, slots=True)
class Clause:
    """A clause: words `first` to `last`, `head` its predicate, `label` its relation to its parent."""

    label: str
    first: int
    last: int
    head: int


@dataclass(frozen=True, slots=True)
class Parse:
    """The syntactic structure of an utterance (paper §3.2), phrases and clauses in order of `first`."""

    tokens: tuple[Token, ...]
    phrases: tuple[Phrase, ...]
    clauses: tuple[Clause, ...]


@dataclass(frozen=True, slots=True)
class Utterance:
    """All that is known of a line before its meaning is sought; `agitation` is None when nothing was heard. `fillers`
    are in order of time, each between two words or at an end of the line.

    Where a performance begins `lead_in_s` before the recording, all times are on its clock and `duration_s` is both.
    """

    words: tuple[Word, ...]
    parse: Parse
    agitation: Agitation | None = None
    thresholds: StressThresholds | None = None
    duration_s: float | None = None
    fillers: tuple[Filler, ...] = ()
    lead_in_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Because:
    """One support of a derivation: a word of the transcript, or a fact with the rule that derived it (None: given)."""

    word: int | None = None
    fact: str | None = None
    rule: str | None = None


@dataclass(frozen=True, slots=True)
class Function:
    """A communicative function (paper §3.3): what words `first` to `last` do, how much it matters, and why we think so.

    A function that lost a conflict stays, with `kept` false and the winner's id in `lost_to`. `given` tells that it was
    not derived but came with the line.
    """

    id: str
    class_name: str
    subtype: str
    first: int
    last: int
    priority: float
    rule: str
    because: tuple[Because, ...] = ()
    kept: bool = True
    lost_to: str | None = None
    given: bool = False


@dataclass(frozen=True, slots=True)
class GivenFunction:
    """A function that the caller already knows; `priority` None is above all that rules derive."""

    class_name: str
    subtype: str
    first: int
    last: int
    priority: float | None = None


@dataclass(frozen=True, slots=True)
class DirectedMoment:
    """A director's note: over words `first` to `last` the body should mean something, the hand's stroke on `stroke`.

    `gesture` are families of gestures (docs/directing.md), any of which would be right, the best first; `head`, `face`
    and `gaze` likewise. An empty tuple leaves the channel to the rules, ("still",) keeps it still. `importance` is 1
    (nice) to 3 (the line fails without it).
    """

    first: int
    last: int
    stroke: int
    importance: int = 2
    gesture: tuple[str, ...] = ()
    head: tuple[str, ...] = ()
    face: tuple[str, ...] = ()
    gaze: tuple[str, ...] = ()
    idea: str = ""


@dataclass(frozen=True, slots=True)
class Avoidance:
    """A director's note: over words `first` to `last` none of `what` (families of any channel; "hands" and "any" are
    all of the hands, or of everything)."""

    first: int
    last: int
    what: tuple[str, ...]
    why: str = ""


@dataclass(frozen=True, slots=True)
class Direction:
    """A director's notes on a line. `complete` tells that the hands do nothing but what the notes say."""

    moments: tuple[DirectedMoment, ...] = ()
    avoid: tuple[Avoidance, ...] = ()
    complete: bool = False


@dataclass(frozen=True, slots=True)
class Term:
    """One reason for or against a choice: a fact about the words, and what it weighs (log-odds)."""

    name: str
    weight: float


@dataclass(frozen=True, slots=True)
class Rejected:
    """What a moment might have been and is not: the families that lost, what they would have been worth, and why."""

    families: tuple[str, ...]
    worth: float
    reason: str


@dataclass(frozen=True, slots=True)
class Moment:
    """Words `first` to `last`, over which one channel means something; a gesture's stroke falls on word `stroke`.

    `families` are what it may mean, the likeliest first, `shares` how likely each is to be what a director wants there.
    `importance` ranks the moments of a line. `terms` made the first family win, the heaviest first; `rejected` lost to
    it. `note` is the number of the director's note it comes from, if any; `set_against` is the word of the stroke that
    shows the other side of its contrast.
    """

    id: str
    channel: Channel
    first: int
    last: int
    stroke: int
    families: tuple[str, ...]
    importance: float
    shares: tuple[float, ...] = ()
    terms: tuple[Term, ...] = ()
    rejected: tuple[Rejected, ...] = ()
    note: int | None = None
    set_against: int | None = None


@dataclass(frozen=True, slots=True)
class Movement:
    """A behaviour class, `name` in its table, that could show a function (paper §3.4), clock and neighbours aside.

    Its stroke falls on word `stroke`; where that is None, on the word of its span that the table says. `moment` is the
    id of the moment it makes visible, `target` what it is at if not what the table says.
    """

    name: str
    first: int
    last: int
    priority: float
    rule: str
    function: str | None
    stroke: int | None = None
    moment: str | None = None
    target: str | None = None


@dataclass(frozen=True, slots=True)
class Alternative:
    """Movements that show a function together, or any part of them (paper §3.4).

    `weight` is how often a rule wants them, `lot` the luck they drew (exponential, mean 1). Where nothing else speaks
    for one of several alternatives the smallest `lot / weight` wins, which takes each in proportion to its weight.
    """

    movements: tuple[Movement, ...]
    weight: float
    lot: float


@dataclass(frozen=True, slots=True)
class BehaviorCandidates:
    """A function or a moment that wants to be shown, and all that could show it; at least one alternative."""

    function: Function | None
    alternatives: tuple[Alternative, ...]
    moment: Moment | None = None

    @property
    def priority(self) -> float:
        """What is shown first where not all can be: a moment by what it is worth, a function by its priority."""
        return max(movement.priority for alternative in self.alternatives for movement in alternative.movements)

    @property
    def rank(self) -> tuple[float, int, int, str]:
        """Sorts candidates: the most important first, then by their words."""
        shown = self.moment or self.function
        assert shown is not None, "candidates show something"
        return -self.priority, shown.first, shown.last, shown.id


@dataclass(frozen=True, slots=True)
class SyncPoints:
    """When a behaviour's phases fall (paper §3.8, Table 3). Only gestures and head movements have the inner five;
    faces and gazes have `ready` (the peak, the target reached) and `relax`."""

    start: float
    end: float
    ready: float | None = None
    stroke_start: float | None = None
    stroke: float | None = None
    stroke_end: float | None = None
    relax: float | None = None

    def in_order(self) -> Iterator[tuple[str, float]]:
        """The points that are set, by name, in the order in which they must fall."""
        for name in ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"):
            time_s = getattr(self, name)
            if time_s is not None:
                yield name, time_s

    def shifted(self, delay_s: float) -> "SyncPoints":
        """The same phases, `delay_s` later, in whole milliseconds."""
        return replace(self, **{name: round(time_s + delay_s, 3) for name, time_s in self.in_order()})


@dataclass(frozen=True, slots=True)
class Behavior:
    """One movement of the schedule. `rule` mapped it, `function` (an id) is what it shows; both are None for what the
    body does by itself, such as blinks. `moment` (an id) is the moment it belongs to. `lexeme` is the BML word for it,
    `amount` its size in [0, 1], `target` what a gaze or a pointing is at, `repetitions` how often a nod or shake goes.
    What lost a conflict stays, with `kept` false, the winner's id in `lost_to` and the reason in words.

    `after_strokes_s` are the ends of a gesture's strokes after its main one, seconds after that; None leaves them to
    the realizer."""

    id: str
    kind: Channel
    lexeme: str
    sync: SyncPoints
    first: int
    last: int
    priority: float
    rule: str | None = None
    function: str | None = None
    hand: Hand | None = None
    amount: float | None = None
    target: str | None = None
    direction: str | None = None
    repetitions: int | None = None
    moment: str | None = None
    kept: bool = True
    lost_to: str | None = None
    reason: str | None = None
    after_strokes_s: tuple[float, ...] | None = None


@dataclass(frozen=True, slots=True)
class Target:
    """A named point of the scene, [x, y, z] in metres: the performer stands at the origin and faces +Z, Y is up, its
    left is +X."""

    name: str
    position_m: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Viseme:
    """A shape of the mouth, one of fifteen (shared/motion.md). `articulation` says how much of the shape is reached,
    `opening` how wide the jaw is open, both in [0, 1]."""

    label: str
    interval: Interval
    articulation: float
    opening: float


@dataclass(frozen=True, slots=True)
class Listening:
    """What a listener of that name does while the line is spoken (paper §3.6)."""

    name: str
    behaviors: tuple[Behavior, ...]


@dataclass(frozen=True, slots=True)
class Performance:
    """The whole performance of a line: what was heard and understood, what the body does with it, and every reason."""

    utterance: Utterance
    functions: tuple[Function, ...]
    behaviors: tuple[Behavior, ...]
    character: str
    seed: int
    notices: tuple[Notice, ...] = ()
    visemes: tuple[Viseme, ...] = ()
    listeners: tuple[Listening, ...] = ()
    moments: tuple[Moment, ...] = ()
    stillness: float = 0.0
    targets: tuple[Target, ...] = ()


@dataclass(frozen=True, slots=True)
class Schedule:
    """A schedule as the realizer takes it (paper §3.8): behaviours whose times are all known, and the speech they go
    with, so far as it is known.

    `phrases` are stretches of speech between pauses, `emphases_s` the moments of stress in it, `agitation` the level at
    which clips are chosen, `character` who moves. The recording starts at `lead_in_s`. `stillness` (0 to 1) is how much
    less than usual the body does by itself: at 1 it only breathes. `targets` are where it looks and points,
    `functions` what the words do, for those who want to know why: BML has none, and nothing that is played depends on
    them.
    """

    behaviors: tuple[Behavior, ...]
    duration_s: float
    words: tuple[Word, ...] = ()
    visemes: tuple[Viseme, ...] = ()
    phrases: tuple[Interval, ...] = ()
    emphases_s: tuple[float, ...] = ()
    agitation: Level = Level.MEDIUM
    character: str = "default"
    lead_in_s: float = 0.0
    stillness: float = 0.0
    targets: tuple[Target, ...] = ()
    functions: tuple[Function, ...] = field(default=(), compare=False)
