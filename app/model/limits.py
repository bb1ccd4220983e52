"""What arms can do, how long the strokes of gestures take and how soon one may follow another (paper §3.8); and the
limits on the motion in one response.

The stage that schedules gestures and the stage that plays them share these limits, so that what is scheduled can be
played. `GestureTable` has what the scheduler needs of the gesture library; the realizer computes it
(`understudy.realizer.scheduling.gesture_table`).

Conventions: seconds, metres, metres per second. Wrist positions are offsets from the centre of gesture space, seen from
the arm's own side, for a gesture of usual size; a gesture's size multiplies them.

All limits of a response but that on bytes are checked before any motion is computed.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import product
from math import dist, sqrt

from ..errors import InputError
from .body import Hand
from .figure import GestureManner
from .schedule import Schedule
from .voice.speech import Level

USUAL_AMOUNT = 0.5
"""The amount of a gesture of usual size."""
TOP_STROKE_SPEED_M_S = 1.3
"""The fastest mean speed of a stroke: its peak is about 1.9 times that, 2.5 m/s, which people's wrists rarely exceed
(99th percentile 1.8 to 2.9). Less would make a big voice's gestures as small as a usual one's."""
SLOWEST_STROKE_M_S = 0.25
"""The speed assumed for strokes of the wrist or the fingers alone, in which the hand does not travel."""
BLEND_SPEED_THRESHOLD_M_S = 0.5
"""The paper's v_th, which it does not quantify. A stroke of .6 m/s may be reached by a transition at 1.1 m/s, whose
peak is 2 m/s (people's 99th percentile)."""
SHORTEST_TRANSITION_S = 0.15
"""Even for hands that are close together, since orientation and shape must change as well."""
EASY_TRANSITION_S = 0.30
"""The least part of a gap that a prolonged hold leaves free (people's preparations last .30 to 1.05 s)."""
SHORTEST_STROKE_S = 0.23
"""The fifth percentile of people's strokes (docs/references.md)."""
BRIEFEST_SHARE = 0.5
"""The least share of a stroke's path and duration with which the gesture is still recognizable."""
WHOLE_SHARE = 0.8
"""A stroke that has at least this share of its duration is made whole."""
LATEST_S = 0.7
"""How late, about two words, a gesture on the first sound of a recording may come before it is dropped."""

_ROUNDING_S = 0.002
"""Times in schedules are rounded to whole milliseconds."""

Offset = tuple[float, float, float]


def size_of(amount: float | None) -> float:
    """The size of a gesture, 1 as defined. Reach grows with the square root of the amount: twice the amount is not
    twice the reach."""
    return 1.0 if amount is None else sqrt(amount / USUAL_AMOUNT)


def playable_size(size: float, stroke_speed_m_s: float) -> float:
    """The size, reduced where the stroke, which has a fixed duration, would exceed `TOP_STROKE_SPEED_M_S`;
    `stroke_speed_m_s` is that of size 1."""
    return size * TOP_STROKE_SPEED_M_S / max(size * stroke_speed_m_s, TOP_STROKE_SPEED_M_S)


def brief_share(stroke_s: float) -> float:
    """The share of a stroke's path and duration that is kept where there is no time for the whole: it begins nearer to
    its end and is as fast as usual. The paper would drop the gesture (§3.8); people make it smaller."""
    share = max(BRIEFEST_SHARE, SHORTEST_STROKE_S / stroke_s)
    return share if share <= WHOLE_SHARE else 1.0


def is_brief(stroke_s: float, longest_s: float) -> bool:
    """Whether a stroke is shortened where a schedule has `longest_s` for it: too little for the whole, but enough for
    its shortest form."""
    return brief_share(stroke_s) * stroke_s - _ROUNDING_S <= longest_s < WHOLE_SHARE * stroke_s


def shortest_transition_s(way_m: float, stroke_speed_m_s: float) -> float:
    """The least time from one gesture's relax time to the start of the next stroke: the hand may be faster on the way
    than in that stroke by `BLEND_SPEED_THRESHOLD_M_S`."""
    return max(SHORTEST_TRANSITION_S, way_m / (stroke_speed_m_s + BLEND_SPEED_THRESHOLD_M_S))


def equal_transition_s(way_m: float, stroke_speed_m_s: float) -> float:
    """The transition time at which the hand is as fast as in the next stroke (paper §3.8, Figure 4), at least
    `EASY_TRANSITION_S`."""
    return max(EASY_TRANSITION_S, way_m / stroke_speed_m_s)


@dataclass(frozen=True, slots=True)
class ArmEnds:
    """The position of an arm's wrist when the stroke starts, when it ends and when the hand relaxes."""

    stroke_start: Offset
    stroke_end: Offset
    relax: Offset

    def scaled(self, factor: float) -> "ArmEnds":
        return ArmEnds(*(_scaled(offset, factor) for offset in (self.stroke_start, self.stroke_end, self.relax)))

    def begun_nearer(self, share: float) -> "ArmEnds":
        """The positions for a stroke that has only the last `share` of its path."""
        pairs = zip(self.stroke_start, self.stroke_end, strict=True)
        x_m, y_m, z_m = (end_m + share * (start_m - end_m) for start_m, end_m in pairs)
        return ArmEnds((x_m, y_m, z_m), self.stroke_end, self.relax)


@dataclass(frozen=True, slots=True)
class GestureForm:
    """One form of a gesture: the time of its stroke before and after the emphasis, the mean speed of the stroke, and
    the arms that take part."""

    before_s: float
    after_s: float
    stroke_speed_m_s: float
    arms: Mapping[Hand, ArmEnds]

    def in_manner(self, manner: GestureManner) -> "GestureForm":
        """The form as varied by a character's gesture space and pace."""
        return GestureForm(
            self.before_s / manner.pace,
            self.after_s / manner.pace,
            self.stroke_speed_m_s * manner.pace * manner.space,
            {arm: ends.scaled(manner.space) for arm, ends in self.arms.items()},
        )

    @property
    def stroke_s(self) -> float:
        return self.before_s + self.after_s

    def brief(self) -> "GestureForm":
        """The form with a shortened stroke, for where there is no time for the whole."""
        share = brief_share(self.stroke_s)
        return GestureForm(
            share * self.before_s,
            share * self.after_s,
            self.stroke_speed_m_s,
            {arm: ends.begun_nearer(share) for arm, ends in self.arms.items()},
        )

    @property
    def brief_stroke_s(self) -> float:
        """The stroke of the `brief` form."""
        share = brief_share(self.stroke_s)
        return share * self.before_s + share * self.after_s

    def within(self, longest_s: float) -> "GestureForm":
        """The form as it is played in a schedule that has `longest_s` for its stroke."""
        return self.brief() if is_brief(self.stroke_s, longest_s) else self

    def stroke_within_s(self, longest_s: float) -> float:
        """The stroke of the form `within` this time."""
        return self.brief_stroke_s if is_brief(self.stroke_s, longest_s) else self.stroke_s

    def size(self, amount: float | None) -> float:
        return playable_size(size_of(amount), self.stroke_speed_m_s)

    def speed_m_s(self, amount: float | None) -> float:
        return max(self.stroke_speed_m_s * self.size(amount), SLOWEST_STROKE_M_S)


def _scaled(offset: Offset, factor: float) -> Offset:
    x_m, y_m, z_m = offset
    return factor * x_m, factor * y_m, factor * z_m


Forms = tuple[GestureForm, ...]
"""The forms of a gesture; which of them is played is not known before."""


@dataclass(frozen=True, slots=True)
class GestureTable:
    """The forms of gestures by lexeme, level of agitation and hand."""

    forms: Mapping[tuple[str, Level, Hand], Forms]

    def of(self, lexeme: str, level: Level) -> Mapping[Hand, Forms]:
        """The forms of a gesture at a level, by hand; empty for a lexeme that is not in the table."""
        return {hand: self.forms[lexeme, level, hand] for hand in Hand if (lexeme, level, hand) in self.forms}


@dataclass(frozen=True, slots=True)
class TransitionTimes:
    """The time from one gesture's relax time to the start of the next stroke: the least, and that at which the hand is
    as fast as in the stroke. Both are 0 for gestures of different arms."""

    shortest_s: float = 0.0
    equal_s: float = 0.0


def transition_times(
    first: Forms, second: Forms, *, amounts: tuple[float | None, float | None] = (None, None)
) -> TransitionTimes:
    """The times that suffice whichever forms the two gestures take, for these amounts."""
    ways = list(_ways(first, second, amounts))
    return TransitionTimes(
        shortest_s=max((shortest_transition_s(*way) for way in ways), default=0.0),
        equal_s=max((equal_transition_s(*way) for way in ways), default=0.0),
    )


def _ways(first: Forms, second: Forms, amounts: tuple[float | None, float | None]) -> Iterable[tuple[float, float]]:
    """The distances of the arms that make both gestures, each with the speed of the second stroke."""
    for before, after in product(first, second):
        sizes = before.size(amounts[0]), after.size(amounts[1])
        for arm in before.arms.keys() & after.arms.keys():
            from_m = [sizes[0] * offset for offset in before.arms[arm].relax]
            to_m = [sizes[1] * offset for offset in after.arms[arm].stroke_start]
            yield dist(from_m, to_m), after.speed_m_s(amounts[1])


@dataclass(frozen=True, slots=True)
class MotionLimits:
    """The most behaviours, seconds, frames and bytes of a motion."""

    behaviors: int = 1000
    duration_s: float = 150.0
    frames: int = 9000
    content_bytes: int = 32 << 20

    def check_count(self, behaviors: int) -> None:
        """Raises InputError `motion_too_large` for too many behaviours, before their times are known."""
        self._check("behaviours", behaviors, self.behaviors)

    def check(self, schedule: Schedule, *, frame_rate_hz: int, tail_s: float = 0.0) -> None:
        """Raises InputError `motion_too_large` with the limit that the schedule exceeds."""
        end_s = max([schedule.duration_s, *(behavior.sync.end for behavior in schedule.behaviors)]) + tail_s
        self.check_count(len(schedule.behaviors))
        self._check("seconds", end_s, self.duration_s)
        self._check("frames", math.ceil(end_s * frame_rate_hz), self.frames)

    def check_content(self, content: bytes) -> None:
        """Raises InputError `motion_too_large` for too many bytes."""
        self._check("bytes", len(content), self.content_bytes)

    def _check(self, what: str, count: float, most: float) -> None:
        if count > most:
            message = f"the motion would have {count:,.10g} {what}; at most {most:,.10g} are answered"
            raise InputError("motion_too_large", message, field="bml")
