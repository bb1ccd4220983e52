"""How much the body moves and breathes by itself, by the speaker's agitation and the schedule's stillness; the factors
are ours."""

from collections.abc import Mapping
from types import MappingProxyType

from ...model import Level, Schedule

LIVELINESS: Mapping[Level, float] = MappingProxyType({Level.LOW: 0.8, Level.MEDIUM: 1.0, Level.HIGH: 1.25})
"""Of the sizes of sway and noise, and of the rate of breath."""


def liveliness(schedule: Schedule) -> float:
    """The factor of all that the body does by itself but breathe: none of it at a stillness of 1."""
    return LIVELINESS[schedule.agitation] * (1 - schedule.stillness)
