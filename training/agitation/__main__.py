"""Trains the agitation models, one for each feature set, on every recording and ships them.

    python -m training.agitation --speech ../shared/data/speech --output models/agitation
    python -m training.agitation --speech ../shared/data/speech --free --output models/agitation/free

--free trains on the corpora that may be used for anything alone.

Some fifteen minutes of two processors, nearly all of it measuring the features; --features FILE keeps them. The recipe
is chosen over all speakers as `python -m benchmarks.acoustic.agitation` chooses it within each fold; that tells how
well models so trained do on unknown speakers.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

from training.agitation.choosing import choose
from training.agitation.conditions import TRAINING_CONDITIONS
from training.agitation.corpus import CORPORA, FREE_CORPORA, describe, read_recordings
from training.agitation.fuzzy_svm import train
from training.agitation.measuring import measured
from understudy.acoustic.agitation.classifier import save


def main(arguments: Sequence[str] | None = None) -> None:
    """Reads, chooses, trains, writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, required=True, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--output", type=Path, required=True, help="folder that takes the models")
    parser.add_argument("--features", type=Path, help="file that keeps the features from one time to the next (.npz)")
    parser.add_argument("--free", action="store_true", help="only data that is free for any use")
    options = parser.parse_args(arguments)
    corpora = FREE_CORPORA if options.free else CORPORA
    recordings = read_recordings(options.speech, corpora)
    for feature_set, features in measured(recordings, TRAINING_CONDITIONS, options.features).items():
        samples = describe(recordings, features)
        recipe = choose(samples, feature_set)
        path = save(train(samples, feature_set, recipe), options.output)
        print(f"{path}: trained on {len(recordings)} recordings of {', '.join(corpora)} by {recipe}", flush=True)


if __name__ == "__main__":
    main()
