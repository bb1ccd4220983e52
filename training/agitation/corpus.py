"""Acted speech and how much each recording belongs to the levels of agitation.

`labels.csv` names a file, its corpus, speaker, emotion, intensity and level ("mid" is medium, empty is none). A
recording's memberships are 1 for its level; a few that the file leaves unlabelled lie between two levels and are given
to both (`SHARED_MEMBERSHIPS`), which is what fuzzy training is for.
"""

import csv
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soundfile
from numpy.typing import NDArray

from app.acoustic.pitch import track_f0
from app.acoustic.spectrum import energy_db, mfcc
from app.acoustic.utterance_features import FEATURE_SETS
from app.model import SAMPLE_RATE_HZ, Audio, Contours, FloatArray, Level

LEVELS = {"low": Level.LOW, "mid": Level.MEDIUM, "high": Level.HIGH}

CORPUS_WEIGHTS = {"ravdess": 1.0, "emodb": 0.5, "nemo": 0.2}
"""What a recording of each corpus counts in training. English leads, since English is what we hear; with no others the
model knows one microphone only, and with all alike it does worse on English (`benchmarks/agitation.py --ablation`)."""

SHARED_MEMBERSHIPS = {("ravdess", "fear", "normal"): (0.0, 0.5, 0.5)}
"""By corpus, emotion and intensity; low, medium, high. Strong fear is high; plain fear is taken half way to it."""


@dataclass(frozen=True, slots=True)
class Recording:
    """A recording with its memberships of low, medium, high (sum 1); `level` is None where the labels leave it open."""

    path: Path
    corpus: str
    speaker: str
    level: Level | None
    memberships: tuple[float, float, float]


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Recordings as the classifier sees them, one row each.

    `features` (rows, features), NaN where unknown, `memberships` (rows, 3), `corpora` and `speakers` (rows,); speakers
    of different corpora have different names. `levels` (rows,) is the index in `Level`, -1 where open.
    """

    features: FloatArray
    memberships: FloatArray
    levels: NDArray[np.int64]
    corpora: NDArray[np.str_]
    speakers: NDArray[np.str_]

    def where(self, chosen: NDArray[np.bool_]) -> "Samples":
        """The chosen rows."""
        return Samples(
            self.features[chosen],
            self.memberships[chosen],
            self.levels[chosen],
            self.corpora[chosen],
            self.speakers[chosen],
        )


def read_recordings(speech: Path, corpora: Collection[str]) -> list[Recording]:
    """The recordings of `corpora` in `speech`/labels.csv that belong to some level."""
    with (speech / "labels.csv").open(encoding="utf-8", newline="") as table:
        rows = [row for row in csv.DictReader(table) if row["corpus"] in corpora]
    recordings = [_recording(speech, row) for row in rows]
    return [recording for recording in recordings if any(recording.memberships)]


def describe(recordings: Sequence[Recording], features: FloatArray) -> Samples:
    """The recordings with their features, row by row."""
    levels = list(Level)
    return Samples(
        features=features,
        memberships=np.array([recording.memberships for recording in recordings]),
        levels=np.array([-1 if r.level is None else levels.index(r.level) for r in recordings]),
        corpora=np.array([recording.corpus for recording in recordings]),
        speakers=np.array([f"{recording.corpus}/{recording.speaker}" for recording in recordings]),
    )


def measure(
    recordings: Sequence[Recording], feature_sets: Sequence[str], change: Callable[[Audio], Audio] = lambda audio: audio
) -> dict[str, FloatArray]:
    """The features of each recording as the program computes them, by feature set; shape (recordings, features).

    `change` is what happens to the recordings first.
    """
    rows: dict[str, list[FloatArray]] = {name: [] for name in feature_sets}
    for recording in recordings:
        audio = change(read_audio(recording.path))
        contours = listen(audio)
        for name in feature_sets:
            rows[name].append(FEATURE_SETS[name](audio, contours))
    return {name: np.array(features) for name, features in rows.items()}


def listen(audio: Audio) -> Contours:
    """The contours as `app.performance` makes them."""
    return Contours(energy_db=energy_db(audio), f0_hz=track_f0(audio), mfcc=mfcc(audio))


def read_audio(path: Path) -> Audio:
    """The recording, which must be mono at 16 kHz."""
    samples, rate_hz = soundfile.read(path, dtype="float64")
    if rate_hz != SAMPLE_RATE_HZ or samples.ndim != 1:
        raise ValueError(f"{path} has rate {rate_hz} Hz and shape {samples.shape}; expected mono at 16 kHz")
    return Audio(samples)


def _recording(speech: Path, row: dict[str, str]) -> Recording:
    level = LEVELS.get(row["agitation"])
    shared = SHARED_MEMBERSHIPS.get((row["corpus"], row["emotion"], row["intensity"]), (0.0, 0.0, 0.0))
    low, medium, high = (float(level is name) for name in Level)
    return Recording(
        path=speech / row["file"],
        corpus=row["corpus"],
        speaker=row["speaker"],
        level=level,
        memberships=(low, medium, high) if level else shared,
    )
