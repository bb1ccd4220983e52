"""Arms that gather speed in the first moments and lose it in the last ones, so that no take begins or ends in mid-move.

The time of the arms runs slower at the very ends and a third faster a little further in; in between it is the time of
the performance, and the first and the last pose are those of the first and the last frame.
"""

import numpy as np

from ...model import FloatArray


def eased_at_the_ends(times_s: FloatArray, over_s: float) -> FloatArray:
    """The times (T,) at which arms are posed in the frames at `times_s`: at rest at both ends, as they are `over_s`
    further in."""
    span_s = min(over_s, float(times_s[-1] - times_s[0]) / 2)
    if span_s <= 0:
        return times_s
    since_s, left_s = times_s - times_s[0], times_s[-1] - times_s
    return np.asarray(times_s - _behind_s(since_s, span_s) + _behind_s(left_s, span_s))


def _behind_s(from_end_s: FloatArray, span_s: float) -> FloatArray:
    """How far a clock that begins at rest is behind one that does not: s - s²(2 - s) of the span."""
    share = np.clip(from_end_s / span_s, 0.0, 1.0)
    return np.asarray(span_s * (share - share**2 * (2.0 - share)))
