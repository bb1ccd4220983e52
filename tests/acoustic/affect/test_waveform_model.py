"""A user's own model in ONNX: which inputs and outputs are understood, and what is refused."""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from tests.support.onnx_files import constant_plus_mean
from tests.support.words.measured import stretch_of
from understudy.acoustic.affect.line_affect import Stretch
from understudy.acoustic.affect.waveform_model import WaveformModel
from understudy.errors import ServiceError
from understudy.model import SAMPLE_RATE_HZ, Audio, Tone


@cache
def voice() -> Stretch:
    return stretch_of(Audio(np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE_HZ) * np.hanning(SAMPLE_RATE_HZ)))


def model_file(
    folder: Path,
    outputs: Mapping[str, Sequence[float]],
    *,
    shape: Sequence[str | int] = (1, "samples"),
    metadata: Mapping[str, str] | None = None,
) -> Path:
    """A model whose outputs are these numbers, each plus the mean of the samples, which is 0."""
    path = folder / "own.onnx"
    path.write_bytes(constant_plus_mean(outputs, shape, metadata or {}))
    return path


def told(path: Path) -> tuple[float, float, float]:
    affect = WaveformModel.load(path).affect_of(voice())
    assert sum(affect.tones) == pytest.approx(1)
    return affect.activation, affect.valence, affect.dominance


def test_outputs_by_name(tmp_path: Path) -> None:
    path = model_file(tmp_path, {"valence": [-0.5], "arousal": [0.6], "dominance": [0.3]})
    assert told(path) == pytest.approx((0.6, -0.5, 0.3), abs=1e-4)
    assert WaveformModel.load(path).affect_of(voice()).tone is Tone.ANGRY


def test_dominance_may_be_missing(tmp_path: Path) -> None:
    assert told(model_file(tmp_path, {"valence": [-0.5], "activation": [0.6]})) == pytest.approx(
        (0.6, -0.5, 0), abs=1e-4
    )


def test_one_output_is_activation_dominance_valence_from_0_to_1(tmp_path: Path) -> None:
    path = model_file(tmp_path, {"logits": [0.8, 0.6, 0.1]}, shape=["samples"])
    assert told(path) == pytest.approx((0.6, -0.8, 0.2), abs=1e-4)


def test_metadata_tell_another_order_and_range(tmp_path: Path) -> None:
    metadata = {"order": "valence, activation", "range": "1,5"}
    assert told(model_file(tmp_path, {"out": [3.0, 5.0]}, metadata=metadata)) == pytest.approx((1, 0, 0), abs=1e-4)


def test_hidden_states_beside_the_numbers_are_ignored(tmp_path: Path) -> None:
    path = model_file(tmp_path, {"hidden_states": [0.9] * 16, "logits": [0.8, 0.6, 0.1]})
    assert told(path) == pytest.approx((0.6, -0.8, 0.2), abs=1e-4)


def test_a_fixed_number_of_samples_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ServiceError, match="any number of samples; it has tensor") as raised:
        WaveformModel.load(model_file(tmp_path, {"logits": [0.8, 0.6, 0.1]}, shape=(1, 400)))
    assert raised.value.code == "model_unreadable"


def test_a_model_that_cannot_run_on_a_sound_says_on_how_much(tmp_path: Path) -> None:
    path = model_file(tmp_path, {"logits": [0.8, 0.6, 0.1]}, shape=(2, "samples"))
    with pytest.raises(ServiceError, match=r"cannot run on 1\.00 s") as raised:
        WaveformModel.load(path).affect_of(voice())
    assert raised.value.code == "affect_model_failed"


@pytest.mark.parametrize(
    ("outputs", "metadata", "reason"),
    [
        ({"out": [0.0, 0.0]}, {}, "one output of 3 numbers, or say in its metadata's `order`"),
        ({"one": [0.0] * 3, "other": [0.0] * 3}, {}, "it has one of shape"),
        ({"hidden_states": [0.0] * 16}, {}, "one output of 3 numbers"),
        ({"out": [0.0]}, {"order": "activation"}, "must give activation and valence"),
        ({"valence": [0.0]}, {}, "must give activation and valence"),
        ({"out": [0.0, 0.0, 0.0]}, {"range": "high"}, "not a lowest and highest"),
        ({"out": [0.0, 0.0, 0.0]}, {"range": "1,1"}, "is empty"),
    ],
)
def test_what_is_not_understood_is_refused(
    tmp_path: Path, outputs: Mapping[str, Sequence[float]], metadata: Mapping[str, str], reason: str
) -> None:
    with pytest.raises(ServiceError, match=reason) as raised:
        WaveformModel.load(model_file(tmp_path, outputs, metadata=metadata))
    assert raised.value.code == "model_unreadable"


def test_another_kind_of_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "own.onnx").write_bytes(b"no model")
    with pytest.raises(ServiceError, match="not a model of affect"):
        WaveformModel.load(tmp_path / "own.onnx")
    with pytest.raises(ServiceError, match="not a model of affect"):
        WaveformModel.load(tmp_path / "missing.onnx")


def test_numbers_that_are_not_finite_are_told(tmp_path: Path) -> None:
    with pytest.raises(ServiceError, match=r"not finite; it must give 2 \(activation, valence\)") as raised:
        WaveformModel.load(model_file(tmp_path, {"activation": [float("nan")], "valence": [0.0]})).affect_of(voice())
    assert raised.value.code == "affect_model_failed"
