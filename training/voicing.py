"""Fits the weights of `understudy.acoustic.pitch.voicing.WEIGHED` to laryngograph references.

    python -m training.voicing [--fda FOLDER]

Data: the sentences of odd number of the FDA evaluation database (`benchmarks.acoustic.pitch` tells of it and reports
the even ones), clean and with white noise and babble at 20 and 10 dB, and noise without a voice. A clean frame counts
as much as `CLEAN_WEIGHT` others, for most lines are recorded in a studio. The errors it prints are cross-validated,
each sentence judged by weights fitted without it; the last line is fitted to all.
"""

import argparse
from pathlib import Path
from typing import NamedTuple

import numpy as np
from sklearn.linear_model import LogisticRegression

from benchmarks.acoustic.pitch import (
    FDA,
    REFERENCE_SHIFT_S,
    Recording,
    at_references,
    babble,
    read_recording,
    white,
    with_noise,
)
from understudy.acoustic.pitch.tracking import pitch_if_voiced
from understudy.acoustic.pitch.voicing import Voicing, voiced_frames
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray

CLEAN_WEIGHT = 5.0
FOLDS = 5
CHANGE_COSTS = (0.0, 1.0, 2.0, 4.0)
NOISE_ALONE_S = 20.0
NAMES = ("harmonics", "periodicity", "below_loud", "above_quiet", "threshold")


class Example(NamedTuple):
    """The measures of one recording's frames, and the reference they are to agree with."""

    measures: FloatArray
    reference_hz: FloatArray
    weight: float


def main() -> None:
    """Prints the cross-validated errors and the weights."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fda", type=Path, default=FDA, help="folder of .flac and .f0ref files")
    paths = [path for path in sorted(parser.parse_args().fda.glob("*.flac")) if int(path.stem[2:]) % 2]
    examples = _examples([read_recording(path) for path in paths])
    _print_errors(examples)
    print(", ".join(f"{name}={value:.2f}" for name, value in zip(NAMES, _fit(examples), strict=True)))


def _examples(recordings: list[Recording]) -> list[list[Example]]:
    """Of each sentence, its example in every condition, clean first."""
    noises = (white(recordings), babble(recordings, 8), babble(recordings, len(recordings) - 1))
    noisy = [with_noise(recordings, noise, ratio_db) for noise in noises for ratio_db in (20, 10)]
    weights = [CLEAN_WEIGHT] + [1.0] * len(noisy)
    return [
        [_example(recording, weight) for recording, weight in zip(conditions, weights, strict=True)]
        for conditions in zip(recordings, *noisy, strict=True)
    ]


def _example(recording: Recording, weight: float) -> Example:
    return Example(pitch_if_voiced(recording.audio)[1], recording.reference_hz, weight)


def _noise_alone() -> Example:
    noise = np.random.default_rng(1).normal(0, 0.05, round(NOISE_ALONE_S * SAMPLE_RATE_HZ))
    return _example(Recording(Audio(noise), np.zeros(round(NOISE_ALONE_S / REFERENCE_SHIFT_S))), 1.0)


def _print_errors(examples: list[list[Example]]) -> None:
    """The voicing errors of the sentences, each judged by weights fitted without it, by cost of a change."""
    fits = [
        _fit([sentence for index, sentence in enumerate(examples) if index % FOLDS != fold]) for fold in range(FOLDS)
    ]
    for change_cost in CHANGE_COSTS:
        wrong = [
            [_wrong(example, Voicing(*fits[index % FOLDS], change_cost=change_cost)) for example in sentence]
            for index, sentence in enumerate(examples)
        ]
        clean = np.concatenate([sentence[0] for sentence in wrong])
        noisy = np.concatenate([one for sentence in wrong for one in sentence[1:]])
        print(
            f"change_cost {change_cost:g}: {100 * clean.mean():.2f} % wrong clean, {100 * noisy.mean():.2f} % in noise"
        )


def _fit(examples: list[list[Example]]) -> tuple[float, float, float, float, float]:
    """The weights in the order of `Voicing`, and the threshold."""
    flat = [example for sentence in examples for example in sentence] + [_noise_alone()]
    voiced = [example.reference_hz > 0 for example in flat]
    model = LogisticRegression(C=1e4, max_iter=5000)
    model.fit(
        np.concatenate([_at_references(example) for example in flat]),
        np.concatenate(voiced),
        sample_weight=np.concatenate([np.full(len(example.reference_hz), example.weight) for example in flat]),
    )
    harmonics, periodicity, below_loud, above_quiet = (float(weight) for weight in model.coef_[0])
    return harmonics, periodicity, below_loud, above_quiet, -float(model.intercept_[0])


def _at_references(example: Example) -> FloatArray:
    columns = [at_references(column, len(example.reference_hz)) for column in example.measures.T]
    return np.column_stack(columns)


def _wrong(example: Example, voicing: Voicing) -> FloatArray:
    """1 where the decision differs from the reference."""
    found = at_references(voiced_frames(example.measures, voicing).astype(float), len(example.reference_hz))
    wrong: FloatArray = ((found > 0) != (example.reference_hz > 0)).astype(float)
    return wrong


if __name__ == "__main__":
    main()
