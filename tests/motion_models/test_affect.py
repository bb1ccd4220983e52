"""How a voice feels, from its prosody."""

from pathlib import Path

import numpy as np
import pytest

from tests.prosody_gestures.test_prosody import spoken
from understudy.errors import ServiceError
from understudy.files import resource_folder
from understudy.motion_models.affect import DIMENSIONS, MEASURES, WINDOW_FRAMES, LinearAffectModel, measures
from understudy.prosody_gestures.prosody import VOICED, raw_frames

RAW = raw_frames(*spoken(6.0))


def test_measures_are_those_of_the_last_two_seconds() -> None:
    """By definition, frame by frame; nothing before the window or after the frame counts."""
    made, at = measures(RAW), 200
    window = RAW[at - WINDOW_FRAMES + 1 : at + 1]
    voiced = window[window[:, 2] >= VOICED]
    assert made.shape == (len(RAW), len(MEASURES))
    assert made[at, 0] == pytest.approx(np.log(voiced[:, 1]).mean())
    assert made[at, 1] == pytest.approx(np.log(voiced[:, 1]).std(), abs=1e-6)
    assert made[at, 3] == pytest.approx(voiced[:, 0].std(), abs=1e-6)
    assert made[at, 6] == pytest.approx(len(voiced) / WINDOW_FRAMES)
    assert made[at, 7] * WINDOW_FRAMES == pytest.approx(8), "four syllables a second"
    assert (measures(RAW[: at + 1])[-1] == made[at]).all()


def test_silence_has_measures_too() -> None:
    assert np.isfinite(measures(raw_frames(np.full(90, -90.0), np.zeros(90)))).all()


def test_the_shipped_model_hears_what_is_excited() -> None:
    """The same voice, higher and with more of a melody, is the more active."""
    model = LinearAffectModel.load(resource_folder("models") / "prosody_gestures" / "affect.npz")
    energy_db, f0_hz = spoken(6.0)
    excited = np.where(f0_hz > 0, 220 * (np.maximum(f0_hz, 1) / 120) ** 2, 0.0)
    calm, high = (model.estimate(raw_frames(energy_db, each))[-1] for each in (f0_hz, excited))
    assert calm.shape == (len(DIMENSIONS),)
    assert high[0] > calm[0] + 0.1
    assert np.abs([calm, high]).max() <= 1


def test_a_broken_file_is_named(tmp_path: Path) -> None:
    (tmp_path / "affect.npz").write_bytes(b"nothing of the kind")
    with pytest.raises(ServiceError, match="not a model of affect"):
        LinearAffectModel.load(tmp_path / "affect.npz")
