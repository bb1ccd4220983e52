"""The voice-driven gesture model: one semi-Markov model over discriminants of the prosody for each of hands, head and
brows, in one .npz file without pickles.

Viterbi decoding of a complete recording (RTS §2.3, AHG §3.6).
"""

import io
import zipfile
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Self

import numpy as np

from ..errors import InputError, ServiceError
from ..files import replace_file
from ..model import FloatArray
from .prosody import WIDTH, features, in_context, raw_frames
from .semi_markov import MixtureEmissions, Segment, SemiMarkovModel
from .trellis import EVERYTHING, Search, Trellis

LONGEST_S = 5.0
"""D_max of AHG; RTS has 10 s."""

LONGEST_FRAMES = 200

_DISCRIMINANTS = ("mean", "scale", "weights")
_EMISSIONS = ("log_weights", "means", "variances")
_MODEL = ("log_initial", "log_transition", "log_duration")


@dataclass(frozen=True, slots=True, eq=False)
class Discriminants:
    """`mean` and `scale` (features) standardise, `weights` (features × directions) project."""

    mean: FloatArray
    scale: FloatArray
    weights: FloatArray

    def project(self, rows: FloatArray) -> FloatArray:
        """The projections (… × directions) of rows (… × features)."""
        projected: FloatArray = (rows - self.mean) / self.scale @ self.weights
        return projected


@dataclass(frozen=True, slots=True, eq=False)
class PartModel:
    """The model of a part of the body ("hands", "head", "brows"): the emissions and sequence of its states."""

    part: str
    discriminants: Discriminants
    model: SemiMarkovModel

    def log_likelihoods(self, rows: FloatArray) -> FloatArray:
        """The log likelihoods (frames × states) of prosody with context (frames × `WIDTH`)."""
        return self.model.emissions.log_likelihoods(self.discriminants.project(rows))


@dataclass(frozen=True, slots=True, eq=False)
class VoiceModel:
    """The parts of the body, in the order of the file."""

    parts: tuple[PartModel, ...]

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises ServiceError `model_unreadable`."""
        try:
            with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as arrays:
                return cls(tuple(_read(dict(arrays), str(part)) for part in arrays["parts"]))
        except (OSError, KeyError, ValueError, EOFError, zipfile.BadZipFile) as error:
            raise ServiceError(
                "model_unreadable", f"{path} is not a model of gestures from the voice: {error}"
            ) from None

    def save(self, path: Path) -> None:
        """Writes the file whole."""
        arrays = {f"{part.part}/{name}": array for part in self.parts for name, array in _arrays(part).items()}
        arrays["parts"] = np.array([part.part for part in self.parts])
        content = io.BytesIO()
        np.savez_compressed(content, **arrays)  # type: ignore[arg-type]
        replace_file(path, content.getvalue())

    def decode(
        self, energy_db: FloatArray, f0_hz: FloatArray, search: Search = EVERYTHING
    ) -> dict[str, tuple[Segment, ...]]:
        """The most likely path of each part through a complete recording, from its contours (one row each .01 s)."""
        rows = in_context(features(raw_frames(energy_db, f0_hz)))
        return {part.part: decode(part.model, part.log_likelihoods(rows), search) for part in self.parts}


def _arrays(part: PartModel) -> dict[str, FloatArray]:
    emissions = part.model.emissions
    assert isinstance(emissions, MixtureEmissions), "shipped models observe features"
    held = ((part.discriminants, _DISCRIMINANTS), (emissions, _EMISSIONS), (part.model, _MODEL))
    arrays = {name: getattr(holder, name).astype(np.float32) for holder, names in held for name in names}
    return arrays | {"states": np.array(part.model.states)}


def _read(arrays: dict[str, FloatArray], part: str) -> PartModel:
    mean, scale, weights = (arrays[f"{part}/{name}"].astype(np.float64) for name in _DISCRIMINANTS)
    if len(mean) != WIDTH:
        raise ValueError(f"it observes {len(mean)} numbers of {part}, not {WIDTH}: retrain it")
    emissions = MixtureEmissions(*(arrays[f"{part}/{name}"].astype(np.float64) for name in _EMISSIONS))
    initial, transition, duration = (arrays[f"{part}/{name}"].astype(np.float64) for name in _MODEL)
    states = tuple(str(state) for state in arrays[f"{part}/states"])
    return PartModel(
        part,
        Discriminants(mean, scale, weights),
        SemiMarkovModel(states, initial, transition, duration, emissions),
    )


def decode(model: SemiMarkovModel, log_likelihoods: FloatArray, search: Search = EVERYTHING) -> tuple[Segment, ...]:
    """The most likely segments for `log_likelihoods` (frames × states); the last ends with the recording, as printed.

    With `EVERYTHING` the search is exact. Raises InputError `undecodable` if no path is possible.
    """
    if not len(log_likelihoods):
        return ()
    trellis = Trellis(model, search, capacity=len(log_likelihoods))
    for frame in log_likelihoods:
        trellis.push(frame)
    score, state = trellis.closed()
    if not isfinite(score):
        raise InputError("undecodable", f"no path of the model fits these {len(log_likelihoods)} frames")
    last = trellis.last_segment(state)
    return (*trellis.back_to(0, last.start, last.state), last)
