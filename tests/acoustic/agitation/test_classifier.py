"""Evaluating the agitation model: the result equals scikit-learn's, and the model is loaded only when intact."""

import hashlib
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from tests.support.words.measured import measured
from understudy.acoustic.agitation.classifier import AgitationModel, FuzzySvm, save
from understudy.acoustic.agitation.utterance_features import FEATURE_SETS, TypicalSpeaker, full_features
from understudy.errors import InputError, ServiceError
from understudy.files import resource_folder
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray, Level
from understudy.model.voice.signal import SpeakerReference

MODEL_FOLDER = resource_folder("models") / "agitation"
MODEL_FILE, CHECKSUM_FILE = "paper.npz", "paper.npz.sha256"


def toy_svm() -> FuzzySvm:
    """Three machines with one support vector each, at -1, 0 and 1 on the first axis, alike otherwise."""
    return FuzzySvm(
        mean=np.zeros(12),
        scale=np.ones(12),
        gamma=np.array([1.0]),
        support_vectors=np.array([at(-1.0), at(0.0), at(1.0)]),
        coefficients=2.0 * np.eye(3),
        intercepts=-np.ones(3),
        slopes=3.0 * np.ones(3),
        offsets=np.zeros(3),
    )


def toy_model() -> AgitationModel:
    return AgitationModel("paper", TypicalSpeaker(np.zeros(12), np.ones(12)), toy_svm(), toy_svm())


def at(place: float) -> FloatArray:
    return np.append(place, np.zeros(11))


@pytest.mark.parametrize(("place", "level"), [(-1.2, Level.LOW), (0.1, Level.MEDIUM), (1.4, Level.HIGH)])
def test_the_nearest_machine_wins(place: float, level: Level) -> None:
    agitation = toy_model().judge(at(place))
    assert agitation.level is level
    assert agitation.low + agitation.medium + agitation.high == pytest.approx(1)


def test_decision_value_at_the_support_vector_is_coefficient_plus_intercept() -> None:
    assert toy_svm().decision_values(np.zeros(12))[1] == pytest.approx(2.0 - 1.0)


def test_a_feature_of_infinite_scale_has_no_say() -> None:
    deaf = replace(toy_svm(), scale=np.append(np.inf, np.ones(11)))
    assert deaf.memberships(at(-1.0)) == pytest.approx(deaf.memberships(at(1.0)))


def test_memberships_are_softmax_of_the_scaled_decision_values() -> None:
    values = 3.0 * toy_svm().decision_values(at(0.3))
    assert toy_svm().memberships(at(0.3)) == pytest.approx(np.exp(values) / np.exp(values).sum())


def speaker(mean: float, recordings: int) -> SpeakerReference:
    return SpeakerReference("paper", recordings, at(mean), np.ones(12))


def test_what_is_high_for_most_is_low_for_one_who_is_louder_still() -> None:
    assert toy_model().judge(at(1.0)).level is Level.HIGH
    assert toy_model().judge(at(1.0), speaker(2.5, 1000)).level is Level.LOW


def test_the_more_recordings_of_the_speaker_the_more_they_count() -> None:
    highs = [toy_model().judge(at(1.0), speaker(2.5, count)).high for count in (1, 5, 20, 100)]
    assert highs == sorted(highs, reverse=True)
    assert toy_model().judge(at(1.0)).high > highs[0] > highs[-1] + 0.2


@pytest.mark.parametrize(("feature_set", "features"), [("full", 115), ("full", 12), ("paper", 49)])
def test_a_reference_of_other_features_is_refused(feature_set: str, features: int) -> None:
    """Also one of the same name that an earlier version made."""
    other = SpeakerReference(feature_set, 5, np.zeros(features), np.ones(features))
    with pytest.raises(InputError, match="understudy reference") as raised:
        toy_model().judge(np.zeros(12), other)
    assert raised.value.code == "reference_other_features"


def test_a_saved_model_loads_unchanged(tmp_path: Path) -> None:
    save(toy_model(), tmp_path)
    features = np.linspace(-1, 1, 12)
    loaded = AgitationModel.load(tmp_path, "paper")
    for reference in (None, speaker(1.0, 4)):
        assert loaded.judge(features, reference) == toy_model().judge(features, reference)


def test_saving_twice_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one", "two"):
        save(toy_model(), tmp_path / name)
    assert (tmp_path / "one" / MODEL_FILE).read_bytes() == (tmp_path / "two" / MODEL_FILE).read_bytes()


def test_a_changed_byte_is_noticed(tmp_path: Path) -> None:
    save(toy_model(), tmp_path)
    content = bytearray((tmp_path / MODEL_FILE).read_bytes())
    content[len(content) // 2] ^= 1
    (tmp_path / MODEL_FILE).write_bytes(content)
    with pytest.raises(ServiceError, match="differs from its checksum") as raised:
        AgitationModel.load(tmp_path, "paper")
    assert raised.value.code == "model_damaged"


@pytest.mark.parametrize("missing", [MODEL_FILE, CHECKSUM_FILE])
def test_a_missing_file_is_named(tmp_path: Path, missing: str) -> None:
    save(toy_model(), tmp_path)
    (tmp_path / missing).unlink()
    with pytest.raises(ServiceError, match=missing) as raised:
        AgitationModel.load(tmp_path, "paper")
    assert raised.value.code == "model_unreadable"


@pytest.mark.parametrize("content", [b"", b"no archive", b"PK\x03\x04"])
def test_another_file_under_a_right_checksum_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / MODEL_FILE).write_bytes(content)
    (tmp_path / CHECKSUM_FILE).write_text(f"{hashlib.sha256(content).hexdigest()}  {MODEL_FILE}\n")
    with pytest.raises(ServiceError) as raised:
        AgitationModel.load(tmp_path, "paper")
    assert raised.value.code == "model_unreadable"


def test_the_shipped_models_load_without_scikit_learn() -> None:
    program = (
        "import sys; from pathlib import Path; from understudy.acoustic.agitation.classifier import AgitationModel; "
        f"[AgitationModel.load(Path({str(MODEL_FOLDER)!r}), name) for name in ('paper', 'full')]; "
        "sys.exit('sklearn' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


@pytest.mark.parametrize("feature_set", FEATURE_SETS)
@pytest.mark.parametrize("samples", [np.zeros(1), np.zeros(SAMPLE_RATE_HZ), np.eye(1, 400)[0]])
def test_the_shipped_models_judge_whatever_they_hear(samples: FloatArray, feature_set: str) -> None:
    audio = Audio(samples)
    agitation = AgitationModel.load(MODEL_FOLDER, feature_set).agitation(full_features(*measured(audio)))
    assert agitation.low + agitation.medium + agitation.high == pytest.approx(1)
    assert min(agitation.low, agitation.medium, agitation.high) >= 0


@pytest.mark.parametrize("feature_set", FEATURE_SETS)
def test_recording_level_changes_nothing(feature_set: str) -> None:
    model = AgitationModel.load(MODEL_FOLDER, feature_set)
    samples, _ = soundfile.read(Path(__file__).parents[2] / "audio" / "figure8.flac")
    loud, quiet = Audio(samples), Audio(samples * 0.01)
    heard, whispered = (model.agitation(full_features(*measured(audio))) for audio in (loud, quiet))
    assert (heard.low, heard.high) == pytest.approx((whispered.low, whispered.high), abs=1e-4)
