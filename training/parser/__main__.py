"""Trains the speech parser and ships it.

    python -m training.parser --treebanks ../shared/data/treebanks --output models/parser

About 35 minutes on one core (set OMP_NUM_THREADS=1). The corpora and checkpoints stay in --work (a temporary folder
unless given). Only the train and dev files are read; `python -m benchmarks.syntax.parser` reports on the test files.
"""

import argparse
import tempfile
from pathlib import Path

from spacy.cli.train import train

from training.parser.augmentation import write_corpora
from training.parser.shipping import ship

CONFIG = Path(__file__).with_name("config.cfg")


def main() -> None:
    """Prepares the corpora, trains, and writes the pipeline without what the program does not need."""
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--treebanks", type=Path, required=True, help="folder of the CoNLL-U files")
    arguments.add_argument("--output", type=Path, required=True, help="folder that takes the pipeline")
    arguments.add_argument("--work", type=Path, help="folder for corpora and checkpoints, kept")
    options = arguments.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        work = options.work or Path(temporary)
        work.mkdir(parents=True, exist_ok=True)
        write_corpora(options.treebanks, work)
        paths = {"paths.train": str(work / "train.spacy"), "paths.dev": str(work / "dev.spacy")}
        train(CONFIG, work / "checkpoints", overrides=paths)
        ship(work / "checkpoints" / "model-best", options.output)


if __name__ == "__main__":
    main()
