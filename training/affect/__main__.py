"""Trains the models of affect on every recording and ships them.

    python -m training.affect --speech ../shared/data/speech --output models/affect [--features FILE]

`all.npz` is taught by all corpora, `free.npz` by those alone whose licence permits every use. `python -m
benchmarks.acoustic.affect` tells how well models so trained do on unknown speakers and corpora.
"""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

from training.affect.corpus import read_labelled, taught
from training.affect.experts import AffectRecipe, train_affect
from training.agitation.conditions import TRAINING_CONDITIONS
from training.agitation.measuring import measured
from understudy.acoustic.affect.affect_model import FEATURE_SET

CORPORA = ("ravdess", "emodb", "nemo")
TAUGHT_BY: Mapping[str, tuple[str, ...]] = {"all": CORPORA, "free": ("emodb",)}


def main(arguments: Sequence[str] | None = None) -> None:
    """Reads, trains, writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, required=True, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--output", type=Path, required=True, help="folder that takes the models")
    parser.add_argument("--features", type=Path, help="file that keeps the features from one time to the next (.npz)")
    options = parser.parse_args(arguments)
    labelled = read_labelled(options.speech, CORPORA)
    features = measured([each.recording for each in labelled], TRAINING_CONDITIONS, options.features)
    material = taught(labelled, features[FEATURE_SET])
    for name, corpora in TAUGHT_BY.items():
        path = options.output / f"{name}.npz"
        train_affect(material, corpora, AffectRecipe()).save(path)
        print(f"{path}: taught by {', '.join(corpora)}", flush=True)


if __name__ == "__main__":
    main()
