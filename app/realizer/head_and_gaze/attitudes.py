"""What the head does by itself: a new attitude with every phrase, a thrust on every stressed word, and noise.

Speakers hold head and trunk differently in every phrase and move the head on stressed words (Hadar, Steiner & Rose
1984; Kendon 1972). An attitude has seven angles, each drawn anew, the head's turn on the other side than the last; the
head goes from one to the next in a minimum-jerk movement and returns to none. In pauses it holds nearly still, and in
long silence it changes now and then. The eyes stay on their target.

Conventions: degrees in the constants, else radians; pitch, yaw and roll as in
`understudy.realizer.geometry.rotations`; seconds. The angles are ours, chosen by how far the heads of five storytellers
move relative to their trunks (`benchmarks/realizer/liveliness.py`).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ...model import FloatArray, Interval, Schedule, Word
from ..geometry.chance import generator_of
from ..geometry.curves import clipped, smoothed, superposed_movements
from ..geometry.noise import Noise, perlins
from ..torso.stance import idle_activity

TRUNK_DEGREES = (1.5, 2.4, 1.6)
"""Standard deviations of the trunk's pitch, yaw and roll over the hips, spread over its joints."""

NECK_DEGREES = 5.0
"""That of the neck's pitch against the head's: the head goes forward and back and stays level."""

HEAD_DEGREES = (3.2, 0.0, 3.6)
"""Those of the head's pitch, yaw and roll, but the yaw is drawn from `TURN_DEGREES`."""

TURN_DEGREES = (7.8, 16.0)
"""How far to one side a head is turned in an attitude, and to the other in the next: heads turn by 30 to 40° in seven
seconds of talk, by phrases rather than by jitter, and the eyes can still make up for a shake beside it."""

WIDEST = 1.8
"""No angle is more of its standard deviations away."""

FORWARD_DEGREES = 13.0
"""The neck is inclined forward as people stand, and the head level on it."""

_AT_LEAST_S, _AT_MOST_S = 1.4, 3.0
"""How long an attitude lasts, unless a phrase begins."""
_MOVING_S = (0.6, 1.1)
_BEFORE_PHRASE_S = 0.0
"""A head that holds in the pause sets out with the voice; the weight has gone before."""
_ENDING_S = 0.45
"""A change that is due so shortly before a pause waits for its end as well."""
_PAUSE_S, _IN_PAUSES = 0.05, 0.1
"""Between words that are at least so far apart the head goes on at this share of its speed only, and no attitude
changes in a pause until the voice is back, unless it stays silent for longer than `_SILENCE_S`."""
_SILENCE_S = 1.5
_SLOWING_S = 0.03

_THRUST_DEGREES = np.array([1.0, 0.0, 0.0, 4.5, 2.8, 0.0, 0.0])
"""On a stressed word, at the usual size, with which the others differ by a third: the head goes forward and down."""
_THRUST_S = 0.18
"""The time forward; back takes twice as long."""

_LATEST_S, _MADE_UP_S = 0.3, 0.6
"""By how much the head waits for the next words at most, and in what time it has made up for it."""

_NOISE_DEGREES, _NOISE_HZ = (3.4, 7.5, 3.0), 0.35
_TREMBLE_DEGREES, _TREMBLE_HZ = 0.15, 2.3
"""Amplitudes of noise; the typical deviation is a quarter of them."""

_YAW = 5
"""The place of the head's turn among the seven angles."""

_SPREAD = np.radians([*TRUNK_DEGREES, NECK_DEGREES, *HEAD_DEGREES])


@dataclass(frozen=True, slots=True, eq=False)
class HeadAttitude:
    """Pitch, yaw and roll (T, 3) that are added to the trunk as a whole, to neck and head as they are `held`, and to
    the joints neck and head by stress and noise; how far the neck is inclined forward (T,) with the head level on
    it."""

    trunk: FloatArray
    held: FloatArray
    neck: FloatArray
    head: FloatArray
    forward: FloatArray


def head_attitude(times_s: FloatArray, schedule: Schedule, *, seed: int) -> HeadAttitude:
    """What trunk, neck and head do by themselves; deterministic for a seed, and at a stillness of 1 nothing moves."""
    activity, lively = idle_activity(schedule), 1 - schedule.stillness
    first, held = _held(float(times_s[-1]), schedule.phrases, generator_of(seed + 6))
    thrusts = _thrusts(schedule.emphases_s, generator_of(seed + 7))
    clock_s = _clock_s(times_s, schedule.words)
    attitude = activity * first + superposed_movements(clock_s, *held.scaled(activity).by_clock(times_s, clock_s))
    thrust = superposed_movements(times_s, *thrusts.scaled(lively))
    noise = perlins(
        clock_s,
        Noise(_NOISE_HZ, seed + 3, 3, in_step=False),
        Noise(_TREMBLE_HZ, seed + 4, 6, in_step=False),
    )
    turned = (thrust[:, 4:] + activity * np.radians(_NOISE_DEGREES) * noise[:, :3]) / 2
    tremble = lively * np.radians(_TREMBLE_DEGREES) * noise[:, 3:]
    neck, head = turned + tremble[:, :3], turned + tremble[:, 3:]
    trunk, forward = attitude[:, :3] + thrust[:, :3], attitude[:, 3] + thrust[:, 3]
    return HeadAttitude(trunk, attitude[:, 4:], neck, head, np.radians(FORWARD_DEGREES) + forward)


class _Moves(NamedTuple):
    """Movements of the seven angles: when they start and how long they last (K,), and by how much (K, 7)."""

    starts_s: FloatArray
    durations_s: FloatArray
    by: FloatArray

    def scaled(self, factor: float) -> "_Moves":
        return self._replace(by=factor * self.by)

    def by_clock(self, times_s: FloatArray, clock_s: FloatArray) -> "_Moves":
        """The same, starting when the clock is as late as at their starts."""
        past_s = np.minimum(self.starts_s - times_s[0], 0.0) + np.maximum(self.starts_s - times_s[-1], 0.0)
        return self._replace(starts_s=np.interp(self.starts_s, times_s, clock_s) + past_s)


def _held(end_s: float, phrases: Sequence[Interval], generator: np.random.Generator) -> tuple[FloatArray, _Moves]:
    """The first attitude (7,), and the movements to those that are held after it."""
    starts_s = np.array(list(_changes_s(end_s, phrases, generator)))
    drawn = clipped(generator.standard_normal((len(starts_s) + 1, len(_SPREAD))), -WIDEST, WIDEST)
    attitudes = _SPREAD * drawn
    attitudes[:, _YAW] = _turns(len(drawn), generator)
    durations_s = generator.uniform(*_MOVING_S, len(starts_s))
    return attitudes[0], _Moves(starts_s, durations_s, np.diff(attitudes, axis=0))


def _turns(count: int, generator: np.random.Generator) -> FloatArray:
    """The turns of the head (count,), to one side and the other in turn."""
    sides = np.where(np.arange(count) % 2 == 0, 1.0, -1.0) * generator.choice([-1.0, 1.0])
    return np.asarray(sides * np.radians(generator.uniform(*TURN_DEGREES, count)))


def _clock_s(times_s: FloatArray, words: Sequence[Word]) -> FloatArray:
    """A clock (T,) that runs with the time while words are heard and slowly between them."""
    rate: FloatArray = np.ones(len(times_s))
    heard = [word.interval for word in words if word.interval]
    for before, after in pairwise(heard):
        if after.start_s - before.end_s >= _PAUSE_S:
            rate[slice(*np.searchsorted(times_s, [before.end_s, after.start_s]))] = _IN_PAUSES
    frame_s = float(times_s[1] - times_s[0])
    rate = smoothed(rate, _SLOWING_S / frame_s)
    return np.asarray(times_s[0] + frame_s * np.concatenate([[0.0], np.cumsum(rate[:-1])]))


def waiting_for_words(times_s: FloatArray, words: Sequence[Word]) -> FloatArray:
    """The times (T,) of a head that turns slowly in pauses and makes up for it as the next words begin: people move
    their heads as they speak."""
    behind_s: FloatArray = np.zeros(len(times_s))
    heard = [word.interval for word in words if word.interval]
    for before, after in pairwise(heard):
        pause_s = after.start_s - before.end_s
        if pause_s >= _PAUSE_S:
            late_s = min((1 - _IN_PAUSES) * pause_s, _LATEST_S)
            edges_s = [before.end_s, before.end_s + late_s / (1 - _IN_PAUSES), after.start_s]
            course = np.interp(times_s, [*edges_s, after.start_s + _MADE_UP_S], [0.0, late_s, late_s, 0.0])
            behind_s = np.maximum(behind_s, course)
    return times_s - behind_s


def _changes_s(end_s: float, phrases: Sequence[Interval], generator: np.random.Generator) -> Iterator[float]:
    """When attitudes change: as phrases begin, as the last one ends, and in between."""
    begins_s = [phrase.start_s - _BEFORE_PHRASE_S for phrase in phrases] + [each.end_s for each in phrases[-1:]]
    last_s = -_AT_LEAST_S
    while last_s < end_s:
        due_s = _voiced_s(last_s + float(generator.uniform(_AT_LEAST_S, _AT_MOST_S)), phrases)
        last_s = next((at_s for at_s in begins_s if last_s + _MOVING_S[0] < at_s <= due_s), due_s)
        yield last_s


def _voiced_s(due_s: float, phrases: Sequence[Interval]) -> float:
    """When a change that is due is made: after the pause, if it falls into one that is short."""
    for before, after in pairwise(phrases):
        if before.end_s - _ENDING_S < due_s < after.start_s <= before.end_s + _SILENCE_S:
            return after.start_s - _BEFORE_PHRASE_S
    return due_s


def _thrusts(stressed_s: Sequence[float], generator: np.random.Generator) -> _Moves:
    """What stress adds: there, and back."""
    at_s = np.array(stressed_s)
    by = np.radians(_THRUST_DEGREES) * generator.uniform(2 / 3, 4 / 3, (len(at_s), 1))
    durations_s = np.repeat([_THRUST_S, 2 * _THRUST_S], len(at_s))
    return _Moves(np.concatenate([at_s - _THRUST_S, at_s]), durations_s, np.concatenate([by, -by]))
