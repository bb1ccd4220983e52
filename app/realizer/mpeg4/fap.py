"""Exports the face as MPEG-4 face animation parameters (Gesture Engine §4).

Distances are in shares of the face's own measures, 1/1024 of the distance between eyes, mouth and nose …, so that any
face can take them; `lexicon/fap.yaml` says how far each of ARKit's shapes moves them. Eyes turn by the angles of our
eyes, in 10⁻⁵ rad: yaw is positive to the left, pitch downwards. The head's angles from the top of the spine are its
neck's and its own, by yaw, pitch (positive downwards) and roll (to its right); a body's file has them as well.

FAP 1 and 2 say in a word what the others do: the two strongest visemes of the mouth, how far between them, and the two
strongest of six expressions. `viseme_def` and `expression_def` say that the low-level parameters define them. Greta
reads one number a parameter, and has the head in the body's file: for it neither these nor the head are set.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import numpy as np
from pydantic import RootModel
from scipy.spatial.transform import Rotation

from ...errors import AuthoringError, did_you_mean
from ...model import FloatArray
from ...model.formats import BapVersion
from ...yaml_files import Source
from ..body.motion import SHAPES, BodyMotion, Motion
from ..body.skeleton import Skeleton
from ..geometry.rotations import with_continuous_signs
from .bap import UNIT_RAD
from .layout import FAPS, FIELDS, Parameters, ReadParameters, euler_rad, parameter_file

VERSION = "2.1"
TABLE = "fap.yaml"
MOST = 63
"""The blend of a viseme that is alone, the intensity of a whole expression."""

EXPRESSIONS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "joy": ("mouthSmileLeft", "mouthSmileRight"),
        "sadness": ("mouthFrownLeft", "mouthFrownRight", "browInnerUp"),
        "anger": ("browDownLeft", "browDownRight", "eyeSquintLeft", "eyeSquintRight"),
        "fear": ("browInnerUp", "eyeWideLeft", "eyeWideRight", "mouthStretchLeft", "mouthStretchRight"),
        "disgust": ("noseSneerLeft", "noseSneerRight"),
        "surprise": ("browInnerUp", "browOuterUpLeft", "browOuterUpRight", "eyeWideLeft", "eyeWideRight"),
    }
)
"""MPEG-4's six expressions, counted from 1, and the shapes that each needs: those of Ekman and Friesen's action units
for it (EMFACS). One is shown as strongly as the weakest of them."""

_HEAD = ("head_pitch", "head_yaw", "head_roll")
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

    def weights(self, values: Mapping[str, FloatArray], frames: int) -> FloatArray:
        """The weights (T, 52), in [0, 1], that come nearest to parameters (T,); those not given are 0."""
        from scipy.optimize import lsq_linear  # imported late: only a file that is read back needs it

        matrix = np.zeros((len(self.amounts), len(SHAPES)))
        for row, shapes in enumerate(self.amounts.values()):
            for shape, amount in shapes.items():
                matrix[row, SHAPES.index(shape)] = amount
        wanted = np.stack([values.get(name, np.zeros(frames)) for name in self.amounts], axis=1)
        moved = np.flatnonzero(matrix.any(axis=0))
        found = np.zeros((frames, len(SHAPES)))
        for frame, row in enumerate(wanted):
            if frame and (row == wanted[frame - 1]).all():
                found[frame] = found[frame - 1]
            elif row.any():
                found[frame, moved] = lsq_linear(matrix[:, moved], row, (0.0, 1.0), method="bvls").x
        return found


def to_fap(
    motion: Motion,
    skeleton: Skeleton,
    table: FapTable,
    visemes: FloatArray | None = None,
    version: BapVersion = BapVersion.MPEG4,
) -> bytes:
    """The file; what the table has, eyes, head, viseme and expression are set in every frame. `visemes` (T, 15) are
    their weights, None where nothing is said."""
    columns = list(table.values(motion.shapes).items())
    for short, joint in _EYES:
        yaw, pitch, _roll = _turns(motion, skeleton, joint)
        columns += [(f"yaw_{short}_eyeball", yaw / UNIT_RAD), (f"pitch_{short}_eyeball", pitch / UNIT_RAD)]
    if version is not BapVersion.GRETA:
        yaw, pitch, roll = _turns(motion, skeleton, "neck", "head")
        columns += [(name, angle / UNIT_RAD) for name, angle in zip(_HEAD, (pitch, yaw, roll), strict=True)]
        columns += [("viseme", column) for column in _viseme(visemes, len(motion.shapes)).T]
        columns += [("expression", column) for column in _expression(motion.shapes).T]
    values = np.rint(np.stack([column for _, column in columns], axis=1)).astype(np.int64)
    names = tuple(name for name, _ in columns)
    return parameter_file(VERSION, ".fap", motion.frame_rate_hz, FAPS, Parameters(names, values))


def from_fap(
    file: ReadParameters, skeleton: Skeleton, table: FapTable, body: BodyMotion | None = None
) -> tuple[BodyMotion, FloatArray]:
    """The body with the file's eyes and, where it has none, its head; and the weights (T, 52) of the face.

    `body` has the same frames; None is one that stands in the T-pose.
    """
    turns = body.rotations.copy() if body else np.tile([0.0, 0.0, 0.0, 1.0], (file.frames, len(skeleton.names), 1))

    def turn(joint: str, yaw: str, pitch: str, roll: str = "") -> None:
        angles = [file.numbers.get(name, np.zeros(file.frames)) * UNIT_RAD for name in (yaw, pitch, roll)]
        turns[:, skeleton.index[joint]] = Rotation.from_euler("YXZ", np.stack(angles, axis=1)).as_quat()

    for short, joint in _EYES:
        turn(joint, f"yaw_{short}_eyeball", f"pitch_{short}_eyeball")
    if body is None:
        turn("head", "head_yaw", "head_pitch", "head_roll")
    times_s = np.arange(file.frames) / file.rate_hz
    hips_m = body.hips_m if body else np.tile(skeleton.offsets_m[0], (file.frames, 1))
    return BodyMotion(times_s, with_continuous_signs(turns), hips_m), table.weights(file.numbers, file.frames)


def named_shapes(file: ReadParameters, visemes: FloatArray) -> FloatArray:
    """The weights (T, 52) that FAP 1 and 2 name, by the shapes of the visemes (15, 52) and the action units of the
    expressions."""

    def told(name: str) -> FloatArray:
        return file.numbers.get(name, np.zeros(file.frames))

    def viseme(name: str) -> FloatArray:
        return np.asarray(visemes[np.clip(told(name), 0, len(visemes) - 1).astype(int)])

    blend = np.clip(told("viseme_blend") / MOST, 0.0, 1.0)[:, None]
    shapes: FloatArray = blend * viseme("viseme_select1") + (1 - blend) * viseme("viseme_select2")
    for place in ("1", "2"):
        intensity = np.clip(told(f"expression_intensity{place}") / MOST, 0.0, 1.0)
        for number, needed in enumerate(EXPRESSIONS.values(), start=1):
            shown = np.where(told(f"expression_select{place}") == number, intensity, 0.0)
            for name in needed:
                column = SHAPES.index(name)
                shapes[:, column] = np.maximum(shapes[:, column], shown)
    return np.clip(shapes, 0.0, 1.0)


def _turns(motion: Motion, skeleton: Skeleton, *chain: str) -> FloatArray:
    """The angles (3, T) of joints that follow each other, about Y, then X, then Z."""
    found = Rotation.identity()
    for joint in chain:
        found = found * Rotation.from_quat(motion.body.rotations[:, skeleton.index[joint]])
    return euler_rad(found, "YXZ").T


def _viseme(weights: FloatArray | None, frames: int) -> FloatArray:
    """FAP 1 (T, 4): the two strongest visemes and the first one's share of both; none where nothing is said."""
    told = np.zeros((frames, len(FIELDS["viseme"])))
    told[:, 2:] = (MOST, 1)
    if weights is None:
        return told
    order = np.argsort(-weights, axis=1, kind="stable")[:, :2]
    first, second = np.take_along_axis(weights, order, axis=1).T
    told[:, :2] = np.where(np.stack([first, second], axis=1) > 0, order, 0)
    told[:, 2] = np.rint(MOST * np.divide(first, first + second, out=np.ones(frames), where=first + second > 0))
    return told


def _expression(shapes: FloatArray) -> FloatArray:
    """FAP 2 (T, 6): the two strongest expressions, each with its intensity."""
    shown = np.stack(
        [shapes[:, [SHAPES.index(name) for name in needed]].min(axis=1) for needed in EXPRESSIONS.values()], axis=1
    )
    order = np.argsort(-shown, axis=1, kind="stable")[:, :2]
    intensities = np.rint(MOST * np.clip(np.take_along_axis(shown, order, axis=1), 0.0, 1.0))
    told = np.zeros((len(shapes), len(FIELDS["expression"])))
    told[:, [0, 2]] = np.where(intensities > 0, order + 1, 0)
    told[:, [1, 3]] = intensities
    told[:, -1] = 1
    return told
