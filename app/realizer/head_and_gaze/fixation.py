"""Eyes that rest on something are not still: they drift, and jump between its parts.

Whoever looks at a face looks at one of its eyes, at the other, at the mouth's side of the nose, for about a second
each. Conventions: radians, pitch and yaw beside the target's middle; seconds.
"""

import numpy as np

from ...model import FloatArray
from ..geometry.easing import changes
from ..geometry.noise import perlin

SACCADE_S, SACCADE_S_PER_RADIAN = 0.021, 0.0022 * 180 / np.pi
"""The main sequence of saccades: 2.2 ms a degree and 21 ms (Carpenter 1988)."""

PARTS = np.radians([[0.0, 1.2], [0.0, -1.2], [1.3, 0.2]])
"""Of a face at 1.2 m, whose eyes are 6 cm apart; no more than 2° in all from its middle."""

SHORTEST_S, MEAN_S = 0.3, 1.1
"""How long the eyes stay at a part: no less than the first, the rest as chance has it (exponential)."""

DRIFT_DEGREES, DRIFT_HZ = 0.3, 1.7


def saccade_s(angle: FloatArray) -> FloatArray:
    """How long saccades of these angles take."""
    return np.asarray(SACCADE_S + SACCADE_S_PER_RADIAN * angle)


def fixating(times_s: FloatArray, *, seed: int) -> FloatArray:
    """Pitch and yaw (T, 2) beside the middle of what is looked at; the same seed looks about alike."""
    when, where = np.random.default_rng(seed).spawn(2)
    count = int((times_s[-1] - times_s[0]) / SHORTEST_S) + 2
    starts_s = times_s[0] + np.cumsum(SHORTEST_S + when.exponential(MEAN_S - SHORTEST_S, count))
    steps = where.integers(1, len(PARTS), count + 1)
    parts = PARTS[np.cumsum(steps) % len(PARTS)]
    by = np.diff(parts, axis=0)
    drift = perlin(times_s, frequency_hz=DRIFT_HZ, seed=seed + 5, channels=2, in_step=False)
    jumps = changes(times_s, starts_s, saccade_s(np.linalg.norm(by, axis=-1)), by)
    return np.asarray(parts[0] + jumps + np.radians(DRIFT_DEGREES) * drift)
