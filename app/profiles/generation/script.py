"""The gesture script (NGS §3.3, step 16): what the hands do, when, and where; and the same as behaviours of a schedule:
gestures with their after-strokes, and the rests of the hands.

Times are seconds on the performance's clock.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from ...model import Behavior, Channel, Hand, Interval, SyncPoints
from ...model.schedule import Sector, Way
from ..annotation.model import PathForm, Position, Swivel


@dataclass(frozen=True, slots=True)
class ScriptedGesture:
    """A gesture: its strokes, the main one first, of which an independent hold (`held`) has one without movement.

    `tag` and words `first` to `last` are what it shows; the stroke falls on `word`. It begins at `start_s`, relaxes at
    `relax_s` and is over at `end_s`, where the next of its unit begins or the hands are at rest. `start` and `end` are
    where the main stroke leads from and to, as the speaker made it once; its point of emphasis is at `emphasis_s`,
    `amount` is its size in [0, 1]. `tracks` are offset tracks that an author added (NGS §3.4), in the words of the
    gesture language. One that is not made says why in `reason`.
    """

    id: str
    lexeme: str
    hand: Hand
    tag: str
    first: int
    last: int
    word: int
    start_s: float
    strokes: tuple[Interval, ...]
    relax_s: float
    end_s: float
    held: bool = False
    emphasis_s: float | None = None
    amount: float | None = None
    start: Position | None = None
    end: Position | None = None
    path: PathForm = PathForm.STRAIGHT
    tracks: tuple[str, ...] = ()
    kept: bool = True
    reason: str | None = None


@dataclass(frozen=True, slots=True)
class ScriptedUnit:
    """Gestures between two rests, by id, and where the hands rest after them."""

    gestures: tuple[str, ...]
    start_s: float
    end_s: float
    rest: str


@dataclass(frozen=True, slots=True)
class GestureScript:
    """What a line's hands do by a profile; gestures in order of time, those that were given up among them."""

    profile: str
    seed: int
    gestures: tuple[ScriptedGesture, ...]
    units: tuple[ScriptedUnit, ...]

    @property
    def made(self) -> tuple[ScriptedGesture, ...]:
        return tuple(gesture for gesture in self.gestures if gesture.kept)


PRIORITY = 5.0
"""Of every gesture of a script: what cannot be played beside what was asked for has been given up already."""

RESTS: Mapping[str, str] = {
    "clasped": "HANDS_CLASPED",
    "at_side": "HANDS_AT_SIDE",
    "in_pockets": "HANDS_IN_POCKETS",
    "folded": "HANDS_FOLDED",
    "behind_back": "HANDS_BEHIND_BACK",
    "on_hips": "HANDS_ON_HIPS",
    "open": "ARMS_OPEN",
}
"""The postures that have the hands rest so."""

ELBOWS_DEG: Mapping[Swivel, float | None] = {
    Swivel.TOUCH: -25.0,
    Swivel.NORMAL: None,
    Swivel.OUT: 30.0,
    Swivel.RAISED: 75.0,
}
"""How far out the elbow of each swivel is; the normal one is where the wrist is at ease."""

STANCES = ("WEIGHT_ON_LEFT_LEG", "WEIGHT_ON_RIGHT_LEG")
"""The postures of the feet."""

ShownFunctions = Mapping[tuple[str, int, int], str]
"""The ids of functions by tag, first and last word."""


def behaviors_of(script: GestureScript, functions: ShownFunctions, *, led: bool = False) -> tuple[Behavior, ...]:
    """The gestures of a script, those that were given up among them, and the rests of its units. If they are `led`,
    hands go from and to the sectors of the script; else these are in the size alone."""
    made = (_gesture(each, script.profile, functions, led=led) for each in script.gestures)
    return (*made, *_rests(script))


def _gesture(gesture: ScriptedGesture, profile: str, functions: ShownFunctions, *, led: bool) -> Behavior:
    main, *others = gesture.strokes
    emphasis_s = main.end_s if gesture.emphasis_s is None else gesture.emphasis_s
    sync = SyncPoints(
        start=gesture.start_s,
        ready=main.start_s,
        stroke_start=main.start_s,
        stroke=emphasis_s,
        stroke_end=main.end_s,
        relax=gesture.relax_s,
        end=gesture.end_s,
    )
    return Behavior(
        id=gesture.id,
        kind=Channel.GESTURE,
        lexeme=gesture.lexeme,
        sync=sync.shifted(0.0),
        first=gesture.first,
        last=gesture.last,
        priority=PRIORITY,
        rule=f"profile_{profile}",
        function=functions.get((gesture.tag, gesture.first, gesture.last)),
        hand=gesture.hand,
        amount=gesture.amount,
        kept=gesture.kept,
        reason=gesture.reason,
        after_strokes_s=tuple(round(each.end_s - main.end_s, 3) for each in others),
        curved=gesture.path is PathForm.CURVED and not gesture.held,
        way=_way(gesture) if led else None,
    )


def _way(gesture: ScriptedGesture) -> Way | None:
    start, end = gesture.start, gesture.end
    if not (start or end or gesture.tracks):
        return None
    return Way(_sector(start), _sector(end), _elbow_deg(start), _elbow_deg(end), gesture.tracks)


def _elbow_deg(position: Position | None) -> float | None:
    return None if position is None else ELBOWS_DEG[position.swivel]


def _sector(position: Position | None) -> Sector | None:
    return None if position is None else (position.sideways, position.height, position.depth)


def _rests(script: GestureScript) -> Iterator[Behavior]:
    """A posture of the hands where a unit ends in another rest than the one before."""
    rest = ""
    for number, unit in enumerate(script.units):
        if unit.rest != rest:
            rest = unit.rest
            yield _posture(unit, number, script)


def _posture(unit: ScriptedUnit, number: int, script: GestureScript) -> Behavior:
    last = next(each for each in script.gestures if each.id == unit.gestures[-1])
    sync = SyncPoints(start=last.relax_s, end=unit.end_s)
    return Behavior(
        id=f"script.rest.{number}",
        kind=Channel.POSTURE,
        lexeme=RESTS[unit.rest],
        sync=sync.shifted(0.0),
        first=last.first,
        last=last.last,
        priority=PRIORITY,
        rule=f"profile_{script.profile}",
        reason=f"the hands rest {unit.rest} after {last.lexeme}",
    )
