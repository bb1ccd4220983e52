"""Schedules strokes and resolves conflicts (NGS §3.3, steps 10 to 13), and joins gestures to units with holds and rests
(steps 7, 8, 14 and 15). Times are seconds.

The main stroke ends with its word, plus the speaker's offset and a random deviation, minus the lead; an independent
hold begins with its word. After-strokes end with the following words, at least `SPACING_S` apart, with a smaller lead.
The stroke lasts as long as its clip, which is never time-warped. If the hands cannot reach the start of a stroke in
time after the previous one, the stroke is moved later by at most `MOVED_S`; otherwise the gesture is dropped.
(`generating` moves the previous gesture earlier by half of that. The paper only moves gestures later; gestures were
then later on average than the speaker's.) After-strokes that conflict with the next gesture are dropped (the paper
keeps them, and moves or drops the next gesture).

Neighbours in one segment whose strokes are nearer than the speaker's `merge_within_s` may be one unit (the paper). They
are joined with a probability that depends on the number of gestures in the unit (ours: with one share for all sizes
11 % of units differed in size from the speaker's, with this 7.5 %, `python -m benchmarks.profiles`). Gestures that
leave no time for a retraction and a preparation are always joined, even across segments. Within a unit a gesture is
prepared from the end of the previous one, which is held until then. A unit ends in one retraction, to a rest that
depends on the time to the next unit.
"""

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf

from ...model import Hand, Interval, Word
from ...model.limits import LATEST_S
from ..profile import FormHabit, LexemeHabit, PhaseHabit, Profile, RestHabit, Spread
from ..segments import AFTER_STROKE_S, SHORTEST_PREPARATION_S, SHORTEST_REST_S, SHORTEST_RETRACTION_S, time_of

SPACING_S = 0.35
"""The minimum time between the ends of successive strokes of a gesture."""

MOVED_S = 0.5
MOST_STROKES = 6
LONGEST_HELD_S = 1.0
"""The maximum duration of an independent hold."""


@dataclass(frozen=True, slots=True)
class TimedStrokes:
    """The strokes of a gesture, and their shift (positive: later); `held` marks an independent hold."""

    strokes: tuple[Interval, ...]
    held: bool
    moved_s: float = 0.0

    def shifted(self, by_s: float) -> "TimedStrokes":
        """The strokes, later by this much."""
        strokes = tuple(Interval(each.start_s + by_s, each.end_s + by_s) for each in self.strokes)
        return TimedStrokes(strokes, self.held, self.moved_s + by_s)


def drawn_main(profile: Profile, lexeme: str, word: Word, stroke_s: float, rng: random.Random) -> TimedStrokes:
    """The main stroke of a gesture on a word, before conflicts with its neighbours are resolved."""
    habit = habit_of(profile, lexeme)
    time = time_of(word)
    if rng.random() < habit.held:
        start_s = time.start_s - profile.lead.main_s
        return TimedStrokes((Interval(start_s, start_s + min(time.duration_s, LONGEST_HELD_S)),), held=True)
    end_s = time.end_s + drawn(habit.offset_s, rng) - profile.lead.main_s
    return TimedStrokes((Interval(end_s - stroke_s, end_s),), held=False)


def after(timed: TimedStrokes, free_s: float) -> TimedStrokes | None:
    """The gesture, moved later if necessary so that its stroke begins at `free_s` or after; None if that is too
    late."""
    late_s = free_s - timed.strokes[0].start_s
    if late_s <= 0:
        return timed
    most_s = LATEST_S if free_s <= 0 else MOVED_S
    if late_s > most_s:
        return None
    return timed.shifted(late_s)


def with_after_strokes(
    profile: Profile, lexeme: str, timed: TimedStrokes, following: Sequence[Word], *, until_s: float, rng: random.Random
) -> TimedStrokes:
    """The gesture with a random number of after-strokes, on the following words and before `until_s`."""
    habit = habit_of(profile, lexeme)
    strokes = min(MOST_STROKES, max(1, round(drawn(habit.strokes, rng))))
    if timed.held or strokes == 1:
        return timed
    length_s = profile.phases.after_stroke_s.mean
    made = list(_after_strokes(timed.strokes[0].end_s, length_s, following, profile.lead.after_s, until_s))
    return TimedStrokes((*timed.strokes, *made[: strokes - 1]), timed.held, timed.moved_s)


def _after_strokes(
    end_s: float, length_s: float, following: Sequence[Word], lead_s: float, until_s: float
) -> Iterator[Interval]:
    for word in following:
        at_s = time_of(word).end_s - lead_s
        if at_s > until_s:
            return
        if at_s >= end_s + SPACING_S:
            yield Interval(max(end_s, at_s - length_s), at_s)
            end_s = at_s


def habit_of(profile: Profile, lexeme: str) -> LexemeHabit:
    """The speaker's habit for a lexeme; by default one stroke, which ends with its word."""
    usual = LexemeHabit(0.0, {hand: 1 / len(Hand) for hand in Hand}, Spread(1.0), Spread(0.0))
    return profile.lexemes.get(lexeme, usual)


def form_of(profile: Profile, lexeme: str) -> FormHabit:
    """The speaker's form of a lexeme."""
    return profile.forms.get(lexeme, FormHabit())


def drawn(spread: Spread, rng: random.Random) -> float:
    """A normally distributed random value, within two deviations of the mean, since rare extremes are slips."""
    return min(
        max(rng.gauss(spread.mean, spread.deviation), spread.mean - 2 * spread.deviation),
        spread.mean + 2 * spread.deviation,
    )


@dataclass(frozen=True, slots=True)
class Bounds:
    """The times at which a gesture begins, relaxes and ends, and whether it ends its unit."""

    start_s: float
    relax_s: float
    end_s: float
    last: bool


def joined(
    profile: Profile, strokes: Sequence[TimedStrokes], segments: Sequence[int], rng: random.Random
) -> list[bool]:
    """Whether each gesture is in one unit with the previous one."""
    found, size = [False], 1
    for (one, other), (segment, following) in zip(pairwise(strokes), pairwise(segments), strict=True):
        gap_s = other.strokes[0].start_s - one.strokes[-1].end_s
        near = segment == following and gap_s < profile.units.merge_within_s
        found.append(gap_s < SHORTEST_REST_S or (near and rng.random() < profile.units.joined_after(size)))
        size = size + 1 if found[-1] else 1
    return found[: len(strokes)]


def bounds_of(phases: PhaseHabit, strokes: Sequence[TimedStrokes], is_joined: Sequence[bool]) -> Iterator[Bounds]:
    """The bounds of each gesture."""
    free_s = 0.0
    for place, timed in enumerate(strokes):
        first_s, last_s = timed.strokes[0].start_s, timed.strokes[-1].end_s
        follows = place + 1 < len(strokes) and is_joined[place + 1]
        next_s = strokes[place + 1].strokes[0].start_s if place + 1 < len(strokes) else inf
        start_s = free_s if is_joined[place] else max(free_s, first_s - phases.preparation_s.mean)
        if follows:
            relax_s = end_s = max(last_s, next_s - phases.preparation_s.mean)
        else:
            room_s = next_s - SHORTEST_PREPARATION_S - last_s
            retraction_s = min(max(phases.retraction_s.mean, SHORTEST_RETRACTION_S), room_s)
            relax_s = last_s + min(max(AFTER_STROKE_S, phases.hold_s.mean), max(0.0, room_s - retraction_s))
            end_s = relax_s + retraction_s
        yield Bounds(min(start_s, first_s), relax_s, end_s, last=not follows)
        free_s = end_s


def rest_after(rests: RestHabit, gap_s: float) -> str:
    """The rest pose for a pause of this duration."""
    return rests.near if gap_s < rests.near_s else rests.far if gap_s > rests.far_s else rests.medium
