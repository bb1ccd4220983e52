"""Stances: between phrases, just before the voice begins, the weight shifts to the other leg, the ribs bend and turn
against the pelvis, and the pelvis turns a little the other way. Also the dependence of idle movement on agitation and
stillness; the factors are ours.

Speakers shift their posture where a new unit of talk begins (Cassell et al. 2001; Kendon 1972). The weight shifts
first, since large masses move before the limbs. During long phrases the stance changes occasionally as well. A weight
shift requested by the schedule is kept.

Conventions: seconds, radians; the weight is 1 on the left leg, -1 on the right; pitch, yaw and roll as in
`understudy.realizer.geometry.rotations`.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Interval, Level, Schedule
from ..body.movement_style import IdleLife
from ..geometry.chance import generator_of
from ..geometry.curves import clipped, superposed_movements

BEFORE_S = 0.35
"""The time from the start of a weight shift to the start of the voice."""
MOVING_S = (0.6, 0.95)

LASTS_S = (2.0, 3.4)
"""The duration of a stance within a phrase."""

SHORTEST_S = 1.1
"""The shortest time between two changes, and between the last change and the end of a phrase."""

MOST_WEIGHT = 1.1
"""The largest weight on one leg; above 1 the hips jut out beyond it."""

SMALLEST = 0.55
"""Each stance has at least this share of the full amounts, on the other side than the last."""

_TWIST = 2
"""The place of the twist among weight, pitch, yaw and roll."""

_BOW = 0.4
"""How far the ribs bow or straighten with a stance, as a share of their twist."""


@dataclass(frozen=True, slots=True, eq=False)
class StanceCourse:
    """The stances over time: the weight (T,), pitch, yaw and roll of the ribs against the pelvis (T, 3), and the yaw of
    the pelvis (T,)."""

    weight: FloatArray
    ribs: FloatArray
    pelvis: FloatArray


def stances(times_s: FloatArray, schedule: Schedule, life: IdleLife, *, seed: int) -> StanceCourse:
    """The stances of a line; deterministic for a seed, none at a stillness of 1."""
    generator = generator_of(seed + 9)
    starts_s = np.array(list(_changes_s(float(times_s[-1]), schedule.phrases, generator)))
    held = _drawn(len(starts_s) + 1, generator) * _whole(life)
    durations_s = generator.uniform(*MOVING_S, len(starts_s))
    course = held[0] + superposed_movements(times_s, starts_s, durations_s, np.diff(held, axis=0))
    course *= idle_activity(schedule)
    return StanceCourse(course[:, 0], course[:, 1:], -life.pelvis_share * course[:, _TWIST])


def beside(asked: FloatArray, own: FloatArray, *, uneven: float) -> FloatArray:
    """The weight (T,): that of the postures (`asked`) plus the body's `own` shifts. The further a posture has
    shifted the weight beyond the usual `uneven` share, the smaller the body's own shifts are."""
    free = 1 - 0.8 * clipped((np.abs(asked) - uneven) / (1 - uneven), 0.0, 1.0)
    return np.asarray(clipped(asked + free * own, -MOST_WEIGHT, MOST_WEIGHT))


def _whole(life: IdleLife) -> FloatArray:
    """The full amounts of weight, pitch, yaw and roll."""
    side, twist = np.radians([life.ribs_side_deg, life.ribs_twist_deg])
    return np.array([life.stance_weight, _BOW * twist, twist, side])


def _drawn(count: int, generator: np.random.Generator) -> FloatArray:
    """Shares (count, 4) of the full amounts: weight and side bend change sides together, so that the ribs lean back
    over the leg that bears the weight; the twist changes sides in its own time."""
    sizes = generator.uniform(SMALLEST, 1.0, (count, 4))
    turns = np.where(np.arange(count) % 2 == 0, 1.0, -1.0) * generator.choice([-1.0, 1.0])
    twists = turns * generator.choice([-1.0, 1.0])
    bows = generator.choice([-1.0, 1.0], count)
    return np.asarray(sizes * np.stack([turns, bows, twists, -turns], axis=1))


def _changes_s(end_s: float, phrases: Sequence[Interval], generator: np.random.Generator) -> Iterator[float]:
    """The times of changes of stance: before phrases, and within long ones."""
    last_s = -SHORTEST_S
    for phrase in phrases:
        at_s = phrase.start_s - BEFORE_S
        while at_s < min(max(phrase.end_s - SHORTEST_S, phrase.start_s), end_s):
            if at_s - last_s >= SHORTEST_S and at_s > 0:
                yield at_s
                last_s = at_s
            at_s += float(generator.uniform(*LASTS_S))


IDLE_ACTIVITY: Mapping[Level, float] = MappingProxyType({Level.LOW: 0.75, Level.MEDIUM: 1.0, Level.HIGH: 1.3})
"""Factors of the amplitudes of sway and noise, and of the breathing rate."""


def idle_activity(schedule: Schedule) -> float:
    """The factor of the amplitudes of all idle movement except breathing: 0 at a stillness of 1."""
    return IDLE_ACTIVITY[schedule.agitation] * (1 - schedule.stillness)
