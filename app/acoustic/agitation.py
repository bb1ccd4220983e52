"""The speaker's agitation, low, medium or high, from the voice alone (paper §3.1.4).

A fuzzy-input fuzzy-output support vector machine (F²SVM; Thiel, Scherer & Schwenker 2007) judges the utterance's median
MFCC. One machine with a radial basis kernel stands for each level against the other two; its decision value becomes a
membership through a logistic function, and the three memberships are scaled to sum to 1. `training/agitation/` trains
it; here it is evaluated with numpy alone.

On disk it is `agitation.npz` (no pickles) and beside it `agitation.npz.sha256`, as `sha256sum` writes it.
"""

import hashlib
import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.errors import ServiceError
from app.model import Agitation, FloatArray, Level

MODEL_FILE = "agitation.npz"
CHECKSUM_FILE = "agitation.npz.sha256"
ACTIVE_RANGE_DB = 20.0


def voice_features(mfcc: FloatArray, energy_db: FloatArray, *, active_range_db: float = ACTIVE_RANGE_DB) -> FloatArray:
    """Median of the MFCC over the frames within `active_range_db` of the loudest; shape (coefficients,).

    The paper takes all frames. Pauses and room say nothing of the voice, and leaving them out is the largest single
    gain in accuracy (`python -m benchmarks.agitation --ablation`).
    """
    active = energy_db >= energy_db.max() - active_range_db
    features: FloatArray = np.median(mfcc[active], axis=0)
    return features


@dataclass(frozen=True, slots=True, eq=False)
class Machine:
    """One level against the rest: a support vector machine, and the logistic function that makes it a membership."""

    support_vectors: FloatArray
    coefficients: FloatArray
    intercept: float
    slope: float
    offset: float

    def decision_value(self, point: FloatArray, gamma: float) -> float:
        """Distance from the decision surface in the kernel's space, positive on the level's side."""
        squared_distances = np.sum((self.support_vectors - point) ** 2, axis=1)
        return float(self.coefficients @ np.exp(-gamma * squared_distances) + self.intercept)

    def membership(self, decision_value: float) -> float:
        """The decision value as a membership in (0, 1), not yet scaled against the other levels."""
        return float(1 / (1 + np.exp(-(self.slope * decision_value + self.offset))))


@dataclass(frozen=True, slots=True, eq=False)
class AgitationModel:
    """The trained F²SVM; immutable, shared by threads.

    `mean` and `scale` standardise the features; `machines` stand in the order of `Level`.
    """

    mean: FloatArray
    scale: FloatArray
    gamma: float
    machines: tuple[Machine, ...]

    @classmethod
    def load(cls, folder: Path) -> "AgitationModel":
        """Reads `MODEL_FILE` in `folder` after checking it against `CHECKSUM_FILE`.

        Raises ServiceError: `model_unreadable` when a file is missing or is no such model, `model_damaged` when the
        checksum differs.
        """
        path = folder / MODEL_FILE
        try:
            content = path.read_bytes()
            expected = (folder / CHECKSUM_FILE).read_text(encoding="ascii").partition(" ")[0]
        except (OSError, UnicodeDecodeError) as error:
            raise _unreadable(path, error) from None
        if hashlib.sha256(content).hexdigest() != expected:
            raise ServiceError("model_damaged", f"{path} differs from its checksum in {CHECKSUM_FILE}; reinstall it")
        try:
            with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
                return _from_arrays(arrays)
        except (EOFError, KeyError, ValueError, TypeError, zipfile.BadZipFile) as error:
            raise _unreadable(path, error) from None

    def memberships(self, mfcc: FloatArray, energy_db: FloatArray) -> Agitation:
        """How much the utterance belongs to each level.

        `mfcc` has shape (frames, 12) and `energy_db` (frames,), as `app.acoustic.spectrum` makes them.
        """
        return self.judge(voice_features(mfcc, energy_db))

    def judge(self, features: FloatArray) -> Agitation:
        """How much an utterance with these `voice_features` belongs to each level."""
        values = self.decision_values(features)
        raw = [machine.membership(value) for machine, value in zip(self.machines, values, strict=True)]
        return Agitation(**{level.value: share / sum(raw) for level, share in zip(Level, raw, strict=True)})

    def decision_values(self, features: FloatArray) -> tuple[float, ...]:
        """Each machine's decision value, in the order of `Level`."""
        point = (features - self.mean) / self.scale
        return tuple(machine.decision_value(point, self.gamma) for machine in self.machines)


def save(model: AgitationModel, folder: Path) -> None:
    """Writes the model and its checksum into `folder`, as `AgitationModel.load` reads them."""
    arrays: dict[str, FloatArray] = {
        "mean": model.mean,
        "scale": model.scale,
        "gamma": np.array(model.gamma),
    }
    for level, machine in zip(Level, model.machines, strict=True):
        arrays[f"{level}_support_vectors"] = machine.support_vectors
        arrays[f"{level}_coefficients"] = machine.coefficients
        arrays[f"{level}_scalars"] = np.array([machine.intercept, machine.slope, machine.offset])
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **arrays)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / MODEL_FILE).write_bytes(buffer.getvalue())
    checksum = hashlib.sha256(buffer.getvalue()).hexdigest()
    (folder / CHECKSUM_FILE).write_text(f"{checksum}  {MODEL_FILE}\n", encoding="ascii")


def _from_arrays(arrays: Mapping[str, NDArray[np.float64]]) -> AgitationModel:
    machines = []
    for level in Level:
        intercept, slope, offset = arrays[f"{level}_scalars"].tolist()
        vectors, coefficients = arrays[f"{level}_support_vectors"], arrays[f"{level}_coefficients"]
        machines.append(Machine(vectors, coefficients, intercept, slope, offset))
    return AgitationModel(arrays["mean"], arrays["scale"], float(arrays["gamma"]), tuple(machines))


def _unreadable(path: Path, error: Exception) -> ServiceError:
    return ServiceError("model_unreadable", f"{path} is no agitation model ({error}); reinstall understudy")
