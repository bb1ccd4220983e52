"""Trains the agitation model on every recording and ships it.

    python -m training.agitation --speech ../shared/data/speech --output models/agitation

About a minute on one core. `python -m benchmarks.agitation` tells how well models so trained do on unknown speakers.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

from app.acoustic.agitation import MODEL_FILE, save
from training.agitation.corpus import CORPUS_WEIGHTS, describe, measure, read_recordings
from training.agitation.fuzzy_svm import train


def main(arguments: Sequence[str] | None = None) -> None:
    """Reads, trains, writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, required=True, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--output", type=Path, required=True, help="folder that takes the model")
    options = parser.parse_args(arguments)
    recordings = read_recordings(options.speech, CORPUS_WEIGHTS)
    save(train(describe(recordings, measure(recordings)), CORPUS_WEIGHTS), options.output)
    print(f"{options.output / MODEL_FILE}: trained on {len(recordings)} recordings of {', '.join(CORPUS_WEIGHTS)}")


if __name__ == "__main__":
    main()
