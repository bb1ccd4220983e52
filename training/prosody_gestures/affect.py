"""Fits the estimator of activation, valence and dominance to acted emotions, and prints its accuracy.

    python -m training.prosody_gestures.affect [--speech FOLDER] [--output models/prosody_gestures] [--each N]

Each recording of RAVDESS, EmoDB and nEMO stands for what people say its emotion is like (after Russell & Mehrabian
1977, "Evidence for a three-factor theory of emotions", rounded), four fifths of it where RAVDESS' intensity is normal.
Ridge regression on the last frame's measures of N recordings of each corpus, drawn by chance; each corpus weighs the
same. Printed are correlations on speakers left out, in fours.
"""

import argparse
import csv
import random
from collections.abc import Sequence
from pathlib import Path
from types import MappingProxyType

import numpy as np

from understudy.acoustic.pitch.tracking import track_f0
from understudy.acoustic.signal.decoding import decode
from understudy.acoustic.signal.spectrum import energy_db
from understudy.acoustic.stage import audio_limits
from understudy.model import FloatArray
from understudy.motion_models.affect import DIMENSIONS, LinearAffectModel, measures
from understudy.prosody_gestures.prosody import raw_frames
from understudy.settings import Settings

FILE = "affect.npz"
CORPORA = ("ravdess", "emodb", "nemo")
RIDGE = 3.0
NORMAL = 0.8

LIKE = MappingProxyType(
    {
        "neutral": (0.0, 0.0, 0.0),
        "calm": (-0.4, 0.5, 0.1),
        "happiness": (0.5, 0.8, 0.5),
        "sadness": (-0.3, -0.6, -0.3),
        "anger": (0.6, -0.5, 0.3),
        "fear": (0.6, -0.6, -0.4),
        "disgust": (0.4, -0.6, 0.1),
        "surprise": (0.7, 0.4, -0.1),
        "boredom": (-0.6, -0.6, -0.3),
    }
)
"""Activation, valence and dominance."""


def measured(speech: Path, each: int) -> tuple[list[dict[str, str]], FloatArray]:
    """`each` recordings of each corpus, and their measures (recordings × measures)."""
    with (speech / "labels.csv").open(newline="") as file:
        every = [row for row in csv.DictReader(file) if row["emotion"] in LIKE]
    rows = [
        row
        for corpus in CORPORA
        for row in random.Random(corpus).sample([row for row in every if row["corpus"] == corpus], each)
    ]
    limits, found = audio_limits(Settings()), []
    for row in rows:
        audio, _ = decode((speech / row["file"]).read_bytes(), limits)
        found.append(measures(raw_frames(energy_db(audio), track_f0(audio)))[-1])
    return rows, np.stack(found)


def fitted(inputs: FloatArray, wanted: FloatArray, weights: FloatArray) -> LinearAffectModel:
    """Ridge regression of what is wanted (recordings × 3)."""
    shares = weights / weights.sum()
    mean = shares @ inputs
    scale = np.sqrt(shares @ (inputs - mean) ** 2) + 1e-9
    intercepts = shares @ wanted
    standard = (inputs - mean) / scale
    within = standard.T @ (standard * shares[:, None]) + RIDGE / len(inputs) * np.eye(inputs.shape[1])
    return LinearAffectModel(
        mean, scale, np.linalg.solve(within, standard.T @ (shares[:, None] * (wanted - intercepts))), intercepts
    )


def _wanted(rows: Sequence[dict[str, str]]) -> FloatArray:
    strengths = [NORMAL if row["intensity"] == "normal" else 1.0 for row in rows]
    wanted: FloatArray = np.array([LIKE[row["emotion"]] for row in rows]) * np.array(strengths)[:, None]
    return wanted


def _weights(rows: Sequence[dict[str, str]]) -> FloatArray:
    corpora = [row["corpus"] for row in rows]
    return np.array([1 / corpora.count(corpus) for corpus in corpora])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=Path("../shared/data/speech"))
    parser.add_argument("--output", type=Path, default=Path("models/prosody_gestures"))
    parser.add_argument("--each", type=int, default=240)
    arguments = parser.parse_args()
    rows, inputs = measured(arguments.speech, arguments.each)
    wanted, weights = _wanted(rows), _weights(rows)
    speakers = [f"{row['corpus']}-{row['speaker']}" for row in rows]
    folds = np.array([sorted(set(speakers)).index(speaker) % 4 for speaker in speakers])
    estimated = np.empty_like(wanted)
    for fold in range(4):
        model = fitted(inputs[folds != fold], wanted[folds != fold], weights[folds != fold])
        estimated[folds == fold] = (inputs[folds == fold] - model.mean) / model.scale @ model.weights
    for corpus in CORPORA:
        own = np.array([row["corpus"] == corpus for row in rows])
        alike = [np.corrcoef(estimated[own, place], wanted[own, place])[0, 1] for place in range(3)]
        print(
            corpus, *(f"{name} {value:.2f}" for name, value in zip(DIMENSIONS, alike, strict=True)), f"of {own.sum()}"
        )
    model, path = fitted(inputs, wanted, weights), arguments.output / FILE
    unfinished = path.with_suffix(".unfinished")
    with unfinished.open("wb") as file:
        np.savez_compressed(
            file, mean=model.mean, scale=model.scale, weights=model.weights, intercepts=model.intercepts
        )
    unfinished.rename(path)


if __name__ == "__main__":
    main()
