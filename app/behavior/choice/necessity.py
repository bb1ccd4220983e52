"""Drops behaviours that would show nothing: a look at somebody who is looked at already, a blink right after a blink, a
repeated head movement.

The gaze is where the last lasting shift directed it, initially at the listener; a look aside comes back by itself. A
head movement may be repeated soon if it shows a function of another class; all classes that only give weight count as
one. What was planned for a moment of the line is always kept. Times are seconds.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from ...model import Behavior, BehaviorCandidates, Channel, Limit
from ...model.tables import SHIFT
from ..timing.conflicts import Kept

HEAD_REPEAT_S = 3.0
"""A head movement is a repetition if the same one began less than this ago."""

SHORTEST_BETWEEN_BLINKS_S = 0.6

JUST_BEFORE_S = 0.1
"""For this long after its end, a look aside is not quite over."""

WEIGHT = frozenset({"emphasis", "intensifier", "initial_noun_phrase", "initial_verb_phrase"})
"""The classes of functions for which a head movement only gives weight."""

LISTENER = "listener"
BLINK = "BLINK"


@dataclass(frozen=True, slots=True)
class Needless:
    """A behaviour that shows nothing, the behaviour that already shows it, and the reason."""

    behavior: Behavior
    shown_by: str | None
    reason: str

    @property
    def dropped(self) -> Behavior:
        limit = None if self.shown_by else Limit.NEEDLESS
        return replace(self.behavior, kept=False, lost_to=self.shown_by, limit=limit, reason=self.reason)


def needed(kept: Kept, candidates: Iterable[BehaviorCandidates]) -> tuple[Kept, tuple[Behavior, ...]]:
    """Those of the kept that show something, in the order given, and the others as dropped; `candidates` give the class
    of each behaviour's function."""
    functions = (offer.function for offer in candidates if offer.function)
    classes = {each.id: "weight" if each.class_name in WEIGHT else each.class_name for each in functions}
    in_time = sorted((each.behavior for each in kept), key=lambda behavior: (behavior.sync.start, behavior.id))
    needless = [
        *_looks(behavior for behavior in in_time if behavior.kind is Channel.GAZE),
        *_blinks(behavior for behavior in in_time if behavior.lexeme == BLINK),
        *_heads((behavior for behavior in in_time if behavior.kind is Channel.HEAD), classes),
    ]
    names = {each.behavior.id for each in needless}
    return tuple(each for each in kept if each.behavior.id not in names), tuple(each.dropped for each in needless)


def _looks(gazes: Iterable[Behavior]) -> list[Needless]:
    """The looks at what the eyes are on already. `gazes` are in order of time, as in the functions below."""
    needless: list[Needless] = []
    target, aside_until_s = LISTENER, 0.0
    for gaze in gazes:
        if gaze.direction is not None or gaze.target != target:
            aside_until_s = gaze.sync.end + JUST_BEFORE_S
        elif gaze.sync.start >= aside_until_s:
            needless.append(Needless(gaze, None, f"the eyes are on the {target} already"))
        if gaze.lexeme == SHIFT and gaze.direction is None:
            target, aside_until_s = gaze.target or target, 0.0
    return needless


def _blinks(blinks: Iterable[Behavior]) -> list[Needless]:
    needless: list[Needless] = []
    last: Behavior | None = None
    for blink in blinks:
        if last is not None and blink.sync.start - last.sync.start < SHORTEST_BETWEEN_BLINKS_S:
            needless.append(Needless(blink, last.id, f"blinks already within {SHORTEST_BETWEEN_BLINKS_S:g} s"))
        else:
            last = blink
    return needless


def _heads(movements: Iterable[Behavior], classes: Mapping[str, str]) -> list[Needless]:
    """The less important of two equal movements that follow each other for the same class of function."""
    needless: list[Needless] = []
    last: Behavior | None = None
    for movement in movements:
        if last is None or not _alike(last, movement, classes):
            last = movement
            continue
        winner, loser = (movement, last) if movement.priority > last.priority else (last, movement)
        reason = f"{winner.lexeme} shows it already within {HEAD_REPEAT_S:g} s"
        needless.append(Needless(loser, winner.id, reason))
        last = winner
    return needless


def _alike(earlier: Behavior, later: Behavior, classes: Mapping[str, str]) -> bool:
    if later.moment or earlier.moment:
        return False
    same_reason = classes.get(earlier.function or "") == classes.get(later.function or "")
    return same_reason and earlier.lexeme == later.lexeme and later.sync.start - earlier.sync.start < HEAD_REPEAT_S
