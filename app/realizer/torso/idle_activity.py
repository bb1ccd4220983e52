"""How the amount of idle movement depends on the speaker's agitation and the schedule's stillness; the factors
are ours."""

from collections.abc import Mapping
from types import MappingProxyType

from ...model import Level, Schedule

IDLE_ACTIVITY: Mapping[Level, float] = MappingProxyType({Level.LOW: 0.75, Level.MEDIUM: 1.0, Level.HIGH: 1.3})
"""Factors of the amplitudes of sway and noise, and of the breathing rate."""


def idle_activity(schedule: Schedule) -> float:
    """The factor of the amplitudes of all idle movement except breathing: 0 at a stillness of 1."""
    return IDLE_ACTIVITY[schedule.agitation] * (1 - schedule.stillness)
