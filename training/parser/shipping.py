"""Writes a trained pipeline to where the program loads it, with a name, and without the paths of its training."""

import shutil
from pathlib import Path

import spacy

META = {
    "name": "understudy_speech",
    "version": "1.0.0",
    "description": "Parts of speech, lemmas and Universal Dependencies of spoken and written English",
    "author": "Understudy",
    "license": "CC BY-SA 4.0",
}


def ship(checkpoint: Path, output: Path) -> None:
    """Writes the pipeline of the folder `checkpoint` to the folder `output`; what else lies there, the card, stays."""
    nlp = spacy.load(checkpoint)
    nlp.meta.update(META)
    nlp.config["paths"] = dict.fromkeys(nlp.config["paths"])
    for part in (*nlp.pipe_names, "tokenizer", "vocab"):
        shutil.rmtree(output / part, ignore_errors=True)
    nlp.to_disk(output)
