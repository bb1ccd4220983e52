"""Trains the agitation models, one for each feature set, on every recording and ships them.

    python -m training.agitation --speech ../shared/data/speech --output models/agitation

Two minutes on one core. `python -m benchmarks.agitation` tells how well models so trained do on unknown speakers.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

from app.acoustic.agitation import save
from app.acoustic.utterance_features import FEATURE_SETS
from training.agitation.corpus import CORPUS_WEIGHTS, describe, measure, read_recordings
from training.agitation.fuzzy_svm import train


def main(arguments: Sequence[str] | None = None) -> None:
    """Reads, trains, writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, required=True, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--output", type=Path, required=True, help="folder that takes the models")
    options = parser.parse_args(arguments)
    recordings = read_recordings(options.speech, CORPUS_WEIGHTS)
    for feature_set, features in measure(recordings, list(FEATURE_SETS)).items():
        path = save(train(describe(recordings, features), feature_set, CORPUS_WEIGHTS), options.output)
        print(f"{path}: trained on {len(recordings)} recordings of {', '.join(CORPUS_WEIGHTS)}")


if __name__ == "__main__":
    main()
