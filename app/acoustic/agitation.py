"""The speaker's agitation, low, medium or high, from the voice alone (paper §3.1.4).

A fuzzy-input fuzzy-output support vector machine (F²SVM; Thiel, Scherer & Schwenker 2007) judges the utterance's
features. One machine with a radial basis kernel stands for each level against the other two; the three decision values,
each scaled and shifted, become memberships through one logistic function of all three (softmax). The paper's separate
logistic functions, scaled to sum to 1, are less well calibrated (`python -m benchmarks.agitation --ablation`).

A model holds two of them: one for voices never heard, and one that sees how far the utterance is from how its speaker
usually sounds. The more recordings of the speaker there are, the more the second is trusted. `training/agitation/`
trains them; here they are evaluated with numpy alone.

On disk a model is `NAME.npz` (no pickles), named after its feature set, and beside it `NAME.npz.sha256`, as `sha256sum`
writes it.
"""

import hashlib
import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.acoustic.speaker import SpeakerReference, TypicalSpeaker
from app.acoustic.utterance_features import FEATURE_SETS
from app.errors import InputError, ServiceError
from app.model import Agitation, Audio, Contours, FloatArray, Level

TRUST_RECORDINGS = 10
"""With this many recordings of the speaker, both machines have the same say."""


@dataclass(frozen=True, slots=True, eq=False)
class Machine:
    """One level against the rest, and how its decision value is scaled and shifted among the three."""

    support_vectors: FloatArray
    coefficients: FloatArray
    intercept: float
    slope: float
    offset: float

    def decision_value(self, point: FloatArray, gamma: float) -> float:
        """Distance from the decision surface in the kernel's space, positive on the level's side."""
        squared_distances = np.sum((self.support_vectors - point) ** 2, axis=1)
        return float(self.coefficients @ np.exp(-gamma * squared_distances) + self.intercept)


@dataclass(frozen=True, slots=True, eq=False)
class FuzzySvm:
    """A trained F²SVM: `mean` and `scale` standardise what it sees; `machines` stand in the order of `Level`."""

    mean: FloatArray
    scale: FloatArray
    gamma: float
    machines: tuple[Machine, ...]

    def decision_values(self, features: FloatArray) -> FloatArray:
        """Each machine's decision value, in the order of `Level`."""
        point = (features - self.mean) / self.scale
        return np.array([machine.decision_value(point, self.gamma) for machine in self.machines])

    def memberships(self, features: FloatArray) -> FloatArray:
        """The memberships in the order of `Level`, summing to 1."""
        values = self.decision_values(features)
        evidence = np.array([m.slope * value + m.offset for m, value in zip(self.machines, values, strict=True)])
        shares = np.exp(evidence - evidence.max())
        memberships: FloatArray = shares / shares.sum()
        return memberships


@dataclass(frozen=True, slots=True, eq=False)
class AgitationModel:
    """What judges agitation; immutable, shared by threads. `feature_set` is a key of `FEATURE_SETS`."""

    feature_set: str
    typical: TypicalSpeaker
    unknown_speaker: FuzzySvm
    known_speaker: FuzzySvm

    @classmethod
    def load(cls, folder: Path, feature_set: str) -> "AgitationModel":
        """Reads the model in `folder` after checking it against its checksum.

        Raises ServiceError: `model_unreadable` when a file is missing or is no such model, `model_damaged` when the
        checksum differs.
        """
        path, checksum = _paths(folder, feature_set)
        try:
            content = path.read_bytes()
            expected = checksum.read_text(encoding="ascii").partition(" ")[0]
        except (OSError, UnicodeDecodeError) as error:
            raise _unreadable(path, error) from None
        if hashlib.sha256(content).hexdigest() != expected:
            raise ServiceError("model_damaged", f"{path} differs from its checksum in {checksum.name}; reinstall it")
        try:
            with np.load(io.BytesIO(content), allow_pickle=False) as arrays:
                return _from_arrays(feature_set, arrays)
        except (EOFError, KeyError, ValueError, TypeError, zipfile.BadZipFile) as error:
            raise _unreadable(path, error) from None

    def agitation(self, audio: Audio, contours: Contours, reference: SpeakerReference | None = None) -> Agitation:
        """How much the utterance belongs to each level, for a speaker who usually sounds as `reference` says.

        Raises InputError `reference_other_features`.
        """
        return self.judge(self.describe(audio, contours), reference)

    def describe(self, audio: Audio, contours: Contours) -> FloatArray:
        """The features of the utterance, shape (features,); what cannot be told, as pitch in a whisper, is average."""
        return self.typical.completed(FEATURE_SETS[self.feature_set](audio, contours))

    def judge(self, features: FloatArray, reference: SpeakerReference | None = None) -> Agitation:
        """How much an utterance with these features belongs to each level; raises as `agitation` does."""
        memberships = self.unknown_speaker.memberships(features)
        if reference is not None:
            self._require_same_features(reference)
            relative = self.known_speaker.memberships(self.typical.relative(features, reference))
            trust = reference.recordings / (reference.recordings + TRUST_RECORDINGS)
            memberships = (1 - trust) * memberships + trust * relative
        return Agitation(**{level.value: float(share) for level, share in zip(Level, memberships, strict=True)})

    def _require_same_features(self, reference: SpeakerReference) -> None:
        if (reference.feature_set, len(reference.mean)) != (self.feature_set, len(self.typical.mean)):
            raise InputError(
                "reference_other_features",
                f"the speaker's reference holds {len(reference.mean)} {reference.feature_set!r} features, the model "
                f"needs {len(self.typical.mean)} {self.feature_set!r}; make it anew with understudy reference",
                field="reference",
            )


def save(model: AgitationModel, folder: Path) -> Path:
    """Writes the model and its checksum into `folder`, as `AgitationModel.load` reads them; the model's path."""
    arrays: dict[str, FloatArray] = {"mean": model.typical.mean, "deviation": model.typical.deviation}
    arrays |= _to_arrays("unknown", model.unknown_speaker) | _to_arrays("known", model.known_speaker)
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **arrays)
    folder.mkdir(parents=True, exist_ok=True)
    path, checksum = _paths(folder, model.feature_set)
    path.write_bytes(buffer.getvalue())
    checksum.write_text(f"{hashlib.sha256(buffer.getvalue()).hexdigest()}  {path.name}\n", encoding="ascii")
    return path


def _paths(folder: Path, feature_set: str) -> tuple[Path, Path]:
    return folder / f"{feature_set}.npz", folder / f"{feature_set}.npz.sha256"


def _to_arrays(name: str, svm: FuzzySvm) -> dict[str, FloatArray]:
    arrays = {f"{name}_mean": svm.mean, f"{name}_scale": svm.scale, f"{name}_gamma": np.array(svm.gamma)}
    for level, machine in zip(Level, svm.machines, strict=True):
        arrays[f"{name}_{level}_support_vectors"] = machine.support_vectors
        arrays[f"{name}_{level}_coefficients"] = machine.coefficients
        arrays[f"{name}_{level}_scalars"] = np.array([machine.intercept, machine.slope, machine.offset])
    return arrays


def _from_arrays(feature_set: str, arrays: Mapping[str, NDArray[np.float64]]) -> AgitationModel:
    typical = TypicalSpeaker(arrays["mean"], arrays["deviation"])
    return AgitationModel(feature_set, typical, _svm("unknown", arrays), _svm("known", arrays))


def _svm(name: str, arrays: Mapping[str, NDArray[np.float64]]) -> FuzzySvm:
    machines = []
    for level in Level:
        intercept, slope, offset = arrays[f"{name}_{level}_scalars"].tolist()
        vectors, coefficients = arrays[f"{name}_{level}_support_vectors"], arrays[f"{name}_{level}_coefficients"]
        machines.append(Machine(vectors, coefficients, intercept, slope, offset))
    return FuzzySvm(arrays[f"{name}_mean"], arrays[f"{name}_scale"], float(arrays[f"{name}_gamma"]), tuple(machines))


def _unreadable(path: Path, error: Exception) -> ServiceError:
    return ServiceError("model_unreadable", f"{path} is no agitation model ({error}); reinstall understudy")
