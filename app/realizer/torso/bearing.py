"""How people of different temper carry themselves: who is agitated leans forward with the chest lifted, who is lax
leans back a little and lets the upper back round.

Conventions: degrees in the tables, radians elsewhere; positive pitch is forward. The angles are ours.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Level


@dataclass(frozen=True, slots=True)
class Bearing:
    """The lean of the whole trunk from the hips, and the bow of the back above them."""

    lean_deg: float
    bow_deg: float


BEARINGS: Mapping[Level, Bearing] = MappingProxyType(
    {Level.LOW: Bearing(-1.5, 5.0), Level.MEDIUM: Bearing(0.0, 0.0), Level.HIGH: Bearing(3.0, -3.0)}
)

_BOW: Mapping[str, float] = MappingProxyType({"hips": 0.0, "spine": 0.25, "chest": 0.40, "upperChest": 0.35})
"""The joints' shares of a bow."""


@cache
def bow(level: Level) -> FloatArray:
    """The pitch of the joints from the hips up (4,), beside the lean. Never mutated."""
    return np.asarray(np.radians(BEARINGS[level].bow_deg) * np.array(list(_BOW.values())))


def lean(level: Level) -> float:
    """The lean of the trunk in radians, for which the hips go the other way."""
    return float(np.radians(BEARINGS[level].lean_deg))
