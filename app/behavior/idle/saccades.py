"""Idle looks aside: how eyes wander off and come back.

A speaker's eyes are on the listener for a while, go aside for a while, and come back. The durations are those that
Andrist, Mutlu and Gleicher (2013) measured on people who averted their gaze only in order not to stare; angles and
directions are from "Eyes Alive" (Lee, Badler & Badler 2002). Idle looks are shorter than `LONGEST_S`: a longer one
would seem to mean something. Times are seconds, angles degrees.
"""

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from ...model import Interval
from ...model.tables import GazeDirection


@dataclass(frozen=True, slots=True)
class Habit:
    """Where somebody looks: at the other for a share `eye_contact` of the time, and aside for `aside_s` at a time."""

    eye_contact: float
    aside_s: float
    widest_degrees: float

    @property
    def contact_s(self) -> float:
        """How long the eyes are on the other between two looks aside."""
        return self.aside_s * self.eye_contact / (1 - self.eye_contact)


TALKING = Habit(eye_contact=0.71, aside_s=1.65, widest_degrees=27.5)
LISTENING = Habit(eye_contact=0.86, aside_s=1.14, widest_degrees=22.7)
"""Measured: people who talked looked aside for 1.96 s at a time (less here, because the longest looks are left out) and
back for 4.75 s; people who listened, for 1.14 s and 7.21 s."""

SPREAD = 0.25
"""The standard deviation of these times relative to their mean (0.16 to 0.29 in the measurements)."""

LONGEST_S = 1.9

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
"""Percentages of all saccades."""

NARROWEST_DEGREES = 5.0
"""At smaller angles the eyes are still on the other's face."""

MEAN_DEGREES = 6.9
"""Magnitudes are distributed exponentially: -6.9 ln(P / 15.7)."""

SHORTEST_S = 0.25


@dataclass(frozen=True, slots=True)
class Glance:
    """A look aside."""

    interval: Interval
    direction: GazeDirection
    angle_degrees: float


def glances(free: Interval, habit: Habit, generator: random.Random) -> Iterator[Glance]:
    """The looks aside in an interval in which nothing else moves the eyes; each ends within it."""
    # The interval may begin anywhere between two looks aside.
    start_s = free.start_s + SHORTEST_S + generator.random() * _lasting(habit.contact_s, generator)
    while start_s + SHORTEST_S <= free.end_s:
        aside_s = min(_lasting(habit.aside_s, generator), LONGEST_S)
        interval = Interval(start_s, min(start_s + aside_s, free.end_s))
        (direction,) = generator.choices(list(DIRECTIONS), list(DIRECTIONS.values()))
        angle = NARROWEST_DEGREES + generator.expovariate(1 / MEAN_DEGREES)
        yield Glance(interval, direction, min(angle, habit.widest_degrees))
        start_s = interval.end_s + _lasting(habit.contact_s, generator)


def _lasting(mean_s: float, generator: random.Random) -> float:
    """A random time around the mean."""
    return max(SHORTEST_S, generator.gauss(mean_s, SPREAD * mean_s))
