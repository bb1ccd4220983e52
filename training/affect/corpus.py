"""Acted speech with its tones, and what is learnt of activation, valence and dominance from each recording.

`labels.csv` names a file, its corpus, speaker, emotion and intensity. Calm and bored recordings belong to no tone: they
teach the dimensions alone. A recording's dimensions are those that people give its emotion's name (Russell & Mehrabian
1977, rounded), four fifths of them where the intensity is normal.
"""

import csv
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from training.agitation.corpus import Recording, Samples
from understudy.acoustic.affect.dimensions import PLACES
from understudy.model import FloatArray, Tone

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

NORMAL = 0.8
"""The dimensions of a recording of normal intensity, of those of a strong one."""


@dataclass(frozen=True, slots=True)
class Labelled:
    """A recording, its tone (None where it has none of ours) and its dimensions."""

    recording: Recording
    tone: Tone | None
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
    return Labelled(recording, tone, (activation, valence, dominance))


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
    memberships = np.array([[float(each.tone is tone) for tone in Tone] for each in labelled])
    samples = Samples(
        features=np.concatenate(list(features.values())),
        memberships=np.tile(memberships, (count, 1)),
        levels=np.tile([-1 if each.tone is None else list(Tone).index(each.tone) for each in labelled], count),
        corpora=np.tile([each.recording.corpus for each in labelled], count),
        speakers=np.tile([f"{each.recording.corpus}/{each.recording.speaker}" for each in labelled], count),
        conditions=np.repeat(list(features), len(labelled)),
    )
    return Taught(samples, np.tile([each.dimensions for each in labelled], (count, 1)))
