"""Recordings with motion, whoever made them: the arms' rotations beside the voice, a row of each a frame.

A recording is either of

- `NAME.bvh` with `NAME.wav`, `.flac` or `.ogg` beside it;
- `NAME.npz` with `f0_hz` (NaN where unvoiced) and `envelope` at 100 Hz, `joints`, `body` (frames × joints × 4: x, y, z,
  visibility) and `body_time_s`, as MediaPipe sees a body, and perhaps `width_to_height` of the picture. Frames in which
  a point is lost (NaN) are bridged.

`NAME.affect.csv` beside either is its continuous affect (AHG §3.3), as an annotator gave it; without it affect is
estimated from the voice (`affect`). What a name has before its first two underscores is its session, whose people are
the same.
"""

import io
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..acoustic.signal.decoding import AudioLimits, decode
from ..acoustic.stage import contours_of
from ..bvh import read_bvh
from ..errors import InputError
from ..model import AffectTrack, FloatArray
from ..prosody_gestures.prosody import features, raw_frames
from ..prosody_gestures.semi_markov import FRAME_S
from ..realizer.realizing import Realizer
from .affect import LinearAffectModel
from .bodies import ARMS, WIDTH_TO_HEIGHT, BodyTrack, body_of_bvh, body_of_points, resampled

SOUNDS = (".wav", ".flac", ".ogg")
SHORTEST_S = 2.0
_ARRAYS = ("f0_hz", "envelope", "joints", "body", "body_time_s")


@dataclass(frozen=True, slots=True)
class PairFile:
    """The files of one recording: its motion (.bvh or .npz), its sound beside a .bvh, its affect if it is given."""

    motion: Path
    sound: Path | None = None
    affect: AffectTrack | None = None

    @property
    def session(self) -> str:
        return "_".join(self.motion.stem.split("_")[:2])


@dataclass(frozen=True, slots=True, eq=False)
class Voice:
    """A voice as the model observes it, a row a frame: `prosody` (frames × 6) and `affect` (frames × 3)."""

    prosody: FloatArray
    affect: FloatArray

    def __len__(self) -> int:
        return len(self.prosody)


@dataclass(frozen=True, slots=True, eq=False)
class Pair:
    """A voice and what the body did: local `rotations` (frames × joints × 4) of these `joints`."""

    name: str
    session: str
    voice: Voice
    joints: tuple[str, ...]
    rotations: FloatArray


def heard_voice(
    energy_db: FloatArray, f0_hz: FloatArray, affect: AffectTrack | None, estimator: LinearAffectModel
) -> Voice:
    """The voice of contours, a row each .01 s, with its affect as it is given or else estimated."""
    raw = raw_frames(energy_db, f0_hz)
    if affect is None:
        return Voice(features(raw), estimator.estimate(raw))
    given = [affect.at(frame * FRAME_S) for frame in range(len(raw))]
    return Voice(features(raw), np.array([(each.activation, each.valence, each.dominance) for each in given]))


def read_pair(file: PairFile, realizer: Realizer, estimator: LinearAffectModel, limits: AudioLimits) -> Pair:
    """Both at the same frames, as long as both last. Raises InputError `bvh_wrong` and `pairs_wrong`, and as the
    decoding of sound does, with the file's name."""
    if file.motion.suffix == ".npz":
        energy_db, f0_hz, track = _points(file.motion)
    else:
        energy_db, f0_hz = _contours(file, limits)
        bvh = read_bvh(file.motion.read_bytes(), str(file.motion))
        track = body_of_bvh(bvh, str(file.motion), realizer.skeleton, realizer.rigs)
    voice = heard_voice(energy_db, f0_hz, file.affect, estimator)
    count = min(len(voice), int(track.times_s[-1] / FRAME_S) + 1)
    if count * FRAME_S < SHORTEST_S:
        raise InputError(
            "pairs_wrong", f"{file.motion}: {count * FRAME_S:.1f} s of sound with motion; {SHORTEST_S:g} s at least"
        )
    rotations = resampled(track, np.arange(count) * FRAME_S)
    kept = Voice(voice.prosody[:count], voice.affect[:count])
    return Pair(file.motion.stem, file.session, kept, track.joints, rotations)


def _contours(file: PairFile, limits: AudioLimits) -> tuple[FloatArray, FloatArray]:
    assert file.sound is not None, "motion in BVH comes with its sound"
    try:
        audio, _ = decode(file.sound.read_bytes(), limits)
    except InputError as error:
        raise InputError(error.code, f"{file.sound}: {error.message}", field=error.field) from None
    contours = contours_of(audio)
    return contours.energy_db, contours.f0_hz


def _points(path: Path) -> tuple[FloatArray, FloatArray, BodyTrack]:
    """Energy, f0 and the arms of a file of arrays."""
    arrays = _arrays(path)
    f0_hz = np.nan_to_num(arrays["f0_hz"].astype(np.float64))
    energy_db = 20 * np.log10(np.maximum(arrays["envelope"].astype(np.float64), 1e-6))
    body = arrays["body"].astype(np.float64)
    joints = [str(joint) for joint in arrays["joints"]]
    if body.ndim != 3 or body.shape[1] != len(joints) or body.shape[2] < 3 or len(body) != len(arrays["body_time_s"]):
        shape = "×".join(map(str, body.shape))
        message = (
            f"`body` is {shape}; it must be frames × {len(joints)} joints × 3 or 4, a frame for each `body_time_s`"
        )
        raise InputError("pairs_wrong", f"{path}: {message}")
    seen = np.isfinite(body[..., :3]).all(axis=(1, 2))
    if seen.sum() < 2:
        raise InputError("pairs_wrong", f"{path}: no frame of `body` has all of its points")
    wide = float(arrays["width_to_height"])
    times_s = arrays["body_time_s"][seen].astype(np.float64)
    return energy_db, f0_hz, body_of_points(body[seen], joints, times_s, wide, str(path))


def _arrays(path: Path) -> Mapping[str, FloatArray]:
    try:
        with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as file:
            arrays = {"width_to_height": np.array(WIDTH_TO_HEIGHT), **file}
    except (ValueError, EOFError, zipfile.BadZipFile):
        raise InputError("pairs_wrong", f"{path}: not arrays that NumPy can read (.npz without pickles)") from None
    missing = [name for name in _ARRAYS if name not in arrays]
    if missing:
        raise InputError("pairs_wrong", f"{path}: lacks {', '.join(missing)}; it needs {', '.join(_ARRAYS)}")
    mistakes = list(_mistakes(arrays))
    if mistakes:
        raise InputError("pairs_wrong", f"{path}: {'; '.join(mistakes)}")
    return arrays


def _mistakes(arrays: Mapping[str, FloatArray]) -> Iterator[str]:
    """What is wrong with the numbers of arrays."""
    numbers = {name: arrays[name] for name in ("f0_hz", "envelope", "body", "body_time_s", "width_to_height")}
    for name, array in numbers.items():
        if array.dtype.kind not in "fiu":
            yield f"`{name}` has no numbers"
            return
    if any(arrays[name].ndim != 1 for name in ("f0_hz", "envelope", "body_time_s")):
        yield "`f0_hz`, `envelope` and `body_time_s` are one number each for a frame"
    elif not (np.isfinite(arrays["body_time_s"]).all() and (np.diff(arrays["body_time_s"]) > 0).all()):
        yield "`body_time_s` are seconds, each later than the one before"
    if not np.isfinite(arrays["envelope"]).all():
        yield "`envelope` has values that are not finite numbers"
    if (arrays["f0_hz"] < 0).any():
        yield "`f0_hz` is below 0; NaN is unvoiced"
    if numbers["width_to_height"].size != 1 or not 0 < float(numbers["width_to_height"]) < np.inf:
        yield "`width_to_height` is one number above 0; a picture of 16:9 has 1.78"


def with_common_joints(pairs: Iterable[Pair]) -> list[Pair]:
    """The pairs with the joints that all of them have, in the same order."""
    found = list(pairs)
    common = [joint for joint in found[0].joints if all(joint in pair.joints for pair in found)]
    return [
        Pair(
            pair.name,
            pair.session,
            pair.voice,
            tuple(common),
            pair.rotations[:, [pair.joints.index(joint) for joint in common]],
        )
        for pair in found
    ]


def arms_of(joints: tuple[str, ...], rotations: FloatArray) -> FloatArray:
    """The rotations (frames × 4 × 4) of `ARMS` alone."""
    return rotations[:, [joints.index(joint) for joint in ARMS]]
