"""Eases the motion in at the start of a take and out at its end, so that no take begins or ends in mid-movement.

The clock of arms and trunk stands still at both ends, and runs up to 1.5 times as fast a little further in; in between
it is the clock of the performance. The first and the last pose are those of the first and the last frame.
"""

import numpy as np

from ...model import FloatArray

_STANDS_S = 0.02
"""The time for which the clock of arms and trunk stands still at either end."""


def eased_at_the_ends(times_s: FloatArray, over_s: float) -> FloatArray:
    """The times (T,) of the poses for frames at `times_s`: the clock stands still at both ends, and is that of the
    performance from `over_s` further in."""
    span_s = min(over_s, float(times_s[-1] - times_s[0]) / 2)
    if span_s <= _STANDS_S:
        return times_s
    since_s, left_s = times_s - times_s[0], times_s[-1] - times_s
    return np.asarray(times_s - _behind_s(since_s, span_s) + _behind_s(left_s, span_s))


def _behind_s(from_end_s: FloatArray, span_s: float) -> FloatArray:
    """The lag of a clock that starts without speed and acceleration behind a uniform one, relative to the span:
    s - r³(6 - 8r + 3r²), where r is the share of the time in which the clock does not stand still."""
    share = np.clip((from_end_s - _STANDS_S) / (span_s - _STANDS_S), 0.0, 1.0)
    behind = np.minimum(from_end_s / span_s, 1.0)
    return np.asarray(span_s * (behind - share**3 * (6.0 - share * (8.0 - 3.0 * share))))
