"""Fits how big and fast movements are to the voice, by what a director asked of spoken deliveries.

    python -m training.affect.manner --deliveries FILE.jsonl --recordings FOLDER

FILE.jsonl has deliveries with their `manner` (size and speed, -1, 0 or 1), FOLDER their recordings, ID.VOICE.flac; of
each delivery one voice is heard, the same for all deliveries of a line. Ridge regressions; printed are Kendall's tau
with what was asked on lines held out in fives, then the weights for `app/acoustic/affect/manner.py`.
"""

import argparse
import json
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.stats import kendalltau

from understudy.acoustic.affect.manner import MEASURES, measures
from understudy.acoustic.agitation.utterance_features import full_features
from understudy.acoustic.models import AcousticModels
from understudy.acoustic.stage import analyze_signal
from understudy.model import FloatArray
from understudy.settings import Settings

RIDGE = 5.0
FOLDS = 5
KINDS = ("size", "speed")


@dataclass(frozen=True, slots=True)
class Heard:
    """The measures of a delivery, what was asked of it, and the line that it is one of."""

    measured: tuple[float, ...]
    asked: tuple[float, float]
    base: str


def heard(deliveries: Path, recordings: Path) -> Iterator[Heard]:
    """The deliveries that have a recording and a manner."""
    acoustic = AcousticModels.load(Settings())
    for row in map(json.loads, deliveries.read_text(encoding="utf-8").splitlines()):
        found = sorted(recordings.glob(f"{row['id']}.*.flac"))
        if not found or "manner" not in row:
            continue
        analysis = analyze_signal(acoustic, found[zlib.crc32(row["base"].encode()) % len(found)].read_bytes())
        features = full_features(analysis.contours, analysis.quality)
        size, speed = (float(row["manner"].get(kind, 0)) for kind in KINDS)
        yield Heard(measures(features, analysis.agitation, analysis.affect), (size, speed), row["base"])


def fitted(inputs: FloatArray, asked: FloatArray) -> FloatArray:
    """The weights (measures, 2) on inputs of mean 0, for what was asked (deliveries, 2)."""
    scale = inputs.std(axis=0)
    points = inputs / scale
    within = points.T @ points + RIDGE * np.eye(points.shape[1])
    weights: FloatArray = np.linalg.solve(within, points.T @ (asked - asked.mean(axis=0))) / scale[:, None]
    return weights


def held_out(inputs: FloatArray, asked: FloatArray, bases: Sequence[str]) -> FloatArray:
    """What is told of each delivery by the weights of other lines."""
    told = np.zeros_like(asked)
    folds = np.array([zlib.crc32(base.encode()) % FOLDS for base in bases])
    for fold in range(FOLDS):
        told[folds == fold] = inputs[folds == fold] @ fitted(inputs[folds != fold], asked[folds != fold])
    return told


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--deliveries", type=Path, required=True)
    parser.add_argument("--recordings", type=Path, required=True)
    options = parser.parse_args()
    examples = list(heard(options.deliveries, options.recordings))
    measured, asked = np.array([each.measured for each in examples]), np.array([each.asked for each in examples])
    usual = measured.mean(axis=0)
    told = held_out(measured - usual, asked, [each.base for each in examples])
    for place, kind in enumerate(KINDS):
        print(f"{kind}: tau {kendalltau(told[:, place], asked[:, place])[0]:.3f} of {len(examples)}")
    weights = fitted(measured - usual, asked)
    for name, row in (("USUAL", usual), ("SIZE", weights[:, 0]), ("SPEED", weights[:, 1])):
        print(name, tuple(round(float(number), 3) for number in row))
    print(*MEASURES, sep=", ")


if __name__ == "__main__":
    main()
