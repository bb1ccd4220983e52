"""Small eye movements during fixation: drift, and saccades between the parts of a target.

A person looking at a face looks at one eye, the other eye and the mouth for about a second each. Conventions: radians,
pitch and yaw relative to the target's centre; seconds.
"""

import numpy as np

from ...model import FloatArray
from ..geometry.easing import superposed_movements
from ..geometry.noise import perlin

SACCADE_S, SACCADE_S_PER_RADIAN = 0.021, 0.0022 * 180 / np.pi
"""The main sequence of saccades: 2.2 ms per degree plus 21 ms (Carpenter 1988)."""

PARTS = np.radians([[0.0, 1.2], [0.0, -1.2], [1.3, 0.2]])
"""For a face at 1.2 m with eyes 6 cm apart; at most 2° from its centre in all."""

SHORTEST_S, MEAN_S = 0.3, 1.1
"""Fixation durations: the first is a minimum, the rest is drawn from an exponential distribution."""

DRIFT_DEGREES, DRIFT_HZ = 0.3, 1.7


def saccade_s(angle: FloatArray) -> FloatArray:
    """The durations of saccades of these angles."""
    return np.asarray(SACCADE_S + SACCADE_S_PER_RADIAN * angle)


def fixation_offsets(times_s: FloatArray, *, seed: int) -> FloatArray:
    """Pitch and yaw (T, 2) relative to the target's centre; deterministic for a seed."""
    when, where = (np.random.default_rng(each) for each in np.random.SeedSequence(seed).spawn(2))
    count = int((times_s[-1] - times_s[0]) / SHORTEST_S) + 2
    starts_s = times_s[0] + np.cumsum(SHORTEST_S + when.exponential(MEAN_S - SHORTEST_S, count))
    steps = where.integers(1, len(PARTS), count + 1)
    parts = PARTS[np.cumsum(steps) % len(PARTS)]
    by = np.diff(parts, axis=0)
    drift = perlin(times_s, frequency_hz=DRIFT_HZ, seed=seed + 5, channels=2, in_step=False)
    jumps = superposed_movements(times_s, starts_s, saccade_s(np.linalg.norm(by, axis=-1)), by)
    return np.asarray(parts[0] + jumps + np.radians(DRIFT_DEGREES) * drift)
