"""How much space a gesture takes, by the sectors in which its stroke starts and ends.

The realizer plays gestures of its library larger or smaller; so sectors become a size: each sector further from the
centre of gesture space (`XC YCC ZMiddle`) makes it larger, nearer to the body smaller. The steps are ours.
"""

from collections.abc import Iterable
from statistics import fmean

from .annotation.model import Position
from .annotation.spans import DEPTHS, HEIGHTS, SIDEWAYS

USUAL_STEPS = 1.5
"""How many sectors from the centre the stroke of a usual gesture is."""

PER_STEP = 0.2
SMALLEST, LARGEST = 0.6, 1.6


def size_of(positions: Iterable[Position]) -> float:
    """The size of a gesture with these positions, 1 for a usual one."""
    steps = [_steps(position) for position in positions]
    if not steps:
        return 1.0
    return round(min(LARGEST, max(SMALLEST, 1 + PER_STEP * (fmean(steps) - USUAL_STEPS))), 3)


def _steps(position: Position) -> int:
    across = abs(SIDEWAYS.index(position.sideways) - SIDEWAYS.index("XC"))
    up = abs(HEIGHTS.index(position.height) - HEIGHTS.index("YCC"))
    return across + up + DEPTHS.index(position.depth) - DEPTHS.index("ZMiddle")
