"""Gestures joined to units (NGS §3.3, steps 7, 8, 14 and 15): where hands hold on, and where they rest.

Neighbours in one segment whose strokes are nearer than the speaker's `merge_within_s` are one unit (the paper), by the
share in which the speaker joins another to a unit that has so many gestures (ours: with one share for all sizes 11 % of
units were of other sizes than the speaker's, so 7.5 %, `python -m benchmarks.profiles`); so are those that leave no
time for a retraction and a preparation, in whatever segments. Within a unit a gesture is prepared from the end of the
one before it, which is held until then; a unit ends in one retraction, to the rest that the time to the next unit says.
Times are seconds.
"""

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf

from ..profile import PhaseHabit, Profile, RestHabit
from ..segments import AFTER_STROKE_S, SHORTEST_PREPARATION_S, SHORTEST_REST_S, SHORTEST_RETRACTION_S
from .phases import TimedStrokes


@dataclass(frozen=True, slots=True)
class Bounds:
    """When a gesture begins, relaxes, and is over, and whether it ends its unit."""

    start_s: float
    relax_s: float
    end_s: float
    last: bool


def joined(
    profile: Profile, strokes: Sequence[TimedStrokes], segments: Sequence[int], rng: random.Random
) -> list[bool]:
    """Whether each gesture is in one unit with the one before it."""
    found, size = [False], 1
    for (one, other), (segment, following) in zip(pairwise(strokes), pairwise(segments), strict=True):
        gap_s = other.strokes[0].start_s - one.strokes[-1].end_s
        near = segment == following and gap_s < profile.units.merge_within_s
        found.append(gap_s < SHORTEST_REST_S or (near and rng.random() < profile.units.joined_after(size)))
        size = size + 1 if found[-1] else 1
    return found[: len(strokes)]


def bounds_of(phases: PhaseHabit, strokes: Sequence[TimedStrokes], is_joined: Sequence[bool]) -> Iterator[Bounds]:
    """When each gesture begins and ends."""
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
    """Where the hands rest for so long."""
    return rests.near if gap_s < rests.near_s else rests.far if gap_s > rests.far_s else rests.medium
