"""Trains the boundary model on half of TIMIT and ships it.

    python -m training.alignment --timit ../shared/data/speech/timit --output models/alignment

Kernel ridge regression of labeller's minus decoder's time, seen from where the decoder has each boundary and from a few
places around it, drawn at random: so little data teaches more that way (in five-fold cross-validation within this half,
words within 20 ms rise from 70 to 72 or 73 %, phones from 86 to 87 %). The numbers below were chosen there too; none
matters much. Not worth their while: a second round of moves (worse), supports from the decoder's own places alone, and
the beginnings of the damaged sentences. Half a minute on one core.
"""

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import replace
from difflib import SequenceMatcher
from itertools import pairwise
from pathlib import Path

import numpy as np

from app.acoustic.alignment import Aligner
from app.acoustic.boundaries import (
    FARTHEST_MOVE_S,
    KIND_COLUMNS,
    BoundaryModel,
    boundaries,
    kernel,
    scaled,
    touch,
    views,
)
from app.model import FloatArray, Word
from app.transcript import read_transcript
from training.alignment.timit import Sentence, read_sentences

ROOT = Path(__file__).resolve().parents[2]
KIND_WEIGHT = 0.5
RIDGE = 1.0
JITTER_S = 0.015
COPIES = 4
SEED = 3
WIDEST_ERROR_S = 0.120
"""A boundary farther off than this is another one, missed altogether."""

MOST_DISAGREEMENT_S = 0.020
"""A boundary that two phones share here has two times there when a sound was added or left out; these are not used."""


def main(arguments: Sequence[str] | None = None) -> None:
    """Aligns, trains, writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, required=True, help="folder of TIMIT's .wrd, .phn and .flac files")
    parser.add_argument("--output", type=Path, required=True, help="folder that takes the model")
    options = parser.parse_args(arguments)
    sentences = read_sentences(options.timit)[0][::2]
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en", refined=False) as aligner:
        seen, moves_s = examples(aligner, sentences)
    model = train(seen, moves_s)
    options.output.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(
        options.output / "boundaries.npz",
        supports=model.supports.astype(np.float32),
        weights_s=model.weights_s.astype(np.float32),
        mean=model.mean.astype(np.float32),
        scale=model.scale,
        kind_weight=model.kind_weight,
    )
    print(f"{options.output / 'boundaries.npz'}: {len(moves_s)} boundaries of {len(sentences)} sentences")


def examples(aligner: Aligner, sentences: Sequence[Sentence]) -> tuple[FloatArray, FloatArray]:
    """What is seen of each boundary that has a true time, and how far it should move, seconds."""
    chance = np.random.default_rng(SEED)
    seen, moves_s = [], []
    for sentence in sentences:
        words = aligner.align(sentence.audio, read_transcript(sentence.text, max_characters=10_000))[0]
        truth_s, decoded = np.array(list(true_times_s(sentence, words))), boundaries(words)
        for width_s in (0.0, *[JITTER_S] * COPIES):
            found = [replace(each, time_s=max(each.time_s + chance.normal(0, width_s), 0.0)) for each in decoded]
            errors_s = truth_s - [boundary.time_s for boundary in found]
            usable = np.abs(errors_s) < WIDEST_ERROR_S
            seen.append(views(sentence.audio, found)[usable])
            moves_s.append(errors_s[usable].clip(-FARTHEST_MOVE_S, FARTHEST_MOVE_S))
    return np.vstack(seen), np.concatenate(moves_s)


def train(seen: FloatArray, moves_s: FloatArray) -> BoundaryModel:
    """Kernel ridge regression in closed form."""
    levels = seen[:, KIND_COLUMNS:]
    mean, scale = levels.mean(axis=0), float(1 / (levels.std() * np.sqrt(levels.shape[1])))
    supports = scaled(seen, mean=mean, scale=scale, kind_weight=KIND_WEIGHT)
    weights_s = np.linalg.solve(kernel(supports, supports) + RIDGE * np.eye(len(moves_s)), moves_s)
    return BoundaryModel(supports, weights_s.astype(np.float64), mean, scale, KIND_WEIGHT)


def true_times_s(sentence: Sentence, words: tuple[Word, ...]) -> Iterator[float]:
    """Where the labeller has each of `boundaries(words)`; NaN where he has no such boundary."""
    spans_s = [span for number, word in enumerate(words) for span in _true_spans_s(sentence, number, word)]
    phones = [phone for word in words for phone in word.phones]
    yield spans_s[0][0]
    for (left, right), ((_, end_s), (start_s, _)) in zip(pairwise(phones), pairwise(spans_s), strict=True):
        if not touch(left, right):
            yield end_s
            yield start_s
        elif abs(end_s - start_s) < MOST_DISAGREEMENT_S:
            yield (end_s + start_s) / 2
        else:
            yield np.nan
    yield spans_s[-1][1]


def _true_spans_s(sentence: Sentence, number: int, word: Word) -> list[tuple[float, float]]:
    """Start and end of each phone of a word, as far as the labeller heard the same phones, else NaN."""
    said, truth = sentence.said(number), sentence.words[number]
    starts_s = dict.fromkeys(range(len(word.phones)), np.nan)
    ends_s = dict(starts_s)
    edges_s = [*(start_s for _, start_s in said), truth.end_s]
    matcher = SequenceMatcher(
        None, [phone.label for phone in word.phones], [label for label, _ in said], autojunk=False
    )
    for kind, first, last, said_first, said_last in matcher.get_opcodes():
        if kind == "equal" or (kind == "replace" and last - first == said_last - said_first):
            for ours, theirs in zip(range(first, last), range(said_first, said_last), strict=True):
                starts_s[ours], ends_s[ours] = edges_s[theirs], edges_s[theirs + 1]
    starts_s[0], ends_s[len(word.phones) - 1] = truth.start_s, truth.end_s
    return [(starts_s[number], ends_s[number]) for number in starts_s]


if __name__ == "__main__":
    main()
