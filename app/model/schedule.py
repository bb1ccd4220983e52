"""The schedule: behaviours with their times, visemes, and the input of the realizer (paper §3.8)."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum

from .body import Channel, Hand
from .functions import Function, Term
from .slots import Slots
from .voice.affect import Manner
from .voice.speech import Interval, Level, Word

DEFAULT_CHARACTER = "default"
"""The character that plays where none is named."""


class Limit(StrEnum):
    """What excluded a movement whose place no other took: the author, a score that is too low, the character's rate of
    gestures, too little time, stillness, a mode without such gestures, or that it would change nothing."""

    NEVER = "never"
    PRICE = "price"
    RATE = "rate"
    TIME = "time"
    STILLNESS = "stillness"
    MODE = "mode"
    NEEDLESS = "needless"


@dataclass(frozen=True, slots=True)
class SyncPoints:
    """The times of a behaviour's phases (paper §3.8, Table 3). Only gestures and head movements have all of the inner
    five; faces and gazes have `ready` (the peak, the target reached) and `relax`."""

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


Sector = tuple[str, str, str]
"""A sector of gesture space: across, in height and away from the body, in the words of the gesture language."""


@dataclass(frozen=True, slots=True)
class Way:
    """The sectors from and to which the stroke of a gesture leads (NGS §3.3), and how far out the elbow is there, in
    degrees about the line from shoulder to wrist; None leaves each to the gesture. `tracks` are offset tracks beside
    the gesture's own (NGS §3.4), in the words of the gesture language."""

    start: Sector | None = None
    end: Sector | None = None
    start_elbow_deg: float | None = None
    end_elbow_deg: float | None = None
    tracks: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Behavior:
    """One movement of the schedule. `rule` chose it, `function` (an id) is what it shows; both are None for idle
    behaviour such as blinks. `moment` (an id) is the moment it belongs to. `lexeme` is its name in BML, `amount` its
    size in [0, 1], `target` the target of a gaze or a pointing, `repetitions` the number of nods or shakes. What lost a
    conflict stays, with `kept` false, the winner's id in `lost_to` and the reason in words. `after_strokes_s` are the
    ends of a gesture's strokes after its main one, seconds after that; None leaves them to the realizer. The stroke of
    one that is `curved` is an arc, others' are as the library has them. `edit` is the number of the author's edit that
    made or changed it, `manner` how it is made, `slots` what its words say of size and place. `decided_by` are the
    named parts of its worth in log-odds, the largest first; `limit` is what excluded one that lost to no other."""

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
    curved: bool = False
    way: Way | None = None
    edit: int | None = None
    manner: Manner | None = None
    decided_by: tuple[Term, ...] = field(default=(), compare=False)
    limit: Limit | None = None
    slots: Slots | None = None


@dataclass(frozen=True, slots=True)
class Target:
    """A named point of the scene, [x, y, z] in metres: the performer stands at the origin and faces +Z, Y is up, its
    left is +X."""

    name: str
    position_m: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Viseme:
    """A mouth shape, one of fifteen (docs/references.md). `articulation` says how fully the shape is reached, `opening`
    how wide the jaw is open, both in [0, 1]."""

    label: str
    interval: Interval
    articulation: float
    opening: float


@dataclass(frozen=True, slots=True)
class Listening:
    """The behaviours of a listener while the line is spoken (paper §3.6)."""

    name: str
    behaviors: tuple[Behavior, ...]


@dataclass(frozen=True, slots=True)
class Schedule:
    """The input of the realizer (paper §3.8): behaviours whose times are all known, and what is known of the speech.

    `phrases` are the intervals of speech between pauses, `emphases_s` the times of stress, `agitation` is the level at
    which clips are chosen, `character` who moves. The recording starts at `lead_in_s`. `stillness` (0 to 1) reduces
    idle movement: at 1 the body only breathes. With `singletons` the hands return to rest after every gesture if there
    is time, instead of joining close ones into units (NGS §4.1). `targets` are the points it looks and points at,
    `functions` those of the words, for information: BML has none, and nothing that is played depends on them. `asked`
    names the sync points that a document states, by behaviour: these are to be met, the others of the same behaviour
    are estimates. What is not in it is our own, and begins when it says but comes to rest in its own time.
    """

    behaviors: tuple[Behavior, ...]
    duration_s: float
    words: tuple[Word, ...] = ()
    visemes: tuple[Viseme, ...] = ()
    phrases: tuple[Interval, ...] = ()
    emphases_s: tuple[float, ...] = ()
    agitation: Level = Level.MEDIUM
    character: str = DEFAULT_CHARACTER
    lead_in_s: float = 0.0
    stillness: float = 0.0
    singletons: bool = False
    targets: tuple[Target, ...] = ()
    functions: tuple[Function, ...] = field(default=(), compare=False)
    asked: Mapping[str, frozenset[str]] = field(default_factory=dict)
