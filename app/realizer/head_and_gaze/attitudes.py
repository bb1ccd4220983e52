"""What the head does by itself: a new attitude with every phrase, a thrust on every stressed word, and noise.

Speakers hold head and trunk differently in every phrase and move the head on stressed words (Hadar, Steiner & Rose
1984; Kendon 1972). An attitude has seven angles, each drawn anew; the head goes from one to the next in a minimum-jerk
movement and returns to none. Between phrases and in silence it changes now and then. The eyes stay on their target.

Conventions: degrees in the constants, else radians; pitch, yaw and roll as in
`understudy.realizer.geometry.angles`; seconds. The angles are ours, chosen by how far the heads of five storytellers
move relative to their trunks (`benchmarks/realizer/liveliness.py`).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ...model import FloatArray, Interval, Schedule
from ..geometry.easing import superposed_movements
from ..geometry.noise import Noise, perlins
from ..torso.idle_activity import idle_activity

TRUNK_DEGREES = (1.5, 1.8, 1.0)
"""Standard deviations of the trunk's pitch, yaw and roll over the hips, spread over its joints."""

NECK_DEGREES = 5.0
"""That of the neck's pitch against the head's: the head goes forward and back and stays level."""

HEAD_DEGREES = (2.0, 3.2, 2.4)
"""Those of the head's pitch, yaw and roll."""

WIDEST = 1.8
"""No angle is more of its standard deviations away."""

FORWARD_DEGREES = 13.0
"""The neck is inclined forward as people stand, and the head level on it."""

_AT_LEAST_S, _AT_MOST_S = 1.4, 3.0
"""How long an attitude lasts, unless a phrase begins."""
_MOVING_S = (0.5, 1.0)
_BEFORE_PHRASE_S = 0.15
"""A head begins to move before the voice does."""

_THRUST_DEGREES = np.array([1.0, 0.0, 0.0, 4.5, 2.5, 0.0, 0.0])
"""On a stressed word, at the usual size, with which the others differ by a third: the head goes forward and down."""
_THRUST_S = 0.18
"""The time forward; back takes twice as long."""

_NOISE_DEGREES, _NOISE_HZ = (3.0, 4.0, 2.6), 0.5
_TREMBLE_DEGREES, _TREMBLE_HZ = 0.25, 2.3
"""Amplitudes of noise; the typical deviation is a quarter of them."""

_SPREAD = np.radians([*TRUNK_DEGREES, NECK_DEGREES, *HEAD_DEGREES])


@dataclass(frozen=True, slots=True, eq=False)
class HeadAttitude:
    """Pitch, yaw and roll (T, 3) that are added to the trunk as a whole, and to the joints neck and head; how far the
    neck is inclined forward (T,) with the head level on it."""

    trunk: FloatArray
    neck: FloatArray
    head: FloatArray
    forward: FloatArray


def head_attitude(times_s: FloatArray, schedule: Schedule, *, seed: int) -> HeadAttitude:
    """What trunk, neck and head do by themselves; deterministic for a seed, and at a stillness of 1 nothing moves."""
    activity, lively = idle_activity(schedule), 1 - schedule.stillness
    first, held = _held(float(times_s[-1]), schedule.phrases, np.random.default_rng(seed + 6))
    thrusts = _thrusts(schedule.emphases_s, np.random.default_rng(seed + 7))
    moves = [np.concatenate(each) for each in zip(held.scaled(activity), thrusts.scaled(lively), strict=True)]
    course = activity * first + superposed_movements(times_s, *moves)
    noise = perlins(
        times_s,
        Noise(_NOISE_HZ, seed + 3, 3, in_step=False),
        Noise(_TREMBLE_HZ, seed + 4, 6, in_step=False),
    )
    turned = (course[:, 4:] + activity * np.radians(_NOISE_DEGREES) * noise[:, :3]) / 2
    tremble = lively * np.radians(_TREMBLE_DEGREES) * noise[:, 3:]
    neck, head = turned + tremble[:, :3], turned + tremble[:, 3:]
    return HeadAttitude(course[:, :3], neck, head, np.radians(FORWARD_DEGREES) + course[:, 3])


class _Moves(NamedTuple):
    """Movements of the seven angles: when they start and how long they last (K,), and by how much (K, 7)."""

    starts_s: FloatArray
    durations_s: FloatArray
    by: FloatArray

    def scaled(self, factor: float) -> "_Moves":
        return self._replace(by=factor * self.by)


def _held(end_s: float, phrases: Sequence[Interval], generator: np.random.Generator) -> tuple[FloatArray, _Moves]:
    """The first attitude (7,), and the movements to those that are held after it."""
    starts_s = np.array(list(_changes_s(end_s, phrases, generator)))
    drawn = np.clip(generator.standard_normal((len(starts_s) + 1, len(_SPREAD))), -WIDEST, WIDEST)
    attitudes = _SPREAD * drawn
    durations_s = generator.uniform(*_MOVING_S, len(starts_s))
    return attitudes[0], _Moves(starts_s, durations_s, np.diff(attitudes, axis=0))


def _changes_s(end_s: float, phrases: Sequence[Interval], generator: np.random.Generator) -> Iterator[float]:
    """When attitudes change: as phrases begin, as the last one ends, and in between."""
    begins_s = [phrase.start_s - _BEFORE_PHRASE_S for phrase in phrases] + [each.end_s for each in phrases[-1:]]
    last_s = -_AT_LEAST_S
    while last_s < end_s:
        due_s = last_s + float(generator.uniform(_AT_LEAST_S, _AT_MOST_S))
        last_s = next((at_s for at_s in begins_s if last_s + _MOVING_S[0] < at_s <= due_s), due_s)
        yield last_s


def _thrusts(stressed_s: Sequence[float], generator: np.random.Generator) -> _Moves:
    """What stress adds: there, and back."""
    at_s = np.array(stressed_s)
    by = np.radians(_THRUST_DEGREES) * generator.uniform(2 / 3, 4 / 3, (len(at_s), 1))
    durations_s = np.repeat([_THRUST_S, 2 * _THRUST_S], len(at_s))
    return _Moves(np.concatenate([at_s - _THRUST_S, at_s]), durations_s, np.concatenate([by, -by]))
