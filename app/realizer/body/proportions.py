"""How a body differs from the average adult for whom all tables of the realizer are written: factors by joint.

Bones and flesh of joint J are `scale` times as long; its flesh is `width(J)` as wide from side to side and `depth(J)`
as deep as in the tables. Heads differ less than bodies: their scale is the root of the height's. The averages of the
sexes are rounded from anthropometry (biacromial breadth .227 and .221 of the height, hip breadth .199 and .221 in men
and women); the neutral body lies between.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from ...model.figure import AVERAGE_HEIGHT_M, Physique, Sex

CROWN_M = 0.20
"""From the head's joint to the top of the hair."""

STOOPING_AGE_YEARS = 60
_STOOP_M_PER_YEAR = 0.0008


@dataclass(frozen=True, slots=True)
class _Average:
    """What is average for a sex, beside the neutral body: widths, and the girth of trunk, limbs and neck."""

    shoulders: float = 1.0
    hips: float = 1.0
    waist: float = 1.0
    limbs: float = 1.0
    neck: float = 1.0


_AVERAGES: Mapping[Sex, _Average] = MappingProxyType(
    {
        Sex.NEUTRAL: _Average(),
        Sex.FEMALE: _Average(shoulders=0.95, hips=1.06, waist=0.88, limbs=0.93, neck=0.86),
        Sex.MALE: _Average(shoulders=1.05, hips=0.96, waist=1.02, limbs=1.05, neck=1.10),
    }
)


@dataclass(frozen=True, slots=True)
class Proportions:
    """The factors of a body; `shoulders` and `hips` are those of the distances between left and right joints."""

    physique: Physique

    @property
    def head(self) -> float:
        return float((self.physique.height_m / AVERAGE_HEIGHT_M) ** 0.5)

    @property
    def scale(self) -> float:
        """Of all bones below the head, so that the whole is as tall as it should be."""
        return (self.physique.height_m - CROWN_M * self.head) / (AVERAGE_HEIGHT_M - CROWN_M)

    @property
    def shoulders(self) -> float:
        return self.scale * self.physique.shoulder_width * self._average.shoulders * self._girth(0.25)

    @property
    def hips(self) -> float:
        return self.scale * self.physique.hip_width * self._average.hips * self._girth(0.35)

    @property
    def stoop_m(self) -> float:
        """How far old age carries the head forward."""
        return _STOOP_M_PER_YEAR * max(0, self.physique.age_years - STOOPING_AGE_YEARS) * self.scale

    def width(self, joint: str) -> float:
        """The factor of the flesh's width at a joint."""
        waist = self.scale * self.physique.build * self._average.waist
        trunk = {
            "hips": self.hips * self._girth(0.35),
            "spine": 0.5 * (waist + self.hips * self._girth(0.35)),
            "chest": 0.5 * (waist + self.shoulders * self._girth(0.5)),
            "upperChest": self.shoulders * self._girth(0.35),
        }
        return trunk.get(joint, self._limb(joint))

    def depth(self, joint: str) -> float:
        """The factor of the flesh's depth at a joint; limbs are as deep as they are wide."""
        build = self.scale * self.physique.build
        trunk = {
            "hips": build,
            "spine": build * self._average.waist * self._girth(0.25),
            "chest": build,
            "upperChest": self.scale * self._girth(0.6),
        }
        return trunk.get(joint, self._limb(joint))

    def _limb(self, joint: str) -> float:
        """Necks, hands and feet vary less in girth than arms and legs."""
        if joint in {"head", "leftEye", "rightEye"}:
            return self.head
        if joint == "neck":
            return self.scale * self._average.neck * self._girth(0.4)
        part = joint.removeprefix("left").removeprefix("right")
        power = 0.7 if part in {"Shoulder", "UpperArm", "LowerArm", "UpperLeg", "LowerLeg"} else 0.2
        return self.scale * self._average.limbs * self._girth(power)

    def _girth(self, power: float) -> float:
        """The build, less where people of different build differ less."""
        return float(self.physique.build**power)

    @property
    def _average(self) -> _Average:
        return _AVERAGES[self.physique.sex]


AVERAGE = Proportions(Physique())
"""The body for which the tables are written."""
