"""The size of a gesture, derived from the sectors in which its stroke starts and ends.

The realizer can scale the gestures of its library, so sectors are converted to a size: each step away from the centre
of gesture space (`XC YCC ZMiddle`) makes a gesture larger, a step towards the body smaller. The step sizes are ours.
"""

from collections.abc import Iterable
from statistics import fmean

from .annotation.model import Position
from .annotation.spans import DEPTHS, HEIGHTS, SIDEWAYS

USUAL_STEPS = 1.5
"""The distance of an average gesture's stroke from the centre, in sectors."""

PER_STEP = 0.2
SMALLEST, LARGEST = 0.6, 1.6


def size_of(positions: Iterable[Position]) -> float:
    """The size of a gesture with these positions; 1 is average."""
    steps = [_steps(position) for position in positions]
    if not steps:
        return 1.0
    return round(min(LARGEST, max(SMALLEST, 1 + PER_STEP * (fmean(steps) - USUAL_STEPS))), 3)


def _steps(position: Position) -> int:
    across = abs(SIDEWAYS.index(position.sideways) - SIDEWAYS.index("XC"))
    up = abs(HEIGHTS.index(position.height) - HEIGHTS.index("YCC"))
    return across + up + DEPTHS.index(position.depth) - DEPTHS.index("ZMiddle")
