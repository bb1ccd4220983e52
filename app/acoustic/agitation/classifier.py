"""Classifies the speaker's agitation (low, medium, high) from the voice alone (paper §3.1.4).

A fuzzy-input fuzzy-output support vector machine (F²SVM; Thiel, Scherer & Schwenker 2007) classifies the utterance's
features. Each level has a machine with a radial basis kernel against the other two; the three decision values, scaled
and shifted, become memberships by a softmax. The paper's separate logistic functions, normalized to sum to 1, were less
well calibrated (mean negative log likelihood .58 against .54 on RAVDESS, .48 against .39 on EmoDB, with an earlier set
of 49 features).

A model contains two of them: one for unknown speakers, and one on features relative to the speaker's usual voice. The
more reference recordings of the speaker there are, the more weight the second gets. `training/agitation/` trains them;
evaluation needs numpy only.

On disk a model is `NAME.npz`, named after its feature set (`stored.py`).
"""

import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import InputError
from ...model import Agitation, FloatArray, Level
from ...model.voice.signal import SpeakerReference
from .stored import read_arrays, write_arrays
from .utterance_features import FEATURE_SETS, TypicalSpeaker

TRUST_RECORDINGS = 10
"""With this many reference recordings, both machines have equal weight."""

_MANY = ("support_vectors", "coefficients")
"""Stored in single precision, since they are most of the file."""


def likeness_at(distances: FloatArray, gamma: FloatArray) -> FloatArray:
    """How alike points at these squared distances are, in [0, 1]: the mean of radial basis kernels of widths `gamma`
    (scales,), so that both near and far neighbours have a say."""
    alike: FloatArray = np.mean([np.exp(-each * distances) for each in gamma], axis=0)
    return alike


def squared_distances(points: FloatArray, others: FloatArray) -> FloatArray:
    """Squared Euclidean distances (n, m) between `points` (n, features) and `others` (m, features)."""
    lengths, other_lengths = np.sum(points**2, axis=1), np.sum(others**2, axis=1)
    distances: FloatArray = np.maximum(lengths[:, None] + other_lengths - 2 * points @ others.T, 0.0)
    return distances


@dataclass(frozen=True, slots=True, eq=False)
class FuzzySvm:
    """A trained F²SVM; arrays with one value per class are in the order of `Level`, or of what else it was trained for.

    `mean` and `scale` standardize the features (an infinite scale disables a feature), `gamma` (scales,) are the widths
    of the kernel. The machines share `support_vectors` (n, features), with `coefficients` (n, classes), 0 where a
    vector does not support a machine, and `intercepts` (classes,). `slopes` and `offsets` (classes,) calibrate
    the decision values.
    """

    mean: FloatArray
    scale: FloatArray
    gamma: FloatArray
    support_vectors: FloatArray
    coefficients: FloatArray
    intercepts: FloatArray
    slopes: FloatArray
    offsets: FloatArray
    _squared_lengths: FloatArray = field(init=False, repr=False)

    def __post_init__(self) -> None:
        squared_lengths = np.sum(np.square(self.support_vectors), axis=1)
        object.__setattr__(self, "_squared_lengths", squared_lengths)

    def decision_values(self, features: FloatArray) -> FloatArray:
        """The decision value of each machine (classes,), positive on its class's side."""
        return self._decided(self.likeness(features))

    def likeness(self, features: FloatArray) -> FloatArray:
        """The value of the kernel with each support vector (n,), in [0, 1]."""
        point = (features - self.mean) / self.scale
        products = self.support_vectors @ point
        return likeness_at(np.maximum(point @ point + self._squared_lengths - 2.0 * products, 0.0), self.gamma)

    def memberships(self, features: FloatArray) -> FloatArray:
        """The memberships in the order of the classes, which sum to 1."""
        return self.memberships_at(self.likeness(features))

    def memberships_at(self, likeness: FloatArray) -> FloatArray:
        """The memberships of an utterance that is so like the support vectors (n,)."""
        evidence = self.slopes * self._decided(likeness) + self.offsets
        shares = np.exp(evidence - evidence.max())
        memberships: FloatArray = shares / shares.sum()
        return memberships

    def _decided(self, likeness: FloatArray) -> FloatArray:
        values: FloatArray = likeness @ self.coefficients + self.intercepts
        return values


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
        return read_arrays(
            _path(folder, feature_set), "agitation model", lambda arrays: _from_arrays(feature_set, arrays)
        )

    @classmethod
    def load_file(cls, path: Path) -> "AgitationModel":
        """Loads a model that `understudy agitation train` wrote; raises InputError `agitation_model`."""
        try:
            if not zipfile.is_zipfile(content := io.BytesIO(path.read_bytes())):
                raise _no_model(path, "no .npz file")
            with np.load(content, allow_pickle=False) as arrays:
                feature_set = str(arrays["feature_set"])
                model = _from_arrays(feature_set, arrays)
        except OSError as error:
            raise _no_model(path, error.strerror) from None
        except (EOFError, KeyError, ValueError, TypeError, zipfile.BadZipFile) as error:
            raise _no_model(path, error) from None
        if feature_set not in FEATURE_SETS or len(model.typical.mean) != model.unknown_speaker.support_vectors.shape[1]:
            raise _no_model(path, f"features {feature_set!r}")
        return model

    def agitation(self, features: FloatArray, reference: SpeakerReference | None = None) -> Agitation:
        """The memberships of an utterance with these `full_features`, optionally relative to the speaker's reference.

        Raises InputError `reference_other_features`.
        """
        return self.judge(self.describe(features), reference)

    def describe(self, features: FloatArray) -> FloatArray:
        """Those of `full_features` that the model knows; undefined ones, such as pitch in a whisper, are set to the
        average."""
        return self.typical.completed(features[: FEATURE_SETS[self.feature_set]])

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
                f"needs {len(self.typical.mean)} {self.feature_set!r}; recreate it with understudy reference",
                field="reference",
            )


def save(model: AgitationModel, folder: Path) -> Path:
    """Write the model and its checksum to `folder` for `AgitationModel.load`; returns the model's path."""
    path = _path(folder, model.feature_set)
    write_arrays(path, _arrays(model))
    return path


def _arrays(model: AgitationModel) -> dict[str, NDArray[Any]]:
    arrays: dict[str, NDArray[Any]] = {"mean": model.typical.mean, "deviation": model.typical.deviation}
    return arrays | svm_arrays("unknown", model.unknown_speaker) | svm_arrays("known", model.known_speaker)


def save_file(model: AgitationModel, path: Path) -> None:
    """Writes the model as one file for `AgitationModel.load_file`: numpy's .npz, without pickles."""
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, feature_set=np.array(model.feature_set), **_arrays(model))
    path.write_bytes(buffer.getvalue())


def _no_model(path: Path, why: object) -> InputError:
    message = (
        f"{path} is not an agitation model ({why}); make one with understudy agitation train LABELS.csv -o MODEL.npz"
    )
    return InputError("agitation_model", message, field="agitation_model")


def _path(folder: Path, feature_set: str) -> Path:
    return folder / f"{feature_set}.npz"


_STORED = frozenset(part.name for part in fields(FuzzySvm) if part.init)


def svm_arrays(name: str, svm: FuzzySvm) -> dict[str, NDArray[Any]]:
    """The machine as arrays whose names begin with `name`."""
    arrays = {f"{name}_{part}": np.asarray(getattr(svm, part)) for part in _STORED}
    return arrays | {f"{name}_{part}": arrays[f"{name}_{part}"].astype(np.float32) for part in _MANY}


def _from_arrays(feature_set: str, arrays: Mapping[str, NDArray[Any]]) -> AgitationModel:
    typical = TypicalSpeaker(arrays["mean"], arrays["deviation"])
    return AgitationModel(feature_set, typical, svm_of("unknown", arrays), svm_of("known", arrays))


def svm_of(name: str, arrays: Mapping[str, NDArray[Any]]) -> FuzzySvm:
    """The machine in the arrays whose names begin with `name`."""
    parts: dict[str, Any] = {part: arrays[f"{name}_{part}"].astype(np.float64) for part in _STORED}
    parts["gamma"] = np.atleast_1d(parts["gamma"])
    return FuzzySvm(**parts)
