"""Small recordings of speech with motion, made here: a voice, and arms that swing with it."""

from pathlib import Path

import numpy as np
import soundfile

from tests.prosody_gestures.test_prosody import spoken
from understudy.model import FloatArray

POINTS = (
    *("NOSE", "LEFT_SHOULDER", "RIGHT_SHOULDER", "LEFT_ELBOW", "RIGHT_ELBOW", "LEFT_WRIST", "RIGHT_WRIST"),
    *("LEFT_HIP", "RIGHT_HIP"),
)
RATE_HZ = 30


def write_points(folder: Path, name: str, seed: int, seconds: float = 12.0) -> None:
    """Forearms that swing from one side to straight down and back; a square picture, hips half a metre below."""
    times_s = np.arange(0, seconds, 1 / RATE_HZ)
    body = np.zeros((len(times_s), len(POINTS), 4), dtype=np.float64)
    swing = np.cos(times_s * (1 + seed)) * np.pi / 2
    for side, sign in ((0, 1), (1, -1)):
        body[:, 1 + side, 0] = body[:, 3 + side, 0] = sign * 0.2
        body[:, 3 + side, 1] = 0.3
        body[:, 5 + side, 0] = body[:, 3 + side, 0] + sign * 0.25 * np.sin(np.abs(swing))
        body[:, 5 + side, 1] = 0.3 + 0.25 * np.cos(swing)
        body[:, 7 + side, :2] = sign * 0.1, 0.5
    energy_db, f0_hz = spoken(seconds, seed)
    np.savez(
        folder / f"{name}.npz",
        f0_hz=np.where(f0_hz > 0, f0_hz, np.nan).astype(np.float32),
        envelope=(10 ** (energy_db / 20)).astype(np.float32),
        joints=np.array(POINTS),
        body=body,
        body_time_s=times_s.astype(np.float32),
        width_to_height=np.array(1.0),
    )


SKELETON = (
    ("Hips", 0, "0 90 0"),
    ("Spine", 1, "0 20 0"),
    ("LeftArm", 2, "20 30 0"),
    ("LeftForeArm", 3, "28 0 0"),
    ("RightArm", 2, "-20 30 0"),
    ("RightForeArm", 3, "-28 0 0"),
)
"""Joints in a T-pose, with their depth and offset in centimetres."""


def write_bvh(folder: Path, name: str, seed: int = 0, seconds: float = 12.0, *, names: str = "{}") -> None:
    """A body whose left forearm bends forwards and back while the right arm hangs, and a voice of 150 Hz that comes and
    goes. `names` is how its rig names joints."""
    lines, depth = ["HIERARCHY"], -1
    for joint, level, offset in SKELETON:
        lines += ["}"] * (depth - level + 1)
        kind, place = ("JOINT", "") if level else ("ROOT", "6 Xposition Yposition Zposition ")
        lines += [f"{kind} {names.format(joint)}", "{", f"OFFSET {offset}"]
        lines += [f"CHANNELS {place or '3 '}Zrotation Xrotation Yrotation"]
        depth = level
    lines += ["}"] * (depth + 1)
    times_s = np.arange(0, seconds, 1 / RATE_HZ)
    values = np.zeros((len(times_s), 3 + 3 * len(SKELETON)))
    values[:, 1] = 90
    values[:, column("LeftForeArm", "Y")] = -45 + 45 * np.cos(times_s * (2 + seed))
    values[:, column("RightArm", "Z")] = 90
    rows = [" ".join(f"{value:.4f}" for value in row) for row in values.tolist()]
    lines += ["MOTION", f"Frames: {len(rows)}", f"Frame Time: {1 / RATE_HZ}", *rows]
    (folder / f"{name}.bvh").write_text("\n".join(lines) + "\n")
    soundfile.write(folder / f"{name}.wav", voice(seconds, seed), 16000)


def column(joint: str, axis: str) -> int:
    """The column of a rotation."""
    return 3 + 3 * [each for each, _, _ in SKELETON].index(joint) + "ZXY".index(axis)


def voice(seconds: float, seed: int) -> FloatArray:
    times_s = np.arange(0, seconds, 1 / 16000)
    sounding = np.cos(times_s * (2 + seed)) > -0.3
    heard: FloatArray = 0.3 * sounding * np.sign(np.sin(2 * np.pi * 150 * times_s))
    return heard
