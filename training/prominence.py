"""Fits the weights of `understudy.acoustic.stress` to the stress that listeners heard in syllables.

    python -m training.prominence [--speech FOLDER]

Data: EmoDB (`training/emodb.py`), six speakers of German. A syllable counts as stressed from a mean judgement of
`STRESSED` on. `python -m benchmarks.acoustic.prominence` fits with the same function, speaker by speaker held out.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from sklearn.linear_model import LogisticRegression

from training.emodb import read_judged
from understudy.acoustic.stage import contours_of
from understudy.acoustic.stress import cues, log_odds
from understudy.model import FloatArray

SPEECH = Path(__file__).resolve().parents[2] / "shared" / "data" / "speech"
STRESSED = 1.5


def main() -> None:
    """Prints the weights, the bias and the prominence above which as many syllables lie as listeners hear stressed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH, help="folder of emodb and emodb_labels")
    sentences = read_judged(parser.parse_args().speech)
    seen = [cues(sentence.syllables, contours_of(sentence.audio)) for sentence in sentences]
    stresses = [sentence.stresses for sentence in sentences]
    weights, bias = fit(seen, stresses)
    scores = np.concatenate([log_odds(each, weights, bias) for each in seen])
    print("weights", *(f"{weight:.2f}" for weight in weights), "bias", f"{bias:.2f}")
    print("threshold", f"{threshold(1 / (1 + np.exp(-scores)), np.concatenate(stresses)):.2f}")


def fit(cues_seen: Sequence[FloatArray], stresses: Sequence[Sequence[float]]) -> tuple[FloatArray, float]:
    """The weights of the cues and the bias, from each sentence's cues (syllables × cues) and judgements.

    First the weights, as if every sentence were as lively; then their common scale and the bias for `log_odds`.
    """
    heard = np.concatenate(stresses) >= STRESSED
    direction, _ = regression(np.concatenate(cues_seen), heard)
    relative = np.concatenate([log_odds(each, direction, 0.0) for each in cues_seen])
    scale, bias = regression(relative[:, None], heard)
    return scale[0] ** 2 * direction, bias


def threshold(scores: FloatArray, stresses: FloatArray) -> float:
    """The score above which there are as many syllables as listeners hear stressed."""
    return float(np.quantile(scores, 1 - np.mean(stresses >= STRESSED)))


def regression(measured: FloatArray, heard: NDArray[np.bool_]) -> tuple[FloatArray, float]:
    """Weights and bias of the log odds."""
    model = LogisticRegression(C=10.0, max_iter=5000)
    model.fit(measured, heard)
    return model.coef_[0], float(model.intercept_[0])


if __name__ == "__main__":
    main()
