"""The gesture script (NGS §3.3, step 16): the gestures of the hands, their times and positions; and its conversion to
behaviours: gestures with their after-strokes, and rest postures of the hands.

Times are seconds on the performance's clock.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from ...model import Behavior, Channel, Hand, Interval, SyncPoints
from ...model.schedule import Sector, Way
from ..annotation.model import PathForm, Position, Swivel


@dataclass(frozen=True, slots=True)
class ScriptedGesture:
    """A gesture of the script. `strokes` begins with the main stroke; an independent hold (`held`) has one stroke
    without movement.

    The gesture shows `tag` on the words from `first` to `last`; its stroke falls on `word`. It begins at `start_s`,
    relaxes at `relax_s` and ends at `end_s`, when the next gesture of its unit begins or the hands are at rest. `start`
    and `end` are the positions of the hand at the start and end of the main stroke, from one of the speaker's
    occurrences; its point of emphasis is at `emphasis_s`; `amount` is its size in [0, 1]. `tracks` are offset tracks
    added by an author (NGS §3.4), in the gesture language. `reason` says why a dropped gesture is not made.
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
    """The gestures between two rests, by id, and the rest pose after them."""

    gestures: tuple[str, ...]
    start_s: float
    end_s: float
    rest: str


@dataclass(frozen=True, slots=True)
class GestureScript:
    """The gesture script of a line; gestures are in order of time and include dropped ones."""

    profile: str
    seed: int
    gestures: tuple[ScriptedGesture, ...]
    units: tuple[ScriptedUnit, ...]

    @property
    def made(self) -> tuple[ScriptedGesture, ...]:
        return tuple(gesture for gesture in self.gestures if gesture.kept)


PRIORITY = 5.0
"""The priority of every gesture of a script; conflicts with requested behaviours have been resolved already."""

RESTS: Mapping[str, str] = {
    "clasped": "HANDS_CLASPED",
    "at_side": "HANDS_AT_SIDE",
    "in_pockets": "HANDS_IN_POCKETS",
    "folded": "HANDS_FOLDED",
    "behind_back": "HANDS_BEHIND_BACK",
    "on_hips": "HANDS_ON_HIPS",
    "open": "ARMS_OPEN",
}
"""The posture of each rest pose."""

ELBOWS_DEG: Mapping[Swivel, float | None] = {
    Swivel.TOUCH: -25.0,
    Swivel.NORMAL: None,
    Swivel.OUT: 30.0,
    Swivel.RAISED: 75.0,
}
"""The outward angle of the elbow for each swivel; None leaves the arm at its comfortable angle."""

STANCES = ("WEIGHT_ON_LEFT_LEG", "WEIGHT_ON_RIGHT_LEG")
"""The postures of the feet."""

ShownFunctions = Mapping[tuple[str, int, int], str]
"""The ids of functions by tag, first and last word."""


def behaviors_of(script: GestureScript, functions: ShownFunctions, *, led: bool = False) -> tuple[Behavior, ...]:
    """The behaviours of a script: its gestures, including dropped ones, and the rests of its units. If `led`, the hands
    move between the script's sectors; otherwise the sectors affect the size only."""
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
    """A rest posture after each unit whose rest differs from that of the previous unit."""
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
