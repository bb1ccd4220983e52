"""Exports the face as MPEG-4 face animation parameters (Gesture Engine §4).

Distances are in shares of the face's own measures, 1/1024 of the distance between eyes, mouth and nose …, so that any
face can take them; `lexicon/fap.yaml` says how far each of ARKit's shapes moves them. Eyes turn by the angles of our
eyes, in 10⁻⁵ rad: yaw is positive to the left, pitch downwards. The head turns in the body's file.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import numpy as np
from pydantic import RootModel

from ...errors import AuthoringError, did_you_mean
from ...model import FloatArray
from ...yaml_files import Source
from ..body.motion import SHAPES, Motion
from ..body.skeleton import Skeleton
from .bap import UNIT_RAD
from .layout import FAPS, Parameters, parameter_file

VERSION = "2.1"
TABLE = "fap.yaml"
_EYES = (("l", "leftEye"), ("r", "rightEye"))


@dataclass(frozen=True, slots=True)
class FapTable:
    """How far each shape, wholly shown, moves a parameter, in its own unit."""

    amounts: Mapping[str, Mapping[str, float]]

    @classmethod
    def load(cls, path: Path) -> "FapTable":
        """The table of a file. Raises AuthoringError for parameters and shapes that there are not."""
        source = Source(path)
        written = source.validated(RootModel[dict[str, dict[str, float]]]).root
        mistakes = [
            source.mistake((name,), f"MPEG-4 has no parameter {name}{did_you_mean(name, FAPS)}")
            for name in written
            if name not in FAPS
        ]
        mistakes += [
            source.mistake((name, shape), f"the face has no shape {shape}{did_you_mean(shape, SHAPES)}")
            for name, shapes in written.items()
            for shape in shapes
            if shape not in SHAPES
        ]
        if mistakes:
            raise AuthoringError(tuple(mistakes))
        return cls(MappingProxyType(written))

    def values(self, weights: FloatArray) -> dict[str, FloatArray]:
        """The parameters (T,) of a face with these weights (T, 52)."""
        matrix = np.zeros((len(SHAPES), len(self.amounts)))
        for column, shapes in enumerate(self.amounts.values()):
            for shape, amount in shapes.items():
                matrix[SHAPES.index(shape), column] = amount
        return dict(zip(self.amounts, (np.clip(weights, 0.0, 1.0) @ matrix).T, strict=True))


def to_fap(motion: Motion, skeleton: Skeleton, table: FapTable) -> bytes:
    """The file; what the table has and the eyes are set in every frame."""
    columns = table.values(motion.shapes)
    for short, joint in _EYES:
        x, y, z, w = motion.body.rotations[:, skeleton.index[joint]].T
        pitch = np.arctan2(2 * (w * x - y * z), 1 - 2 * (x * x + z * z))
        yaw = np.arctan2(2 * (w * y - x * z), 1 - 2 * (y * y + z * z))
        columns |= {f"yaw_{short}_eyeball": yaw / UNIT_RAD, f"pitch_{short}_eyeball": pitch / UNIT_RAD}
    values = np.rint(np.stack(list(columns.values()), axis=1)).astype(np.int64)
    return parameter_file(VERSION, ".fap", motion.frame_rate_hz, FAPS, Parameters(tuple(columns), values))
