"""Recordings with motion, whoever made them: arms' angles beside prosody, a row of each a frame.

A folder holds either of

- `NAME.bvh` and `NAME.wav` (or .flac): the Euler angles of arms and forearms, as AHG §3.1 has them;
- `NAME.npz` with `f0_hz` (NaN where unvoiced) and `envelope` at 100 Hz, `joints`, `body` (frames × joints × 4: x, y, z,
  visibility) and `body_time_s`, as MediaPipe sees a body. Points have no Euler angles: an arm's direction is taken
  instead, how far it is turned sideways and how far it is raised, of upper arms and forearms. Frames in which a point
  is lost (NaN) are bridged.

What a name has before its first two underscores is its session, whose people are the same.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from training.prosody_gestures.bvh import read_rotations
from understudy.acoustic.contours import contours_of
from understudy.acoustic.signal.decoding import decode
from understudy.acoustic.stage import audio_limits
from understudy.errors import InputError
from understudy.model import FloatArray
from understudy.prosody_gestures.prosody import features, raw_frames
from understudy.prosody_gestures.semi_markov import FRAME_S
from understudy.settings import Settings

BVH_JOINTS = ("LeftArm", "LeftForeArm", "RightArm", "RightForeArm")
LIMBS = (
    ("LEFT_SHOULDER", "LEFT_ELBOW"),
    ("LEFT_ELBOW", "LEFT_WRIST"),
    ("RIGHT_SHOULDER", "RIGHT_ELBOW"),
    ("RIGHT_ELBOW", "RIGHT_WRIST"),
)


@dataclass(frozen=True, slots=True, eq=False)
class MotionPair:
    """`features` (frames × 6) of the prosody and `angles` (frames × angles, radians) of the arms, a row each
    `FRAME_S`; the contours that the features are of (a row each .01 s)."""

    name: str
    session: str
    energy_db: FloatArray
    f0_hz: FloatArray
    features: FloatArray
    angles: FloatArray


def read_pairs(folder: Path, joints: Sequence[str] = BVH_JOINTS) -> list[MotionPair]:
    """All pairs of a folder, by name. Raises InputError `pairs_wrong` where there are none or a sound is missing."""
    pairs = [read_points(path) for path in sorted(folder.glob("*.npz"))]
    pairs += [read_motion(path, joints) for path in sorted(folder.glob("*.bvh"))]
    if not pairs:
        raise InputError("pairs_wrong", f"{folder}: neither .npz nor .bvh files; give NAME.bvh with NAME.wav beside it")
    return pairs


def read_points(path: Path) -> MotionPair:
    """A pair of contours and tracked points."""
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = {name: file[name] for name in ("f0_hz", "envelope", "joints", "body", "body_time_s")}
    except KeyError as error:
        raise InputError("pairs_wrong", f"{path}: {error}") from None
    f0_hz = np.nan_to_num(arrays["f0_hz"].astype(np.float64))
    energy_db = 20 * np.log10(np.maximum(arrays["envelope"].astype(np.float64), 1e-6))
    places = {str(joint): place for place, joint in enumerate(arrays["joints"])}
    seen = np.isfinite(arrays["body"]).all(axis=(1, 2))
    if not seen.any():
        raise InputError("pairs_wrong", f"{path}: no frame of `body` has all of its points")
    points = arrays["body"][seen].astype(np.float64)
    directions = [points[:, places[end], :3] - points[:, places[begin], :3] for begin, end in LIMBS]
    angles = np.concatenate([_direction(each) for each in directions], axis=1)
    return _pair(path, energy_db, f0_hz, angles, arrays["body_time_s"][seen].astype(np.float64))


def read_motion(path: Path, joints: Sequence[str] = BVH_JOINTS) -> MotionPair:
    """A pair of BVH and the sound of the same name beside it."""
    sound = next((path.with_suffix(end) for end in (".wav", ".flac") if path.with_suffix(end).exists()), None)
    if sound is None:
        raise InputError("pairs_wrong", f"{path}: no {path.stem}.wav or {path.stem}.flac beside it")
    rotations = read_rotations(path, joints)
    audio, _ = decode(sound.read_bytes(), audio_limits(Settings()))
    contours = contours_of(audio)
    angles = rotations.angles.reshape(len(rotations.angles), -1)
    return _pair(path, contours.energy_db, contours.f0_hz, angles, np.arange(len(angles)) * rotations.frame_s)


def _pair(path: Path, energy_db: FloatArray, f0_hz: FloatArray, angles: FloatArray, times_s: FloatArray) -> MotionPair:
    """Both at the same frames, as long as both are there."""
    made = features(raw_frames(energy_db, f0_hz))
    count = min(len(made), int(times_s[-1] / FRAME_S) + 1)
    at_s = np.arange(count) * FRAME_S
    resampled = np.stack([np.interp(at_s, times_s, column) for column in angles.T], axis=1)
    return MotionPair(path.stem, "_".join(path.stem.split("_")[:2]), energy_db, f0_hz, made[:count], resampled)


def _direction(vectors: FloatArray) -> FloatArray:
    """How far vectors (x to the right, y down) turn from straight down sideways, and towards the viewer."""
    across, down, away = vectors.T
    return np.unwrap(np.stack([np.arctan2(across, down), np.arctan2(-away, np.hypot(across, down))], axis=1), axis=0)


def movements(pairs: Iterable[MotionPair]) -> list[FloatArray]:
    """What is clustered: each pair's angles with their changes (AHG eq. 1, 2), of mean 0 and deviation 1 over all."""
    streams = [np.concatenate([pair.angles, np.gradient(pair.angles, axis=0)], axis=1) for pair in pairs]
    everything = np.concatenate(streams)
    mean, deviation = everything.mean(axis=0), everything.std(axis=0) + 1e-9
    return [(stream - mean) / deviation for stream in streams]
