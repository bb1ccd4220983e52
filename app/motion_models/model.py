"""A motion model: what was learnt from recordings of speech with their motion, in one .npz file without pickles.

One semi-Markov model of kinds of movements (AHG eq. 7 to 14) with the emissions of each set of features: f^p, the
prosody alone; f^a, affect alone; f^ap, both; f^AP, their first two principal components (AHG §3.4); and the labels of
intonation phrases, as RTS has them (eq. 2.2). The recorded movements are in it as units.

A scenario says which features drive the decoding, and what affect does in the choice of units: S1 to S6 are those of
AHG's Table 1, RTS is the thesis.
"""

import io
import zipfile
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..model import FloatArray
from ..prosody_gestures.semi_markov import (
    DiscreteEmissions,
    Emissions,
    IntArray,
    MixtureEmissions,
    Segment,
    SemiMarkovModel,
    states_by_frame,
)
from ..prosody_gestures.trellis import EVERYTHING, Search
from ..prosody_gestures.voice_model import decode
from ..realizer.geometry.rotations import normalized, to_rotation_vector
from .clustering import ParallelBranches
from .pairs import Voice, arms_of
from .unit_selection import MotionUnit, UnitPool, Weights, paper_weights, thesis_weights

FORM = 1
FEATURES = ("p", "a", "ap", "AP")
LABELS = "labels"
THESIS_ALPHA = 0.5
FRAME_WEIGHT = 0.3
"""What a frame's likelihood counts. The sources count each frame whole, as if it told nothing of the next one; windows
overlap and voices change slowly, so that phrases came out a third as long as recorded ones and units were played three
times too fast (docs/measurements/prosody.md)."""
_ROTATION = 32767.0


@dataclass(frozen=True, slots=True)
class Scenario:
    """What drives the decoding, and the costs of units."""

    name: str
    features: str
    weights: Weights


SCENARIOS: Mapping[str, Scenario] = MappingProxyType(
    {
        each.name: each
        for each in (
            Scenario("S1", "ap", paper_weights(1.0)),
            Scenario("S2", "ap", paper_weights(0.0)),
            Scenario("S3", "p", paper_weights(1.0)),
            Scenario("S4", "p", paper_weights(0.0)),
            Scenario("S5", "a", paper_weights(1.0)),
            Scenario("S6", "a", paper_weights(0.0)),
            Scenario("RTS", LABELS, thesis_weights(THESIS_ALPHA)),
        )
    }
)


@dataclass(frozen=True, slots=True, eq=False)
class Fusion:
    """Scales prosody and affect (9 numbers a frame) to mean 0 and deviation 1; `axes` (9 × 2) are the principal
    components."""

    mean: FloatArray
    deviation: FloatArray
    axes: FloatArray

    def features(self, voice: Voice, name: str) -> FloatArray:
        """The features (frames × numbers) of a set of `FEATURES`."""
        both: FloatArray = (np.concatenate([voice.prosody, voice.affect], axis=1) - self.mean) / self.deviation
        match name:
            case "p":
                return both[:, : voice.prosody.shape[1]]
            case "a":
                return both[:, voice.prosody.shape[1] :]
            case "AP":
                return both @ self.axes
        return both


@dataclass(frozen=True, slots=True, eq=False)
class MotionModel:
    """`about` says what it was learnt from. `kinds` has no emissions of its own: `emissions` has those of each set of
    features and of `LABELS`, which `intonation` finds. Units move these `joints` of our skeleton."""

    about: str
    joints: tuple[str, ...]
    kinds: SemiMarkovModel
    emissions: Mapping[str, Emissions]
    fusion: Fusion
    intonation: ParallelBranches
    units: tuple[MotionUnit, ...]

    def log_likelihoods(self, voice: Voice, features: str) -> FloatArray:
        """Those of each kind (frames × kinds) by a set of features, as much as they count."""
        observed = self.labels(voice) if features == LABELS else self.fusion.features(voice, features)
        return FRAME_WEIGHT * self.emissions[features].log_likelihoods(observed)

    def labels(self, voice: Voice) -> IntArray:
        """The intonation phrase of each frame (RTS §2.2)."""
        return states_by_frame(self.intonation.segment(self.fusion.features(voice, "p")))

    def path(self, voice: Voice, features: str, search: Search = EVERYTHING) -> tuple[Segment, ...]:
        """The likeliest kinds of movements for a whole recording."""
        return decode(self.kinds, self.log_likelihoods(voice, features), search)

    def pool(self) -> UnitPool:
        return UnitPool.of(self.units)

    def content(self) -> bytes:
        """The file, the same bytes for the same model."""
        arrays = dict(_arrays(self))
        content = io.BytesIO()
        with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, array in arrays.items():
                written = io.BytesIO()
                np.lib.format.write_array(written, np.asarray(array), allow_pickle=False)
                archive.writestr(zipfile.ZipInfo(f"{name}.npy", (1980, 1, 1, 0, 0, 0)), written.getvalue())
        return content.getvalue()

    @staticmethod
    def read(content: bytes, name: str) -> "MotionModel":
        """The model in a file called `name`. Raises InputError `motion_model`."""
        try:
            if not zipfile.is_zipfile(io.BytesIO(content)):
                raise ValueError("it is not an .npz file")
            with np.load(io.BytesIO(content), allow_pickle=False) as file:
                arrays = dict(file)
            form = int(arrays["form"])
            if form != FORM:
                raise ValueError(f"its format is {form}, not {FORM}: retrain it")
            return _read(arrays)
        except MemoryError:
            raise InputError("motion_model", f"{name}: too large for memory", field="motion_model") from None
        except (KeyError, ValueError, TypeError, EOFError, IndexError, zipfile.BadZipFile, zlib.error) as error:
            message = f"{name}: not a motion model (understudy motion-model train writes one): {error}"
            raise InputError("motion_model", message, field="motion_model") from None

    @staticmethod
    def load(path: Path) -> "MotionModel":
        """Raises InputError `motion_model`, OSError."""
        return MotionModel.read(path.read_bytes(), str(path))


def is_model(path: Path) -> bool:
    """Whether a file is a motion model, and not a recording's arrays."""
    return zipfile.is_zipfile(path) and "form.npy" in zipfile.ZipFile(path).namelist()


def units_of(
    path: Sequence[Segment], joints: tuple[str, ...], rotations: FloatArray, affect: FloatArray
) -> Iterator[MotionUnit]:
    """The units of a recording: its motion, cut where its phrases begin."""
    angles = arm_angles(joints, rotations)
    for each in path:
        part = slice(each.start, each.end)
        yield MotionUnit(each.state, rotations[part], angles[[each.start, each.end - 1]], affect[part].mean(axis=0))


def arm_angles(joints: tuple[str, ...], rotations: FloatArray) -> FloatArray:
    """The twelve angles of the arms (frames × 12), a rotation vector a joint. AHG has Euler angles, which jump where
    the second of them is a right angle."""
    return to_rotation_vector(arms_of(joints, rotations)).reshape(len(rotations), -1)


def _arrays(model: MotionModel) -> Iterator[tuple[str, NDArray[Any]]]:
    yield "form", np.array(FORM)
    yield "about", np.array(model.about)
    yield "joints", np.array(model.joints)
    for name in ("log_initial", "log_transition", "log_duration"):
        yield name, getattr(model.kinds, name).astype(np.float32)
    for name in ("mean", "deviation", "axes"):
        yield name, getattr(model.fusion, name)
    yield "intonation_means", model.intonation.means.astype(np.float32)
    yield "intonation_variances", model.intonation.variances.astype(np.float32)
    for name, emissions in model.emissions.items():
        if isinstance(emissions, MixtureEmissions):
            for part in ("log_weights", "means", "variances"):
                yield f"{name}/{part}", getattr(emissions, part).astype(np.float32)
        elif isinstance(emissions, DiscreteEmissions):
            yield f"{name}/log_probability", emissions.log_probability.astype(np.float32)
    yield "unit_state", np.array([unit.state for unit in model.units])
    yield "unit_frames", np.array([len(unit.rotations) for unit in model.units])
    yield "unit_affect", np.stack([unit.affect for unit in model.units]).astype(np.float32)
    motion = np.concatenate([unit.rotations for unit in model.units])
    yield "motion", np.round(normalized(motion) * _ROTATION).astype(np.int16)


def _read(arrays: Mapping[str, FloatArray]) -> MotionModel:
    joints = tuple(map(str, arrays["joints"]))
    numbers = {name: array.astype(np.float64) for name, array in arrays.items() if array.dtype.kind in "fi"}
    _check(numbers, len(joints))
    kinds = len(numbers["log_initial"])
    emissions: dict[str, Emissions] = {
        name: MixtureEmissions(*(numbers[f"{name}/{part}"] for part in ("log_weights", "means", "variances")))
        for name in FEATURES
    }
    emissions[LABELS] = DiscreteEmissions(numbers[f"{LABELS}/log_probability"])
    return MotionModel(
        about=str(arrays["about"]),
        joints=joints,
        kinds=SemiMarkovModel(
            tuple(map(str, range(kinds))),
            numbers["log_initial"],
            numbers["log_transition"],
            numbers["log_duration"],
            emissions["p"],
        ),
        emissions=MappingProxyType(emissions),
        fusion=Fusion(numbers["mean"], numbers["deviation"], numbers["axes"]),
        intonation=ParallelBranches(numbers["intonation_means"], numbers["intonation_variances"]),
        units=tuple(_units(joints, numbers)),
    )


def _check(numbers: Mapping[str, FloatArray], joints: int) -> None:
    """Raises ValueError for arrays that do not go together, and numbers that are none; only logarithms may be -inf."""
    for name, array in numbers.items():
        is_logarithm = name.rpartition("/")[2].startswith("log_")
        if not np.isfinite(np.where(array == -np.inf, 0.0, array) if is_logarithm else array).all():
            raise ValueError(f"{name} has values that are not finite numbers")
    kinds, motion, states = len(numbers["log_initial"]), numbers["motion"], numbers["unit_state"]
    by_kind = [each for name, each in numbers.items() if name.startswith("log_") or "/" in name]
    if numbers["log_transition"].shape != (kinds, kinds) or any(len(each) != kinds for each in by_kind):
        raise ValueError("its tables do not have one row for each kind")
    if motion.shape != (len(motion), joints, 4) or not motion.any(axis=2).all():
        raise ValueError("its motion is not a rotation of each joint")
    if not (states >= 0).all() or not (states < kinds).all() or not (numbers["unit_frames"] >= 1).all():
        raise ValueError("its units have no kind or no frame")


def _units(joints: tuple[str, ...], numbers: Mapping[str, FloatArray]) -> Iterator[MotionUnit]:
    rotations = normalized(numbers["motion"])
    angles = arm_angles(joints, rotations)
    ends = np.cumsum(numbers["unit_frames"]).astype(int).tolist()
    starts = [0, *ends[:-1]]
    states, affects = numbers["unit_state"].astype(int).tolist(), numbers["unit_affect"]
    if ends[-1] != len(rotations):
        raise ValueError("its units are not as long as its motion")
    for state, start, end, affect in zip(states, starts, ends, affects, strict=True):
        yield MotionUnit(state, rotations[start:end], angles[[start, end - 1]], affect)
