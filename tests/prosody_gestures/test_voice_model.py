"""Learning, keeping and decoding a model of gestures from the voice; the one that ships."""

from pathlib import Path

import numpy as np
import pytest

from tests.prosody_gestures.test_prosody import spoken
from understudy.errors import ServiceError
from understudy.model import FloatArray
from understudy.prosody_gestures.context import in_context
from understudy.prosody_gestures.prosody import features, raw_frames
from understudy.prosody_gestures.semi_markov import Segment, segments_of, similarity, states_by_frame
from understudy.prosody_gestures.voice_model import VoiceModel, learn_part
from understudy.resources import resource_folder

SHIPPED = resource_folder("models") / "prosody_gestures" / "voice.npz"


def lesson(seed: int) -> tuple[FloatArray, list[Segment], FloatArray, FloatArray]:
    """A voice whose second state is half a second after each time that it is loud and high, and the path beside it."""
    generator = np.random.default_rng(seed)
    energy_db, f0_hz = spoken(12.0, seed)
    moved = np.zeros(len(f0_hz), dtype=bool)
    for start in np.cumsum(generator.integers(150, 250, 5)):
        energy_db[start : start + 50] += 12
        f0_hz[start : start + 50] *= 1.5
        moved[start : start + 50] = True
    rows = in_context(features(raw_frames(energy_db, f0_hz)))
    states = moved[np.minimum((np.arange(len(rows)) * 2.5).astype(int), len(moved) - 1)]
    return rows, segments_of(states.astype(np.intp)), energy_db, f0_hz


def test_what_was_learnt_is_found_in_a_new_voice() -> None:
    part = learn_part("hands", ("rest", "stroke"), [lesson(seed)[:2] for seed in range(4)])
    _, path, energy_db, f0_hz = lesson(9)
    found = VoiceModel((part,)).decode(energy_db, f0_hz)["hands"]
    assert similarity(states_by_frame(found), states_by_frame(path)) > 0.95


def test_it_is_kept_whole(tmp_path: Path) -> None:
    model = VoiceModel((learn_part("head", ("still", "nod"), [lesson(0)[:2]]),))
    model.save(tmp_path / "voice.npz")
    read = VoiceModel.load(tmp_path / "voice.npz")
    _, _, energy_db, f0_hz = lesson(1)
    assert read.parts[0].model.states == ("still", "nod")
    assert read.decode(energy_db, f0_hz) == model.decode(energy_db, f0_hz)
    assert [path.name for path in tmp_path.iterdir()] == ["voice.npz"]


@pytest.mark.parametrize("content", [b"", b"nothing of the kind", SHIPPED.read_bytes()[:900]])
def test_a_broken_file_is_named(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "voice.npz").write_bytes(content)
    with pytest.raises(ServiceError, match="no model of gestures"):
        VoiceModel.load(tmp_path / "voice.npz")


def test_the_shipped_model_gestures_to_a_voice() -> None:
    """Hands, head and brows; the hands come to rest, and a stroke comes after a preparation or a hold."""
    model = VoiceModel.load(SHIPPED)
    assert [part.part for part in model.parts] == ["hands", "head", "brows"]
    assert all(np.exp(part.model.log_duration).sum(axis=1) == pytest.approx(1, abs=1e-4) for part in model.parts)
    hands = model.parts[0].model
    entered = np.exp(hands.log_transition[:, hands.states.index("stroke")])
    assert entered.argmax() == hands.states.index("preparation")
