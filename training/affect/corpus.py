"""Acted and synthetic speech with its tones, and the activation, valence and dominance learnt from each recording.

`labels.csv` names a file, its corpus, speaker, emotion and intensity. Calm and bored recordings belong to no tone: they
teach the dimensions alone. A recording's dimensions are those that people give its emotion's name (Russell & Mehrabian
1977, rounded), four fifths of them where the intensity is normal. Synthetic voices say deliveries
(`training/focus/speaking.py`, `plain_speech.py`); some of their tones are mixtures of ours.
"""

import csv
import json
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from training.acting.listening import TONES as WRITTEN_TONES
from training.agitation.corpus import Recording, Samples
from understudy.model import FloatArray, Tone
from understudy.model.voice.affect import PLACES

TONES: Mapping[str, Tone] = MappingProxyType(
    {
        "neutral": Tone.NEUTRAL,
        "happiness": Tone.HAPPY,
        "sadness": Tone.SAD,
        "anger": Tone.ANGRY,
        "fear": Tone.AFRAID,
        "disgust": Tone.DISGUSTED,
        "surprise": Tone.SURPRISED,
    }
)
"""By the labels' emotions."""

TONELESS: Mapping[str, tuple[float, float, float]] = MappingProxyType(
    {"calm": (-0.4, 0.3, 0.1), "boredom": (-0.6, -0.4, -0.3)}
)
"""Activation, valence and dominance of emotions that are no tone of ours."""

SYNTHETIC = "synthetic"
"""The corpus of synthetic voices; its speakers are the voices."""

OF_LOUDNESS = (0.15, 0.0, 0.1)
"""What loudness (-1 soft, 1 loud) adds to activation, valence and dominance."""

NORMAL = 0.8
"""The dimensions of a recording of normal intensity, of those of a strong one."""


@dataclass(frozen=True, slots=True)
class Labelled:
    """A recording, its memberships in tones (none where it has none of ours) and its dimensions."""

    recording: Recording
    tones: Mapping[Tone, float]
    dimensions: tuple[float, float, float]


def read_labelled(speech: Path, corpora: Collection[str]) -> list[Labelled]:
    """The recordings of `corpora` in `speech`/labels.csv."""
    with (speech / "labels.csv").open(encoding="utf-8", newline="") as table:
        return [_labelled(speech, row) for row in csv.DictReader(table) if row["corpus"] in corpora]


def _labelled(speech: Path, row: Mapping[str, str]) -> Labelled:
    tone = TONES.get(row["emotion"])
    place = TONELESS[row["emotion"]] if tone is None else PLACES[tone]
    strength = NORMAL if row["intensity"] == "normal" else 1.0
    activation, valence, dominance = (strength * number for number in place)
    recording = Recording(speech / row["file"], row["corpus"], row["speaker"], None, (0.0, 0.0, 0.0))
    return Labelled(recording, {} if tone is None else {tone: 1.0}, (activation, valence, dominance))


def read_spoken(indexes: Iterable[Path]) -> list[Labelled]:
    """The recordings of indexes of `training/focus/speaking.py`; of each delivery the first that is told of."""
    found: dict[str, Labelled] = {}
    for index in indexes:
        for row in map(json.loads, index.read_text(encoding="utf-8").splitlines()):
            found.setdefault(row["id"], _spoken(index.parent / row["path"], row))
    return list(found.values())


def _spoken(path: Path, row: Mapping[str, Any]) -> Labelled:
    place, tones = WRITTEN_TONES[row["tone"]]
    added = (row["loudness"] * number for number in OF_LOUDNESS)
    activation, valence, dominance = (number + more for number, more in zip(place, added, strict=True))
    recording = Recording(path, SYNTHETIC, row["voice"], None, (0.0, 0.0, 0.0))
    return Labelled(recording, tones, (activation, valence, dominance))


@dataclass(frozen=True, slots=True, eq=False)
class Taught:
    """Recordings as the model sees them, one row for each and each condition: `samples` has their memberships in the
    tones (rows, 7) in the order of `Tone`, `dimensions` (rows, 3)."""

    samples: Samples
    dimensions: FloatArray

    def where(self, chosen: NDArray[np.bool_]) -> "Taught":
        """The chosen rows."""
        return Taught(self.samples.where(chosen), self.dimensions[chosen])

    def with_features(self, features: FloatArray) -> "Taught":
        """The same rows, described otherwise."""
        return replace(self, samples=replace(self.samples, features=features))


def taught(labelled: Sequence[Labelled], features: Mapping[str, FloatArray]) -> Taught:
    """The recordings under one condition after another, with their features (recordings, features) under each."""
    count = len(features)
    memberships = np.array([[each.tones.get(tone, 0.0) for tone in Tone] for each in labelled])
    samples = Samples(
        features=np.concatenate(list(features.values())),
        memberships=np.tile(memberships, (count, 1)),
        levels=np.tile([_level(each.tones) for each in labelled], count),
        corpora=np.tile([each.recording.corpus for each in labelled], count),
        speakers=np.tile([f"{each.recording.corpus}/{each.recording.speaker}" for each in labelled], count),
        conditions=np.repeat(list(features), len(labelled)),
    )
    return Taught(samples, np.tile([each.dimensions for each in labelled], (count, 1)))


def joined(one: Taught, other: Taught) -> Taught:
    """The rows of both."""
    columns = ((getattr(one.samples, each.name), getattr(other.samples, each.name)) for each in fields(Samples))
    samples = Samples(*(np.concatenate(pair) for pair in columns))
    return Taught(samples, np.concatenate([one.dimensions, other.dimensions]))


def _level(tones: Mapping[Tone, float]) -> int:
    """The place of the only tone; -1 where there is none, or a mixture."""
    return list(Tone).index(next(iter(tones))) if len(tones) == 1 else -1
