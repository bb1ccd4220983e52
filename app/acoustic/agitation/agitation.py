"""Classifies the speaker's agitation (low, medium, high) from the voice alone (paper §3.1.4).

A fuzzy-input fuzzy-output support vector machine (F²SVM; Thiel, Scherer & Schwenker 2007) classifies the utterance's
features. Each level has a machine with a radial basis kernel against the other two; the three decision values, scaled
and shifted, become memberships by a softmax. The paper's separate logistic functions, normalized to sum to 1, were less
well calibrated (mean negative log likelihood .58 against .54 on RAVDESS, .48 against .39 on EmoDB, with an earlier set
of 49 features).

A model contains two of them: one for unknown speakers, and one on features relative to the speaker's usual voice. The
more reference recordings of the speaker there are, the more weight the second gets. `training/agitation/` trains them;
evaluation needs numpy only.

On disk a model is `NAME.npz` (no pickles), named after its feature set, with `NAME.npz.sha256` beside it, in the format
of `sha256sum`.
"""

import hashlib
import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import InputError, ServiceError
from ...model import Agitation, Audio, Contours, FloatArray, Level
from .speaker import SpeakerReference, TypicalSpeaker
from .utterance_features import FEATURE_SETS

TRUST_RECORDINGS = 10
"""With this many reference recordings, both machines have equal weight."""

_MANY = ("support_vectors", "coefficients")
"""Stored in single precision, since they are most of the file."""


def squared_distances(points: FloatArray, others: FloatArray) -> FloatArray:
    """Squared Euclidean distances (n, m) between `points` (n, features) and `others` (m, features)."""
    lengths, other_lengths = np.sum(points**2, axis=1), np.sum(others**2, axis=1)
    distances: FloatArray = np.maximum(lengths[:, None] + other_lengths - 2 * points @ others.T, 0.0)
    return distances


@dataclass(frozen=True, slots=True, eq=False)
class FuzzySvm:
    """A trained F²SVM; arrays with one value per level are in the order of `Level`.

    `mean` and `scale` standardize the features (an infinite scale disables a feature). The machines share
    `support_vectors` (n, features), with `coefficients` (n, 3), 0 where a vector does not support a machine, and
    `intercepts` (3,). `slopes` and `offsets` (3,) calibrate the decision values.
    """

    mean: FloatArray
    scale: FloatArray
    gamma: float
    support_vectors: FloatArray
    coefficients: FloatArray
    intercepts: FloatArray
    slopes: FloatArray
    offsets: FloatArray

    def decision_values(self, features: FloatArray) -> FloatArray:
        """The decision value of each machine (3,), positive on its level's side."""
        point = (features - self.mean) / self.scale
        likeness = np.exp(-self.gamma * squared_distances(point[np.newaxis], self.support_vectors)[0])
        values: FloatArray = likeness @ self.coefficients + self.intercepts
        return values

    def memberships(self, features: FloatArray) -> FloatArray:
        """The memberships in the order of `Level`, which sum to 1."""
        evidence = self.slopes * self.decision_values(features) + self.offsets
        shares = np.exp(evidence - evidence.max())
        memberships: FloatArray = shares / shares.sum()
        return memberships


@dataclass(frozen=True, slots=True, eq=False)
class AgitationModel:
    """An agitation classifier; immutable and thread-safe. `feature_set` is a key of `FEATURE_SETS`."""

    feature_set: str
    typical: TypicalSpeaker
    unknown_speaker: FuzzySvm
    known_speaker: FuzzySvm

    @classmethod
    def load(cls, folder: Path, feature_set: str) -> "AgitationModel":
        """Load the model in `folder` and verify its checksum.

        Raises ServiceError: `model_unreadable` if a file is missing or not such a model, `model_damaged` if the
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
        """The memberships of an utterance, optionally relative to the speaker's reference.

        Raises InputError `reference_other_features`.
        """
        return self.judge(self.describe(audio, contours), reference)

    def describe(self, audio: Audio, contours: Contours) -> FloatArray:
        """The features of the utterance (features,); undefined ones, such as pitch in a whisper, are set to the
        average."""
        return self.typical.completed(FEATURE_SETS[self.feature_set](audio, contours))

    def judge(self, features: FloatArray, reference: SpeakerReference | None = None) -> Agitation:
        """The memberships for these features; raises as `agitation` does."""
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
    """Write the model and its checksum to `folder` for `AgitationModel.load`; returns the model's path."""
    arrays: dict[str, NDArray[Any]] = {"mean": model.typical.mean, "deviation": model.typical.deviation}
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


def _to_arrays(name: str, svm: FuzzySvm) -> dict[str, NDArray[Any]]:
    arrays = {f"{name}_{part.name}": np.asarray(getattr(svm, part.name)) for part in fields(svm)}
    return arrays | {f"{name}_{part}": arrays[f"{name}_{part}"].astype(np.float32) for part in _MANY}


def _from_arrays(feature_set: str, arrays: Mapping[str, NDArray[Any]]) -> AgitationModel:
    typical = TypicalSpeaker(arrays["mean"], arrays["deviation"])
    return AgitationModel(feature_set, typical, _svm("unknown", arrays), _svm("known", arrays))


def _svm(name: str, arrays: Mapping[str, NDArray[Any]]) -> FuzzySvm:
    parts: dict[str, Any] = {part.name: arrays[f"{name}_{part.name}"].astype(np.float64) for part in fields(FuzzySvm)}
    parts["gamma"] = float(parts["gamma"])
    return FuzzySvm(**parts)


def _unreadable(path: Path, error: Exception) -> ServiceError:
    return ServiceError("model_unreadable", f"{path} is no agitation model ({error}); reinstall understudy")
