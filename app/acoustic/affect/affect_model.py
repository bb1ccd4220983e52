"""Tells the feeling of a voice from the features of an utterance: the shares of seven tones, activation, valence and
dominance.

Actors, languages and rooms differ in how a feeling sounds, so the model is a mixture of experts: each was trained on
one corpus, and a gate tells how much an utterance is like the recordings of each (Jacobs et al. 1991, "Adaptive
mixtures of local experts"). An expert is a kernel machine against every tone (`FuzzySvm`), once for unknown speakers
and once on features relative to the speaker's usual voice; the more reference recordings there are, the more weight the
second gets. What is unlike all that was trained on is taken for neutral as far as it is unlike.

On disk a model is `NAME.npz` (no pickles) with `NAME.npz.sha256` beside it. `training/affect` trains it; evaluation
needs numpy only.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import InputError
from ...model import NEUTRAL, Affect, FloatArray, Tone, mean_affect
from ...model.voice.signal import SpeakerReference
from ..agitation.classifier import TRUST_RECORDINGS, FuzzySvm, svm_arrays, svm_of
from ..agitation.stored import read_arrays, write_arrays
from ..agitation.utterance_features import TypicalSpeaker

FEATURE_SET = "full"
"""The features of `FEATURE_SETS` from which affect is predicted."""

DIMENSIONS = ("activation", "valence", "dominance")


@dataclass(frozen=True, slots=True, eq=False)
class KernelMachines:
    """Machines that share support vectors: `tones` decides between the expert's tones, `coefficients` (n, 3) and
    `intercepts` (3,) give activation, valence and dominance."""

    tones: FuzzySvm
    coefficients: FloatArray
    intercepts: FloatArray

    def hear(self, features: FloatArray) -> tuple[FloatArray, FloatArray]:
        """The shares of the tones, and activation, valence and dominance, in [-1, 1]."""
        likeness = self.tones.likeness(features)
        dimensions = np.clip(likeness @ self.coefficients + self.intercepts, -1.0, 1.0)
        return self.tones.memberships_at(likeness), dimensions


@dataclass(frozen=True, slots=True, eq=False)
class Expert:
    """What one corpus teaches: `tones` are those that it has."""

    corpus: str
    tones: tuple[Tone, ...]
    unknown_speaker: KernelMachines
    known_speaker: KernelMachines

    def affect(self, machines: KernelMachines, features: FloatArray) -> Affect:
        """The feeling that one of its machines hears."""
        memberships, dimensions = machines.hear(features)
        shares = dict(zip(self.tones, memberships.tolist(), strict=True))
        activation, valence, dominance = dimensions.tolist()
        return Affect(activation, valence, dominance, tuple(shares.get(tone, 0.0) for tone in Tone))


@dataclass(frozen=True, slots=True, eq=False)
class Gate:
    """How much an utterance is like the recordings of each expert: a softmax of `weights` (features, experts) and
    `bias` (experts,) over standardized features."""

    mean: FloatArray
    scale: FloatArray
    weights: FloatArray
    bias: FloatArray

    def shares(self, features: FloatArray) -> FloatArray:
        """The share of each expert; they sum to 1."""
        evidence = (features - self.mean) / self.scale @ self.weights + self.bias
        shares = np.exp(evidence - evidence.max())
        normalized: FloatArray = shares / shares.sum()
        return normalized


@dataclass(frozen=True, slots=True, eq=False)
class AffectModel:
    """A model of affect; immutable and thread-safe. `familiar` is the mean squared distance of standardized features up
    to which an utterance is like what was trained on."""

    typical: TypicalSpeaker
    gate: Gate
    experts: tuple[Expert, ...]
    familiar: float

    @classmethod
    def load(cls, path: Path) -> "AffectModel":
        """Raises ServiceError `model_unreadable` and `model_damaged`, as the agitation models do."""
        return read_arrays(path, "affect model", _from_arrays)

    def save(self, path: Path) -> None:
        """Writes the model and its checksum for `load`."""
        arrays: dict[str, NDArray[Any]] = {
            "mean": self.typical.mean,
            "deviation": self.typical.deviation,
            "familiar": np.asarray(self.familiar),
            "experts": np.array([expert.corpus for expert in self.experts]),
        }
        arrays |= {f"gate_{name}": getattr(self.gate, name) for name in _GATE}
        for expert in self.experts:
            arrays |= dict(_expert_arrays(expert))
        write_arrays(path, arrays)

    def affect(self, features: FloatArray, reference: SpeakerReference | None = None) -> Affect:
        """The feeling for the utterance's features (`FEATURE_SET`, NaN where unknown), relative to the speaker's
        reference if there is one.

        Raises InputError `reference_other_features`.
        """
        features = self.typical.completed(features)
        heard = self._heard(features)
        if reference is not None and self._fits(reference):
            relative = self.typical.relative(features, reference)
            trust = reference.recordings / (reference.recordings + TRUST_RECORDINGS)
            shares = self.gate.shares(features)
            known = mean_affect([each.affect(each.known_speaker, relative) for each in self.experts], shares.tolist())
            heard = mean_affect([heard, known], [1 - trust, trust])
        strangeness = self._strangeness(features)
        return mean_affect([heard, NEUTRAL], [1 - strangeness, strangeness])

    def _heard(self, features: FloatArray) -> Affect:
        shares = self.gate.shares(features)
        heard = [expert.affect(expert.unknown_speaker, features) for expert in self.experts]
        return mean_affect(heard, shares.tolist())

    def _strangeness(self, features: FloatArray) -> float:
        """How far the features are from all that was trained on: 0 within `familiar`, 1 from twice that on."""
        distance = float(np.mean(((features - self.gate.mean) / self.gate.scale) ** 2))
        return min(max(distance / self.familiar - 1.0, 0.0), 1.0)

    def _fits(self, reference: SpeakerReference) -> bool:
        """Whether the reference is of these features; one of the paper's 12 is for the agitation alone."""
        if reference.feature_set != FEATURE_SET:
            return False
        if len(reference.mean) != len(self.typical.mean):
            message = f"the speaker's reference holds {len(reference.mean)} features, not {len(self.typical.mean)}"
            raise InputError(
                "reference_other_features", f"{message}; recreate it with understudy reference", field="reference"
            )
        return True


_GATE = ("mean", "scale", "weights", "bias")


def _expert_arrays(expert: Expert) -> Iterator[tuple[str, NDArray[Any]]]:
    yield f"{expert.corpus}_tones", np.array([tone.value for tone in expert.tones])
    for kind in ("unknown", "known"):
        machines: KernelMachines = getattr(expert, f"{kind}_speaker")
        yield from svm_arrays(f"{expert.corpus}_{kind}", machines.tones).items()
        yield f"{expert.corpus}_{kind}_dimensions", machines.coefficients.astype(np.float32)
        yield f"{expert.corpus}_{kind}_origin", machines.intercepts


def _from_arrays(arrays: Mapping[str, NDArray[Any]]) -> AffectModel:
    return AffectModel(
        typical=TypicalSpeaker(arrays["mean"], arrays["deviation"]),
        gate=Gate(*(arrays[f"gate_{name}"] for name in _GATE)),
        experts=tuple(_expert(corpus, arrays) for corpus in arrays["experts"].tolist()),
        familiar=float(arrays["familiar"]),
    )


def _expert(corpus: str, arrays: Mapping[str, NDArray[Any]]) -> Expert:
    unknown, known = (
        KernelMachines(
            tones=svm_of(f"{corpus}_{kind}", arrays),
            coefficients=arrays[f"{corpus}_{kind}_dimensions"].astype(np.float64),
            intercepts=arrays[f"{corpus}_{kind}_origin"],
        )
        for kind in ("unknown", "known")
    )
    return Expert(corpus, tuple(map(Tone, arrays[f"{corpus}_tones"].tolist())), unknown, known)
