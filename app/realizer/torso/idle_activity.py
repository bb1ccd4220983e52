"""How the amount of idle movement depends on the speaker's agitation; the factors are ours."""

from collections.abc import Mapping
from types import MappingProxyType

from ...model import Level

IDLE_ACTIVITY: Mapping[Level, float] = MappingProxyType({Level.LOW: 0.8, Level.MEDIUM: 1.0, Level.HIGH: 1.25})
"""Factors of the amplitudes of sway and noise, and of the breathing rate."""
