"""The run-time half of the agitation model: evaluated as scikit-learn would, loaded only when intact."""

import hashlib
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import soundfile

from app.acoustic.agitation import CHECKSUM_FILE, MODEL_FILE, AgitationModel, Machine, save, voice_features
from app.acoustic.spectrum import energy_db, mfcc
from app.errors import ServiceError
from app.model import SAMPLE_RATE_HZ, Audio, Level
from app.resources import resource_folder

MODEL_FOLDER = resource_folder("models") / "agitation"


def toy_model() -> AgitationModel:
    """Three machines with one support vector each, at -1, 0 and 1 on the first axis, alike otherwise."""
    machines = tuple(Machine(np.eye(1, 12) * place, np.array([2.0]), -1.0, 3.0, 0.0) for place in (-1.0, 0.0, 1.0))
    return AgitationModel(np.zeros(12), np.ones(12), 1.0, machines)


@pytest.mark.parametrize(("place", "level"), [(-1.2, Level.LOW), (0.1, Level.MEDIUM), (1.4, Level.HIGH)])
def test_the_nearest_machine_wins(place: float, level: Level) -> None:
    agitation = toy_model().judge(np.eye(1, 12)[0] * place)
    assert agitation.level is level
    assert agitation.low + agitation.medium + agitation.high == pytest.approx(1)


def test_decision_value_at_the_support_vector_is_coefficient_plus_intercept() -> None:
    assert toy_model().decision_values(np.zeros(12))[1] == pytest.approx(2.0 - 1.0)


def test_only_frames_near_the_loudest_speak_for_the_voice() -> None:
    coefficients = np.repeat([[1.0] * 12, [5.0] * 12], [3, 10], axis=0)
    energy = np.repeat([0.0, -20.1], [3, 10])
    assert voice_features(coefficients, energy) == pytest.approx(np.ones(12))


def test_a_saved_model_loads_unchanged(tmp_path: Path) -> None:
    save(toy_model(), tmp_path)
    features = np.linspace(-1, 1, 12)
    assert AgitationModel.load(tmp_path).judge(features) == toy_model().judge(features)


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
        AgitationModel.load(tmp_path)
    assert raised.value.code == "model_damaged"


@pytest.mark.parametrize("missing", [MODEL_FILE, CHECKSUM_FILE])
def test_a_missing_file_is_named(tmp_path: Path, missing: str) -> None:
    save(toy_model(), tmp_path)
    (tmp_path / missing).unlink()
    with pytest.raises(ServiceError, match=missing) as raised:
        AgitationModel.load(tmp_path)
    assert raised.value.code == "model_unreadable"


@pytest.mark.parametrize("content", [b"", b"no archive", b"PK\x03\x04"])
def test_another_file_under_a_right_checksum_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / MODEL_FILE).write_bytes(content)
    (tmp_path / CHECKSUM_FILE).write_text(f"{hashlib.sha256(content).hexdigest()}  {MODEL_FILE}\n")
    with pytest.raises(ServiceError) as raised:
        AgitationModel.load(tmp_path)
    assert raised.value.code == "model_unreadable"


def test_the_shipped_model_loads_without_scikit_learn() -> None:
    program = (
        "import sys; from pathlib import Path; from app.acoustic.agitation import AgitationModel; "
        f"AgitationModel.load(Path({str(MODEL_FOLDER)!r})); sys.exit('sklearn' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


@pytest.mark.parametrize("samples", [np.zeros(1), np.zeros(SAMPLE_RATE_HZ), np.eye(1, 400)[0]])
def test_the_shipped_model_judges_whatever_it_hears(samples: np.ndarray) -> None:
    audio = Audio(samples)
    agitation = AgitationModel.load(MODEL_FOLDER).memberships(mfcc(audio), energy_db(audio))
    assert agitation.low + agitation.medium + agitation.high == pytest.approx(1)
    assert min(agitation.low, agitation.medium, agitation.high) >= 0


def test_recording_level_changes_nothing() -> None:
    model = AgitationModel.load(MODEL_FOLDER)
    samples, _ = soundfile.read(Path(__file__).parent / "audio" / "figure8.flac")
    loud, quiet = Audio(samples), Audio(samples * 0.01)
    heard, whispered = (model.memberships(mfcc(audio), energy_db(audio)) for audio in (loud, quiet))
    assert (heard.low, heard.high) == pytest.approx((whispered.low, whispered.high), abs=1e-6)
