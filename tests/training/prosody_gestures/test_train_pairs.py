"""Pairs of voice and motion: read, clustered, learnt from, kept. The motion and the voice are made here."""

from pathlib import Path

import numpy as np
import pytest
import soundfile

from tests.prosody_gestures.test_prosody import spoken
from training.prosody_gestures.motion_pairs import BVH_JOINTS, read_pairs
from training.prosody_gestures.train_pairs import main
from understudy.errors import InputError
from understudy.prosody_gestures.semi_markov import FRAME_S
from understudy.prosody_gestures.voice_model import VoiceModel

SECONDS = 12
POINTS = ("NOSE", "LEFT_SHOULDER", "RIGHT_SHOULDER", "LEFT_ELBOW", "RIGHT_ELBOW", "LEFT_WRIST", "RIGHT_WRIST")


def write_points(folder: Path, name: str, seed: int) -> None:
    """Arms that swing, at 30 frames a second; the left forearm points to the side at first."""
    times_s = np.arange(0, SECONDS, 1 / 30)
    body = np.zeros((len(times_s), len(POINTS), 4), dtype=np.float16)
    for side, sign in ((0, 1), (1, -1)):
        body[:, 1 + side, 0] = sign * 0.2
        body[:, 3 + side, :2] = np.stack([np.full(len(times_s), sign * 0.2), np.full(len(times_s), 0.3)], axis=1)
        swing = np.cos(times_s * (1 + seed)) * np.pi / 2
        body[:, 5 + side, 0] = body[:, 3 + side, 0] + sign * 0.25 * np.sin(swing)
        body[:, 5 + side, 1] = 0.3 + 0.25 * np.cos(swing)
    energy_db, f0_hz = spoken(SECONDS, seed)
    np.savez(
        folder / f"{name}.npz",
        f0_hz=np.where(f0_hz > 0, f0_hz, np.nan).astype(np.float32),
        envelope=(10 ** (energy_db / 20)).astype(np.float32),
        joints=np.array(POINTS),
        body=body,
        body_time_s=times_s.astype(np.float32),
    )


def write_bvh(folder: Path, name: str) -> None:
    joints = "".join(f"JOINT {joint}\n{{\nCHANNELS 3 Zrotation Xrotation Yrotation\n" for joint in BVH_JOINTS)
    turns = np.arange(90)[:, None] * np.ones(12)
    rows = "\n".join(" ".join(map(str, row)) for row in turns.tolist())
    text = f"HIERARCHY\n{joints}{'}' * 4}\nMOTION\nFrames: 90\nFrame Time: 0.0333333\n{rows}\n"
    (folder / f"{name}.bvh").write_text(text)
    times_s = np.arange(0, 3, 1 / 16000)
    soundfile.write(folder / f"{name}.wav", 0.3 * np.sign(np.sin(2 * np.pi * 150 * times_s)), 16000)


def test_tracked_points_become_directions_of_the_arms(tmp_path: Path) -> None:
    write_points(tmp_path, "one_two_three", 0)
    (pair,) = read_pairs(tmp_path)
    assert pair.session == "one_two"
    assert len(pair.angles) == len(pair.features)
    assert pair.angles[0, 2:4] == pytest.approx([np.pi / 2, 0], abs=0.01), "the left forearm, straight to the side"
    assert pair.angles[:, 0] == pytest.approx(0, abs=0.01), "the upper arm hangs down"
    down = round(np.pi / 2 / FRAME_S)
    assert pair.angles[down, 2] == pytest.approx(0, abs=0.05), "a quarter of a swing later the forearm does too"


def test_lost_points_are_bridged(tmp_path: Path) -> None:
    """Three frames without a left wrist change nothing by more than the swing bends in a tenth of a second."""
    write_points(tmp_path, "one_two_three", 0)
    (whole,) = read_pairs(tmp_path)
    with np.load(tmp_path / "one_two_three.npz") as file:
        arrays = dict(file)
    arrays["body"][50:53, 5] = np.nan
    np.savez(tmp_path / "one_two_three.npz", **arrays)
    (bridged,) = read_pairs(tmp_path)
    assert bridged.angles == pytest.approx(whole.angles, abs=0.02)
    arrays["body"][:, 5] = np.nan
    np.savez(tmp_path / "one_two_three.npz", **arrays)
    with pytest.raises(InputError, match="no frame"):
        read_pairs(tmp_path)


def test_motion_is_brought_to_the_frames_of_its_sound(tmp_path: Path) -> None:
    """A degree each thirtieth of a second, on all axes of four joints; a voice of 150 Hz."""
    write_bvh(tmp_path, "walk")
    (pair,) = read_pairs(tmp_path)
    assert pair.angles.shape[1] == 12
    assert np.degrees(pair.angles[40]) == pytest.approx(30, abs=0.01)
    assert np.median(pair.f0_hz[pair.f0_hz > 0]) == pytest.approx(150, rel=0.02)


def test_a_sound_that_is_missing_is_asked_for(tmp_path: Path) -> None:
    write_bvh(tmp_path, "walk")
    (tmp_path / "walk.wav").unlink()
    with pytest.raises(InputError, match=r"no walk\.wav"):
        read_pairs(tmp_path)


def test_an_empty_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="neither"):
        read_pairs(tmp_path)


def test_a_team_trains_on_its_own_pairs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The model decodes a voice, and the units are all of the motion, cut up."""
    for seed in range(3):
        write_points(tmp_path, f"a_b_{seed}", seed)
    main([str(tmp_path), str(tmp_path / "out"), "--clusters", "4"])
    assert "4 kinds of movements from 3 recordings" in capsys.readouterr().out
    model = VoiceModel.load(tmp_path / "out" / "voice.npz")
    path = model.decode(*spoken(4.0, 9))["hands"]
    assert {segment.state for segment in path} <= set(range(4))
    with np.load(tmp_path / "out" / "units.npz") as units:
        assert units["frames"].sum() == len(units["angles"])
        assert set(units["state"].tolist()) <= set(range(4))
