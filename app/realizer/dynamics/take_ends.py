"""Bodies that gather speed in the first moments and lose it in the last ones: no take begins or ends in mid-move.

The time of arms and trunk stands at the very ends and is up to half as fast again a little further in; in between it is
the time of the performance, and the first and the last pose are those of the first and the last frame.
"""

import numpy as np

from ...model import FloatArray

_STANDS_S = 0.02
"""How long the clock of arms and trunk stands at either end."""


def eased_at_the_ends(times_s: FloatArray, over_s: float) -> FloatArray:
    """The times (T,) at which bodies are posed in the frames at `times_s`: at rest at both ends, as they are `over_s`
    further in."""
    span_s = min(over_s, float(times_s[-1] - times_s[0]) / 2)
    if span_s <= _STANDS_S:
        return times_s
    since_s, left_s = times_s - times_s[0], times_s[-1] - times_s
    return np.asarray(times_s - _behind_s(since_s, span_s) + _behind_s(left_s, span_s))


def _behind_s(from_end_s: FloatArray, span_s: float) -> FloatArray:
    """How far a clock that begins at rest, with no acceleration either, is behind one that does not: of the span,
    s - r³(6 - 8r + 3r²), where r is the share of the time in which it does not stand."""
    share = np.clip((from_end_s - _STANDS_S) / (span_s - _STANDS_S), 0.0, 1.0)
    behind = np.minimum(from_end_s / span_s, 1.0)
    return np.asarray(span_s * (behind - share**3 * (6.0 - share * (8.0 - 3.0 * share))))
