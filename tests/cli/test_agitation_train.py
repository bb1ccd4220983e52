"""`agitation train` on sounds that are made here: the model it writes judges them."""

import json
import os
from pathlib import Path

import numpy as np
import pytest
import soundfile

from understudy.cli.main import AGITATION_MODEL, main
from understudy.model import SAMPLE_RATE_HZ

LEVELS = {"low": (110.0, 0.2, 0.9), "medium": (160.0, 0.4, 0.6), "high": (260.0, 0.8, 0.3)}
"""Pitch in Hz, loudness, and how fast the overtones fall."""


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three speakers' tones at each level, and their table."""
    folder, rows = tmp_path_factory.mktemp("labelled"), ["file,speaker,agitation"]
    random = np.random.default_rng(0)
    times_s = np.arange(SAMPLE_RATE_HZ * 6 // 10) / SAMPLE_RATE_HZ
    for speaker, shift in (("Ann", 1.2), ("Bob", 0.9), ("Cal", 1.0)):
        for level, (pitch_hz, loud, fall) in LEVELS.items():
            for take in range(2):
                hz = pitch_hz * shift * random.uniform(0.95, 1.05)
                tone = sum(np.sin(2 * np.pi * hz * n * times_s) * (1 - fall) ** (n - 1) for n in range(1, 12))
                noise = random.normal(0, 0.005, len(times_s))
                name = f"{speaker}_{level}_{take}.wav"
                soundfile.write(folder / name, loud * tone / np.abs(tone).max() + noise, SAMPLE_RATE_HZ)
                rows.append(f"{name},{speaker},{level}")
    (folder / "labels.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    return folder


def test_a_model_is_taught_and_used(recordings: Path, capsys: pytest.CaptureFixture[str]) -> None:
    model = recordings / "own.npz"
    assert main(["agitation", "train", str(recordings / "labels.csv"), "-o", str(model)]) == 0
    told = capsys.readouterr().err
    assert "18 recordings of 3 speakers; each speaker left out: " in told
    sounds = [str(recordings / f"Ann_{level}_0.wav") for level in LEVELS]
    assert main(["agitation", *sounds, "--agitation-model", str(model), "--quiet"]) == 0
    judged = [json.loads(line)["agitation"] for line in capsys.readouterr().out.splitlines()]
    assert judged == list(LEVELS)
    assert AGITATION_MODEL not in os.environ


def test_what_is_wrong_is_told(recordings: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = recordings / "wrong.csv"
    table.write_text("file,speaker,agitation\ngone.wav,Ann,low\n", encoding="utf-8")
    assert main(["agitation", "train", str(table), "-o", str(tmp_path / "m.npz")]) == 2
    assert "wrong.csv:2: there is no file 'gone.wav'" in capsys.readouterr().err
    sound = str(recordings / "Ann_low_0.wav")
    assert main(["agitation", sound, "--agitation-model", str(table)]) == 2
    assert "wrong.csv is not an agitation model" in capsys.readouterr().err
