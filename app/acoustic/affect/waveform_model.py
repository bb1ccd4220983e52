"""A user's own model of affect: an ONNX file from the waveform to activation, valence and, if it has it, dominance.

It is run as public models of speech emotion are made (wav2vec2, DistilHuBERT and their kin):

- one input of 32-bit floats of shape (1, samples) or (samples,): mono samples at 16 kHz, of mean 0 and variance 1;
- outputs named `activation` (or `arousal`), `valence` and `dominance`, of one number each; or one output of two or
  three numbers, in the order activation, dominance, valence (`audeering`'s) unless the file's metadata has another
  `order`, such as "activation,valence".

The numbers are from -1 to 1, or from 0 to 1 if the metadata's `range` is "0,1", or if the file's one output is without
metadata (`audeering`'s models are so).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...errors import ServiceError
from ...loading import OnnxSession, load_session
from ...model import Affect
from ...model.voice.affect import affect_of_dimensions
from ...model.voice.signal import SpeakerReference
from .affect_model import DIMENSIONS
from .line_affect import Stretch

USUAL_ORDER = ("activation", "dominance", "valence")
_ALSO = {"arousal": "activation"}
_LEAST_DEVIATION = 1e-7
_KIND = "a model of affect"


@dataclass(frozen=True, slots=True, eq=False)
class WaveformModel:
    """A loaded file: the name of its input and whether that has a batch axis, its outputs, the dimensions that they
    give in order, and the lowest and highest number."""

    session: OnnxSession
    samples: str
    batched: bool
    outputs: tuple[str, ...]
    order: tuple[str, ...]
    lowest: float
    highest: float

    @classmethod
    def load(cls, path: Path) -> "WaveformModel":
        """Raises ServiceError `model_unreadable` where the file is missing, no ONNX, or has other inputs or outputs."""
        session = load_session(path, _KIND)
        metadata = session.get_modelmeta().custom_metadata_map
        inputs, outputs = session.get_inputs(), [output.name for output in session.get_outputs()]
        if len(inputs) != 1 or len(inputs[0].shape) not in (1, 2):
            raise _unreadable(path, "it must have one input, of shape (1, samples) or (samples,)")
        named = [name for name in outputs if _ALSO.get(name, name) in DIMENSIONS]
        order = _order(path, outputs, named, metadata)
        lowest, highest = _range(path, named, metadata)
        return cls(
            session, inputs[0].name, len(inputs[0].shape) == 2, tuple(named or outputs[:1]), order, lowest, highest
        )

    def affect_of(self, stretch: Stretch, _reference: SpeakerReference | None = None) -> Affect:
        """The feeling of a stretch; a model of this kind knows nothing of the speaker's usual voice."""
        samples = stretch.audio.samples
        normal = ((samples - samples.mean()) / max(float(samples.std()), _LEAST_DEVIATION)).astype(np.float32)
        found = self.session.run(self.outputs, {self.samples: normal[np.newaxis] if self.batched else normal})
        numbers = np.concatenate([np.ravel(each) for each in found]).astype(np.float64)
        if len(numbers) < len(self.order) or not np.isfinite(numbers[: len(self.order)]).all():
            raise ServiceError("affect_model_failed", f"the affect model gave {len(numbers)} numbers, or none at all")
        scaled = np.clip(2 * (numbers - self.lowest) / (self.highest - self.lowest) - 1, -1, 1)
        values = dict(zip(self.order, scaled.tolist(), strict=False))
        return affect_of_dimensions(*(values.get(dimension, 0.0) for dimension in DIMENSIONS))


def _order(path: Path, outputs: Sequence[str], named: Sequence[str], metadata: Mapping[str, str]) -> tuple[str, ...]:
    """The dimensions in the order of the numbers."""
    told = named or metadata.get("order", ",".join(USUAL_ORDER)).split(",")
    order = tuple(_ALSO.get(name.strip(), name.strip()) for name in told)
    if not outputs or not {"activation", "valence"} <= set(order) <= set(DIMENSIONS):
        raise _unreadable(path, f"it must give activation and valence; it has {', '.join(outputs) or 'nothing'}")
    return order


def _range(path: Path, named: Sequence[str], metadata: Mapping[str, str]) -> tuple[float, float]:
    """The lowest and the highest number."""
    told = metadata.get("range", "-1,1" if named or "order" in metadata else "0,1")
    try:
        lowest, highest = map(float, told.split(","))
    except ValueError:
        raise _unreadable(path, f"its range {told!r} is not a lowest and highest number") from None
    if not lowest < highest:
        raise _unreadable(path, f"its range {told!r} is empty")
    return lowest, highest


def _unreadable(path: Path, reason: str) -> ServiceError:
    return ServiceError("model_unreadable", f"{path} is not {_KIND}: {reason}")
