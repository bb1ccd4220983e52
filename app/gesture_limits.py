"""What arms can do: how long the strokes of gestures take, and how soon one may follow another (paper §3.8).

The one set of limits for the stage that schedules gestures and the stage that plays them, so that what is scheduled is
played. `GestureTable` holds what the scheduler needs of the gesture library; the realizer makes it
(`understudy.realizer.scheduling.gesture_table`).

Conventions: seconds, metres, metres a second. Places of wrists are offsets from the middle of gesture space, seen from
the arm's own side, of a gesture of usual size; a gesture's size multiplies them.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import product
from math import dist, sqrt

from .figures import Manner
from .model import Hand, Level

USUAL_AMOUNT = 0.5
"""The amount of a gesture of usual size."""
TOP_STROKE_SPEED_M_S = 1.0
"""The fastest mean speed of a stroke: its peak is about 1.9 times that, people's 95th percentile."""
SLOWEST_STROKE_M_S = 0.25
"""What strokes of the wrist or the fingers alone, which have no speed of the hand's, count as."""
BLEND_SPEED_THRESHOLD_M_S = 0.5
"""The paper's v_th, which it does not quantify. A stroke of .6 m/s may be reached by a transition at 1.1 m/s, whose
peak is 2 m/s (people's 99th percentile)."""
SHORTEST_TRANSITION_S = 0.15
"""Even for hands that are close together, since orientation and shape must change as well."""
EASY_TRANSITION_S = 0.30
"""The part of a gap that a prolonged hold leaves at least (people's preparations last .30 to 1.05 s)."""
LATEST_S = 0.7
"""A gesture on the first sound of a recording may come this late, two words, rather than not at all."""

Offset = tuple[float, float, float]


def size_of(amount: float | None) -> float:
    """The size of a gesture, 1 as defined. Reach grows with the square root of the amount: twice the amount is not
    twice the reach."""
    return 1.0 if amount is None else sqrt(amount / USUAL_AMOUNT)


def playable_size(size: float, stroke_speed_m_s: float) -> float:
    """The size, reduced where the stroke, which has a fixed duration, would exceed `TOP_STROKE_SPEED_M_S`;
    `stroke_speed_m_s` is that of size 1."""
    return size * TOP_STROKE_SPEED_M_S / max(size * stroke_speed_m_s, TOP_STROKE_SPEED_M_S)


def shortest_transition_s(way_m: float, stroke_speed_m_s: float) -> float:
    """The least time from one gesture's relax time to the start of the next stroke: the way may be faster than that
    stroke by `BLEND_SPEED_THRESHOLD_M_S`."""
    return max(SHORTEST_TRANSITION_S, way_m / (stroke_speed_m_s + BLEND_SPEED_THRESHOLD_M_S))


def equal_transition_s(way_m: float, stroke_speed_m_s: float) -> float:
    """The time in which the way is as fast as the next stroke (paper §3.8, Figure 4), at least `EASY_TRANSITION_S`."""
    return max(EASY_TRANSITION_S, way_m / stroke_speed_m_s)


@dataclass(frozen=True, slots=True)
class ArmEnds:
    """Where an arm's wrist is when the stroke starts and when the hand relaxes."""

    stroke_start: Offset
    relax: Offset


@dataclass(frozen=True, slots=True)
class GestureForm:
    """One way to make a gesture: its stroke before and after the emphasis, the mean speed of the stroke, and the arms
    that take part."""

    before_s: float
    after_s: float
    stroke_speed_m_s: float
    arms: Mapping[Hand, ArmEnds]

    def in_manner(self, manner: Manner) -> "GestureForm":
        """The form as a character makes it that takes more or less space and time for gestures."""
        arms = {
            arm: ArmEnds(_scaled(ends.stroke_start, manner.space), _scaled(ends.relax, manner.space))
            for arm, ends in self.arms.items()
        }
        return GestureForm(
            self.before_s / manner.pace,
            self.after_s / manner.pace,
            self.stroke_speed_m_s * manner.pace * manner.space,
            arms,
        )

    def size(self, amount: float | None) -> float:
        return playable_size(size_of(amount), self.stroke_speed_m_s)

    def speed_m_s(self, amount: float | None) -> float:
        return max(self.stroke_speed_m_s * self.size(amount), SLOWEST_STROKE_M_S)


def _scaled(offset: Offset, factor: float) -> Offset:
    x_m, y_m, z_m = offset
    return factor * x_m, factor * y_m, factor * z_m


Forms = tuple[GestureForm, ...]
"""The forms of a gesture; nobody knows before it is played which it will have."""


@dataclass(frozen=True, slots=True)
class GestureTable:
    """The forms of gestures by lexeme, level of agitation and hand."""

    forms: Mapping[tuple[str, Level, Hand], Forms]

    def of(self, lexeme: str, level: Level) -> Mapping[Hand, Forms]:
        """The forms of a gesture at a level, by the hand that it asks for; none for a lexeme that is not in the
        table."""
        return {hand: self.forms[lexeme, level, hand] for hand in Hand if (lexeme, level, hand) in self.forms}


@dataclass(frozen=True, slots=True)
class TransitionTimes:
    """The time from one gesture's relax time to the start of the next stroke: the least, and that in which the way is
    as fast as the stroke. Both are 0 for gestures of different arms."""

    shortest_s: float = 0.0
    equal_s: float = 0.0


def transition_times(
    first: Forms, second: Forms, *, amounts: tuple[float | None, float | None] = (None, None)
) -> TransitionTimes:
    """The times for whatever forms the two take, of these amounts."""
    ways = list(_ways(first, second, amounts))
    return TransitionTimes(
        shortest_s=max((shortest_transition_s(*way) for way in ways), default=0.0),
        equal_s=max((equal_transition_s(*way) for way in ways), default=0.0),
    )


def _ways(first: Forms, second: Forms, amounts: tuple[float | None, float | None]) -> Iterable[tuple[float, float]]:
    """The ways of arms that make both, each with the speed of the second's stroke."""
    for before, after in product(first, second):
        sizes = before.size(amounts[0]), after.size(amounts[1])
        for arm in before.arms.keys() & after.arms.keys():
            from_m = [sizes[0] * offset for offset in before.arms[arm].relax]
            to_m = [sizes[1] * offset for offset in after.arms[arm].stroke_start]
            yield dist(from_m, to_m), after.speed_m_s(amounts[1])
