"""What the body does when: behaviours in time, shapes of the mouth, and the schedule to realize (paper §3.8)."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from .body import Channel, Hand
from .functions import Function
from .speech import Interval, Level, Word


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
    the realizer. `edit` is the number of the author's edit that made or changed it."""

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
    edit: int | None = None


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
class Schedule:
    """A schedule as the realizer takes it (paper §3.8): behaviours whose times are all known, and the speech they go
    with, so far as it is known.

    `phrases` are stretches of speech between pauses, `emphases_s` the moments of stress in it, `agitation` the level at
    which clips are chosen, `character` who moves. The recording starts at `lead_in_s`. `stillness` (0 to 1) is how much
    less than usual the body does by itself: at 1 it only breathes. `singletons` has the hands go back to rest after
    every gesture for which they have the time at all, instead of joining near ones to units (NGS §4.1). `targets` are
    where it looks and points, `functions` what the words do, for those who want to know why: BML has none, and nothing
    that is played depends on them.
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
    singletons: bool = False
    targets: tuple[Target, ...] = ()
    functions: tuple[Function, ...] = field(default=(), compare=False)
