"""How movements that somebody wants run between their ends: by minimum jerk, from rest to rest (Flash & Hogan 1985).

Conventions: times are seconds, (T,); a course has a column for each quantity, (T, C).
"""

import numpy as np

from app.model import FloatArray

SHORTEST_S = 1e-3
"""Movements of no duration take this long, so that no course ever jumps."""


def minimum_jerk(share: FloatArray) -> FloatArray:
    """How much of the way is done after `share` of the time: 6t⁵ - 15t⁴ + 10t³, 0 before the start, 1 after the end."""
    share = np.clip(share, 0.0, 1.0)
    return np.asarray(share**3 * (10.0 + share * (6.0 * share - 15.0)))


def changes(times_s: FloatArray, starts_s: FloatArray, durations_s: FloatArray, by: FloatArray) -> FloatArray:
    """The sum (T, C) of movements by `by` (K, C) that last. One that starts before the other ended is laid over it, as
    people do when a target jumps (Flash & Henis 1991), so speed has no steps."""
    durations_s = np.maximum(durations_s, SHORTEST_S)
    done = minimum_jerk((np.asarray(times_s)[:, None] - starts_s) / durations_s)
    return np.asarray(done @ by)


def through(times_s: FloatArray, at_s: FloatArray, values: FloatArray) -> FloatArray:
    """The course (T,) that rests in `values` (K,) at the rising times `at_s` (K,), and stays there before and after."""
    if len(at_s) == 1:
        return np.full(len(times_s), values[0])
    return np.asarray(values[0] + changes(times_s, at_s[:-1], np.diff(at_s), np.diff(values)[:, None])[:, 0])


def plateau(times_s: FloatArray, start_s: float, reached_s: float, left_s: float, end_s: float) -> FloatArray:
    """From 0 at `start_s` to 1 from `reached_s` to `left_s`, and back to 0 at `end_s`."""
    rise = minimum_jerk((times_s - start_s) / max(reached_s - start_s, SHORTEST_S))
    fall = minimum_jerk((times_s - left_s) / max(end_s - left_s, SHORTEST_S))
    return np.asarray(rise * (1.0 - fall))
