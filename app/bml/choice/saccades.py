"""How eyes wander off and come back, by the statistics of "Eyes Alive" (Lee, Badler & Badler 2002).

A speaker's eyes are on the listener for a while, go aside for a while, and come back. How long each lasts, how far
aside and in which direction they go was measured on people who talked and who listened. Times are seconds, angles
degrees.
"""

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from ...model import Interval
from .table import GazeDirection


@dataclass(frozen=True, slots=True)
class Habit:
    """Who looks where: a look at the other and one aside last `cycle_s` together, `eye_contact` of it at the other."""

    eye_contact: float
    cycle_s: float
    widest_degrees: float


TALKING = Habit(eye_contact=0.41, cycle_s=4.06, widest_degrees=27.5)
LISTENING = Habit(eye_contact=0.75, cycle_s=8.35, widest_degrees=22.7)
"""The shares are mutual gaze of people talking and listening; a cycle is the mean time there and the mean time away."""

DIRECTIONS: Mapping[GazeDirection, float] = MappingProxyType(
    {
        GazeDirection.RIGHT: 15.54,
        GazeDirection.UPRIGHT: 6.46,
        GazeDirection.UP: 17.69,
        GazeDirection.UPLEFT: 7.44,
        GazeDirection.LEFT: 16.80,
        GazeDirection.DOWNLEFT: 7.89,
        GazeDirection.DOWN: 20.38,
        GazeDirection.DOWNRIGHT: 7.79,
    }
)
"""Of all saccades, percent."""

NARROWEST_DEGREES = 5.0
"""Nearer than this the eyes are still on the other's face."""

MEAN_DEGREES = 6.9
"""Magnitudes fall off exponentially: -6.9 ln(P / 15.7)."""

SHORTEST_S = 0.25


@dataclass(frozen=True, slots=True)
class Glance:
    """A look aside."""

    interval: Interval
    direction: GazeDirection
    angle_degrees: float


def glances(free: Interval, habit: Habit, generator: random.Random) -> Iterator[Glance]:
    """The looks aside in a stretch of time in which nothing else moves the eyes; each ends within it."""
    start_s = free.start_s + _lasting(habit.eye_contact * habit.cycle_s, generator)
    while start_s + SHORTEST_S <= free.end_s:
        aside_s = max(SHORTEST_S, _lasting((1 - habit.eye_contact) * habit.cycle_s, generator))
        interval = Interval(start_s, min(start_s + aside_s, free.end_s))
        (direction,) = generator.choices(list(DIRECTIONS), list(DIRECTIONS.values()))
        angle = NARROWEST_DEGREES + generator.expovariate(1 / MEAN_DEGREES)
        yield Glance(interval, direction, min(angle, habit.widest_degrees))
        start_s = interval.end_s + max(SHORTEST_S, _lasting(habit.eye_contact * habit.cycle_s, generator))


def _lasting(mean_s: float, generator: random.Random) -> float:
    """Times spread as widely as they are long on average."""
    return generator.expovariate(1 / mean_s) if mean_s else 0.0
