"""What the model of affect is taught by: people's recordings and those of synthetic voices."""

import json
from pathlib import Path

import numpy as np
import pytest

from training.affect.corpus import SYNTHETIC, joined, read_spoken, taught
from understudy.model import Tone


@pytest.fixture
def index(tmp_path: Path) -> Path:
    rows = [
        {"id": "a", "path": "a.slt.flac", "voice": "slt", "tone": "sad", "loudness": -1},
        {"id": "a", "path": "a.rms.flac", "voice": "rms", "tone": "sad", "loudness": -1},
        {"id": "b", "path": "b.rms.flac", "voice": "rms", "tone": "weary", "loudness": 0},
    ]
    path = tmp_path / "index.jsonl"
    path.write_text("".join(f"{json.dumps(row)}\n" for row in rows), encoding="utf-8")
    return path


def test_each_delivery_is_heard_once_in_the_voice_that_said_it_first(index: Path) -> None:
    spoken = read_spoken([index])
    assert [each.recording.path for each in spoken] == [index.parent / "a.slt.flac", index.parent / "b.rms.flac"]
    assert {each.recording.corpus for each in spoken} == {SYNTHETIC}


def test_a_soft_voice_is_less_active_than_its_tone_alone(index: Path) -> None:
    sad, weary = read_spoken([index])
    assert sad.tones == {Tone.SAD: 1.0}
    assert set(weary.tones) == {Tone.SAD, Tone.NEUTRAL}
    assert sad.dimensions[0] < -0.5
    assert sad.dimensions[1] == weary.dimensions[1] - 0.3


def test_a_mixture_of_tones_has_memberships_and_no_level(index: Path) -> None:
    material = taught(read_spoken([index]), {"clean": np.zeros((2, 3))})
    assert material.samples.levels.tolist() == [list(Tone).index(Tone.SAD), -1]
    assert material.samples.memberships.sum(axis=1) == pytest.approx([1, 1])


def test_what_is_joined_keeps_its_rows_in_order(index: Path) -> None:
    spoken = read_spoken([index])
    one, other = taught(spoken, {"clean": np.zeros((2, 3))}), taught(spoken, {"clean": np.ones((2, 3))})
    both = joined(one, other)
    assert both.samples.features[:, 0].tolist() == [0, 0, 1, 1]
    assert both.dimensions.shape == (4, 3)
