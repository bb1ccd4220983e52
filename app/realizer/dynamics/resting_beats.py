"""Small beats of hands at rest before the belly, during speech: on stressed words, and between them.

Speakers' hands do not stay still between gestures while they talk. The level of agitation determines how many beats
there are and how high the hand is lifted; the hand that does not lead is lifted less, and later.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from ...model import Hand, Interval, Level
from ..arms.rest_poses import resting
from ..body.movement_style import Lap
from ..geometry.chance import generator_of
from ..gestures.gesture_plan import ArmRest, Repeat

SPACING_S = 0.46
"""The shortest time between the ends of two beats."""
_LIFT_S = 0.42
"""The duration of a beat, up and down."""
_SETTLED_S = 0.15
"""The minimum time between a beat and the start or end of the rest."""
_OTHER_SHARE, _OTHER_LAG_S = 0.6, 0.05
_STEPS_S = (0.42, 0.68)
_UNSTRESSED = 0.65
"""The height of a beat on no stressed word, relative to one on a stressed word."""


@dataclass(frozen=True, slots=True)
class Habits:
    """The leading hand, and the random seed."""

    leading: Hand
    seed: int


def with_beats(
    rest: ArmRest, emphases_s: Sequence[float], phrases: Sequence[Interval], lap: Lap, habits: Habits
) -> ArmRest:
    """The rest with beats on its emphases, in increasing order, and smaller ones where a phrase has no emphasis for
    long. Which ones, and how high, depends on the seed and the time alone."""
    ready_at = resting(rest.pose, rest.side).ready_at
    if ready_at is None or not any(lap.lift_m):
        return rest
    level = list(Level).index(ready_at)
    lag_s, share = (0.0, 1.0) if rest.side is habits.leading else (_OTHER_LAG_S, _OTHER_SHARE)
    last_s, beats = rest.start_s + _SETTLED_S, []
    spoken = [each for each in phrases if each.start_s <= rest.end_s and rest.start_s <= each.end_s]
    for at_s, height in _times(emphases_s, spoken, lap.beats[level], habits.seed):
        end_s = at_s + lag_s
        if end_s - _LIFT_S >= last_s and end_s <= rest.end_s - _SETTLED_S:
            beats.append(Repeat(end_s - _LIFT_S, end_s, 0.0, height * share * lap.lift_m[level]))
            last_s = end_s + SPACING_S - _LIFT_S
    return replace(rest, beats=tuple(beats))


def _times(
    emphases_s: Sequence[float], phrases: Sequence[Interval], likely: float, seed: int
) -> Iterator[tuple[float, float]]:
    """The times of beats and their heights: on emphases, and at uneven steps where none comes for longer."""
    for phrase in phrases:
        within = emphases_s[bisect_left(emphases_s, phrase.start_s) : bisect_right(emphases_s, phrase.end_s)]
        yield from _times_within(phrase, tuple(within), likely, seed)


@lru_cache(maxsize=64)
def _times_within(
    phrase: Interval, emphases_s: tuple[float, ...], likely: float, seed: int
) -> list[tuple[float, float]]:
    """Those of one phrase. Cached, since either hand has them; never mutated."""
    rng = generator_of(seed, round(1000 * phrase.start_s))
    found, at_s = [], phrase.start_s
    while at_s < phrase.end_s:
        step_s, height = float(rng.uniform(*_STEPS_S)), float(rng.uniform(0.7, 1.3))
        soon = next((each for each in emphases_s if at_s + SPACING_S <= each <= at_s + step_s + _SETTLED_S), None)
        at_s = at_s + step_s if soon is None else soon
        if at_s <= phrase.end_s and rng.uniform() < likely:
            found.append((at_s, height * (_UNSTRESSED if soon is None else 1.0)))
    return found
