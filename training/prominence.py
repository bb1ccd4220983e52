"""Fits the weights of `app.acoustic.prominence` to the stress that listeners heard in syllables.

    python -m training.prominence [--speech FOLDER]

Data: EmoDB (`training/emodb.py`), ten speakers of German. A syllable counts as stressed from a mean judgement of
`STRESSED` on. `python -m benchmarks.prominence` fits with the same function, speaker by speaker held out.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from sklearn.linear_model import LogisticRegression

from app.acoustic.pitch import track_f0
from app.acoustic.prominence import cues
from app.model import FloatArray
from training.emodb import read_judged

SPEECH = Path(__file__).resolve().parents[2] / "shared" / "data" / "speech"
STRESSED = 1.5


def main() -> None:
    """Prints the weights and the bias."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH, help="folder of emodb and emodb_labels")
    sentences = read_judged(parser.parse_args().speech)
    seen = [cues(sentence.syllables, track_f0(sentence.audio)) for sentence in sentences]
    weights, bias = fit(seen, [sentence.stresses for sentence in sentences])
    print("weights", *(f"{weight:.2f}" for weight in weights), "bias", f"{bias:.2f}")


def fit(cues_seen: Sequence[FloatArray], stresses: Sequence[Sequence[float]]) -> tuple[FloatArray, float]:
    """The weights of the cues and the bias, from each sentence's cues (syllables × cues) and judgements."""
    model = LogisticRegression(C=10.0, max_iter=5000)
    model.fit(np.concatenate(cues_seen), np.concatenate(stresses) >= STRESSED)
    return model.coef_[0], float(model.intercept_[0])


if __name__ == "__main__":
    main()
