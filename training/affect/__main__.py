"""Trains the models of affect on every recording and ships them.

    python -m training.affect --speech ../shared/data/speech --spoken INDEX.jsonl … --output models/affect

The indexes are of deliveries and plain lines that synthetic voices said (`training/focus/speaking.py`,
`plain_speech.py`). `all.npz` is taught by all corpora, `free.npz` by those alone whose licence permits every use.
`python -m benchmarks.acoustic.affect` tells how well models so trained do on unknown speakers and corpora.
"""

import argparse
from collections.abc import Mapping, Sequence
from pathlib import Path

from training.affect.corpus import SYNTHETIC, Taught, joined, read_labelled, read_spoken, taught
from training.affect.experts import AffectRecipe, train_affect
from training.agitation.conditions import TRAINING_CONDITIONS
from training.agitation.measuring import measured
from understudy.acoustic.affect.affect_model import FEATURE_SET

CORPORA = ("ravdess", "emodb", "nemo")
"""Those of people."""

TAUGHT_BY: Mapping[str, tuple[str, ...]] = {"all": (*CORPORA, SYNTHETIC), "free": ("emodb", SYNTHETIC)}


CLEAN = "clean"


def main(arguments: Sequence[str] | None = None) -> None:
    """Reads, trains, writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, required=True, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--spoken", type=Path, nargs="+", required=True, help="indexes of synthetic recordings")
    parser.add_argument("--output", type=Path, required=True, help="folder that takes the models")
    parser.add_argument("--features", type=Path, help="file that keeps the features from one time to the next (.npz)")
    parser.add_argument("--spoken-features", type=Path, help="file that keeps those of synthetic recordings")
    options = parser.parse_args(arguments)
    material = joined(acted(options.speech, options.features), spoken(options.spoken, options.spoken_features))
    for name, corpora in TAUGHT_BY.items():
        path = options.output / f"{name}.npz"
        train_affect(material, corpora, AffectRecipe()).save(path)
        print(f"{path}: taught by {', '.join(corpora)}", flush=True)


def acted(speech: Path, kept: Path | None) -> Taught:
    """The recordings of people."""
    labelled = read_labelled(speech, CORPORA)
    features = measured([each.recording for each in labelled], TRAINING_CONDITIONS, kept)
    return taught(labelled, features[FEATURE_SET])


def spoken(indexes: Sequence[Path], kept: Path | None = None) -> Taught:
    """The recordings of synthetic voices, as they are: they have many voices already, and no rooms."""
    labelled = read_spoken(indexes)
    features = measured([each.recording for each in labelled], {CLEAN: TRAINING_CONDITIONS[CLEAN]}, kept)
    return taught(labelled, features[FEATURE_SET])


if __name__ == "__main__":
    main()
