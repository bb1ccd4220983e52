"""A user's own model of affect: an ONNX file from the waveform to activation, valence and, if it has it, dominance.

It is run as public models of speech emotion are made (wav2vec2, DistilHuBERT and their kin):

- one input of 32-bit floats of shape (1, samples) or (samples,): mono samples at 16 kHz, of mean 0 and variance 1;
- outputs named `activation` (or `arousal`), `valence` and `dominance`, of one number each; or one output of three
  numbers, in the order activation, dominance, valence (`audeering`'s), or of as many as the file's metadata has in
  another `order`, such as "activation,valence". Other outputs, such as the hidden states of `audeering`'s models, are
  ignored.

The numbers are from -1 to 1, or from 0 to 1 if the metadata's `range` is "0,1", or if the file's one output is without
metadata (`audeering`'s models are so).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import ServiceError
from ...loading import OnnxSession, load_session
from ...model import SAMPLE_RATE_HZ, Affect, FloatArray
from ...model.voice.affect import affect_of_dimensions
from ...model.voice.signal import SpeakerReference
from .affect_model import DIMENSIONS
from .line_affect import Stretch

USUAL_ORDER = ("activation", "dominance", "valence")
_ALSO = {"arousal": "activation"}
_LEAST_DEVIATION = 1e-7
_KIND = "a model of affect"
_Shapes = Mapping[str, Sequence[int | str | None]]
"""The shape of each output, by name; an axis of variable length is a text, or None."""


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
        samples = _input(path, session)
        shapes = {output.name: output.shape for output in session.get_outputs()}
        named = tuple(name for name in shapes if _ALSO.get(name, name) in DIMENSIONS)
        order = _order(path, named or metadata.get("order", ",".join(USUAL_ORDER)).split(","), shapes)
        outputs = named or (_only_output(path, shapes, len(order)),)
        lowest, highest = _range(path, named, metadata)
        return cls(session, samples.name, len(samples.shape) == 2, outputs, order, lowest, highest)

    def affect_of(self, stretch: Stretch, _reference: SpeakerReference | None = None) -> Affect:
        """The feeling of a stretch; a model of this kind knows nothing of the speaker's usual voice."""
        samples = stretch.audio.samples
        normal = ((samples - samples.mean()) / max(float(samples.std()), _LEAST_DEVIATION)).astype(np.float32)
        numbers = self._numbers(normal[np.newaxis] if self.batched else normal)
        scaled = np.clip(2 * (numbers - self.lowest) / (self.highest - self.lowest) - 1, -1, 1)
        values = dict(zip(self.order, scaled.tolist(), strict=True))
        return affect_of_dimensions(*(values.get(dimension, 0.0) for dimension in DIMENSIONS))

    def _numbers(self, samples: FloatArray) -> FloatArray:
        """What the model makes of the samples, a number for each dimension of `order`."""
        from onnxruntime.capi import onnxruntime_pybind11_state as state

        try:
            found = self.session.run(self.outputs, {self.samples: samples})
        except (state.Fail, state.InvalidArgument, state.RuntimeException) as error:
            message = f"the affect model cannot run on {samples.size / SAMPLE_RATE_HZ:.2f} s of sound: {error}"
            raise ServiceError("affect_model_failed", message) from error
        numbers = np.concatenate([np.ravel(each) for each in found]).astype(np.float64)
        if len(numbers) != len(self.order) or not np.isfinite(numbers).all():
            given = f"{len(numbers)} numbers" if np.isfinite(numbers).all() else "numbers that are not finite"
            wanted = f"{len(self.order)} ({', '.join(self.order)})"
            raise ServiceError("affect_model_failed", f"the affect model gave {given}; it must give {wanted}")
        return numbers


def _input(path: Path, session: OnnxSession) -> Any:  # noqa: ANN401
    """The one input, if it takes any number of samples."""
    inputs = session.get_inputs()
    if len(inputs) != 1 or len(inputs[0].shape) not in (1, 2):
        raise _unreadable(path, "it must have one input, of shape (1, samples) or (samples,)")
    if inputs[0].type != "tensor(float)" or isinstance(inputs[0].shape[-1], int):
        has = f"it has {inputs[0].type} of shape {inputs[0].shape}"
        raise _unreadable(path, f"its input must be of 32-bit floats and take any number of samples; {has}")
    return inputs[0]


def _order(path: Path, told: Sequence[str], shapes: _Shapes) -> tuple[str, ...]:
    """The dimensions in the order of the numbers."""
    order = tuple(_ALSO.get(name.strip(), name.strip()) for name in told)
    if not {"activation", "valence"} <= set(order) <= set(DIMENSIONS):
        raise _unreadable(path, f"it must give activation and valence; it has {', '.join(shapes) or 'nothing'}")
    return order


def _only_output(path: Path, shapes: _Shapes, count: int) -> str:
    """The output that has the numbers, where none is named after a dimension: the one of `count` numbers."""
    fitting = [name for name, shape in shapes.items() if shape and shape[-1] == count]
    if not fitting and len(shapes) == 1:
        fitting = [name for name, shape in shapes.items() if not shape or not isinstance(shape[-1], int)]
    if len(fitting) != 1:
        has = ", ".join(f"{name} of shape {shape}" for name, shape in shapes.items()) or "none"
        wanted = f"outputs named activation and valence, or one output of {count} numbers"
        raise _unreadable(path, f"it must have {wanted}, or say in its metadata's `order` which they are; it has {has}")
    return fitting[0]


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
