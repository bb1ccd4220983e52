"""Acted speech and how much each recording belongs to the levels of agitation.

`labels.csv` names a file, its corpus, speaker, emotion, intensity and level ("mid" is medium, empty is none). A
recording's memberships are 1 for its level; a few that the file leaves unlabelled lie between two levels and are given
to both (`SHARED_MEMBERSHIPS`), which is what fuzzy training is for. Each recording is heard under several conditions:
as it is, in noise or through another microphone, and in other voices (`training/agitation/conditions.py`).
"""

import csv
import zlib
from collections.abc import Collection, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
import soundfile
from numpy.typing import NDArray

from training.agitation.conditions import Condition
from understudy.acoustic.agitation.utterance_features import FEATURE_SETS, full_features
from understudy.acoustic.agitation.voice_quality import voice_quality
from understudy.acoustic.stage import contours_of
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray, Level

LEVELS = {"low": Level.LOW, "mid": Level.MEDIUM, "high": Level.HIGH}

CORPORA = ("ravdess", "emodb", "nemo")
"""What models are trained on."""

FREE_CORPORA = ("emodb",)
"""Those of them that may be used for anything, also commercially."""

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
    """Recordings as the classifier sees them, one row for each and each condition.

    `features` (rows, features), NaN where unknown, `memberships` (rows, 3), `corpora`, `speakers` and `conditions`
    (rows,); speakers of different corpora have different names. `levels` (rows,) index `Level`, -1 where open.
    """

    features: FloatArray
    memberships: FloatArray
    levels: NDArray[np.int64]
    corpora: NDArray[np.str_]
    speakers: NDArray[np.str_]
    conditions: NDArray[np.str_]

    def where(self, chosen: NDArray[np.bool_]) -> "Samples":
        """The chosen rows."""
        return Samples(*(getattr(self, column.name)[chosen] for column in fields(self)))

    def occasions(self) -> Iterator[NDArray[np.int64]]:
        """The rows of each speaker under each condition."""
        for speaker, condition in sorted(set(zip(self.speakers.tolist(), self.conditions.tolist(), strict=True))):
            yield np.flatnonzero((self.speakers == speaker) & (self.conditions == condition))


def read_recordings(speech: Path, corpora: Collection[str]) -> list[Recording]:
    """The recordings of `corpora` in `speech`/labels.csv that belong to some level."""
    with (speech / "labels.csv").open(encoding="utf-8", newline="") as table:
        rows = [row for row in csv.DictReader(table) if row["corpus"] in corpora]
    recordings = [_recording(speech, row) for row in rows]
    return [recording for recording in recordings if any(recording.memberships)]


def describe(recordings: Sequence[Recording], features: Mapping[str, FloatArray]) -> Samples:
    """The recordings under one condition after another, with their features (recordings, features) under each."""
    levels, count = list(Level), len(features)
    return Samples(
        features=np.concatenate(list(features.values())),
        memberships=np.tile([recording.memberships for recording in recordings], (count, 1)),
        levels=np.tile([-1 if r.level is None else levels.index(r.level) for r in recordings], count),
        corpora=np.tile([recording.corpus for recording in recordings], count),
        speakers=np.tile([f"{recording.corpus}/{recording.speaker}" for recording in recordings], count),
        conditions=np.repeat(list(features), len(recordings)),
    )


def measure(recordings: Sequence[Recording], conditions: Mapping[str, Condition]) -> dict[str, dict[str, FloatArray]]:
    """The features of each recording as the program computes them, shape (recordings, features), by set and condition.

    A recording is changed the same way each time. All processors are used.
    """
    tasks = [(recording.path, change) for change in conditions.values() for recording in recordings]
    with ProcessPoolExecutor() as processes:
        rows = list(processes.map(_features, tasks, chunksize=20))
    return {
        name: {
            condition: np.array([row[name] for row in rows[index * len(recordings) : (index + 1) * len(recordings)]])
            for index, condition in enumerate(conditions)
        }
        for name in FEATURE_SETS
    }


def _features(task: tuple[Path, Condition]) -> dict[str, FloatArray]:
    path, change = task
    audio = change(read_audio(path), np.random.default_rng(zlib.crc32(path.name.encode())))
    contours = contours_of(audio)
    features = full_features(contours, voice_quality(audio, contours.f0_hz))
    return {name: features[:count] for name, count in FEATURE_SETS.items()}


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
