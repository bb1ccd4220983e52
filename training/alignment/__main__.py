"""Trains the boundary model on half of TIMIT and ships it.

    python -m training.alignment --timit ../shared/data/speech/timit --output models/alignment

Kernel ridge regression of labeller's minus decoder's time, on the sentences as they are and degraded (and on the
beginnings of those whose files are damaged, which are in neither half), each boundary seen from where the decoder has
it and from a place nearby, drawn at random. There are more such examples than the model has supports, which are some
of them (the subset of regressors). What is seen is reduced to its principal components, weighing less the farther it is
from the boundary. The numbers below were chosen by cross-validation within this half, leaving out sentences and leaving
out speakers; `models/alignment/README.md` tells what else was tried. A minute on one core.
"""

import argparse
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from itertools import pairwise
from pathlib import Path

import numpy as np

from training.alignment.degradations import by_telephone, equalised, in_a_room, in_noise
from training.alignment.timit import Sentence, read_beginnings, read_sentences
from understudy.acoustic.alignment.aligner import Aligner
from understudy.acoustic.alignment.boundaries import (
    BANDS,
    CONTEXT_STEPS,
    BoundaryArrays,
    BoundaryModel,
    BoundaryView,
    Levels,
    Points,
    are_adjacent,
    boundaries,
    kernel,
    levels_around,
    mel_levels,
)
from understudy.errors import InputError
from understudy.model import Audio, FloatArray, Word
from understudy.text.transcript import read_transcript

ROOT = Path(__file__).resolve().parents[2]
KIND_WEIGHT, GAP_WEIGHT, SPECTRUM_WEIGHT = 0.7, 0.3, 0.75
TAPER_STEPS = 7
"""Standard deviation of the weight of the spectrum around a boundary."""

COMPONENTS = 60
SUPPORTS = 4000
RIDGE = 0.5
ROUNDING = 0.03
"""Of the sums over all examples, in single precision."""

OUTLYING_S = 0.006
ROUNDS = 3
JITTER_S, SILENCE_JITTER_S = 0.012, 0.030
"""Standard deviations; against silence the decoder errs more."""

COPIES = 1
SEED = 3
WIDEST_ERROR_S = 0.150
"""A boundary farther off than this is another one, missed altogether."""

WIDEST_MOVE_S = 0.060
"""Moves are taught no farther, lest the few wide ones outweigh the many narrow."""

MOST_DISAGREEMENT_S = 0.020
"""A boundary that two phones share here has two times there when a sound was added or left out; these are not used."""

Degradation = Callable[[FloatArray, np.random.Generator], FloatArray]
DEGRADATIONS: tuple[Degradation | None, ...] = (None, in_noise, in_a_room, by_telephone, equalised)


@dataclass(frozen=True, slots=True, eq=False)
class Examples:
    """Boundaries of one recording that have a true time, and how far each should move, seconds."""

    levels: Levels
    places: BoundaryArrays
    moves_s: FloatArray


def main(arguments: Sequence[str] | None = None) -> None:
    """Aligns, trains, writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, required=True, help="folder of TIMIT's .wrd, .phn and .flac files")
    parser.add_argument("--output", type=Path, required=True, help="folder that takes the model")
    options = parser.parse_args(arguments)
    sentences = [*read_sentences(options.timit)[0][::2], *read_beginnings(options.timit)]
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en", refined=False) as aligner:
        chance = np.random.default_rng(SEED)
        examples = [
            seen for each in sentences for how in DEGRADATIONS for seen in examples_of(aligner, each, how, chance)
        ]
    model = train(examples)
    options.output.mkdir(parents=True, exist_ok=True)
    write(model, options.output / "boundaries.npz")
    count = sum(len(each.moves_s) for each in examples)
    print(f"{options.output / 'boundaries.npz'}: {count} boundaries of {len(sentences)} sentences, degraded and moved")


def write(model: BoundaryModel, path: Path) -> None:
    """As `BoundaryModel.load` reads it, at half precision where that is enough."""
    np.savez_compressed(
        path,
        mean=model.view.mean.astype(np.float16),
        basis=model.view.basis.astype(np.float16),
        kind_weight=model.view.kind_weight,
        gap_weight=model.view.gap_weight,
        supports=model.supports.astype(np.float16),
        weights_s=model.weights_s.astype(np.float32),
    )


def examples_of(
    aligner: Aligner, sentence: Sentence, degrade: Degradation | None, chance: np.random.Generator
) -> Iterator[Examples]:
    """The boundaries of a sentence where the decoder has them, and from places around these; none when it is so
    degraded that the aligner refuses it."""
    samples = sentence.audio.samples
    audio = Audio(degrade(samples, chance)) if degrade else sentence.audio
    try:
        words = aligner.align(audio, read_transcript(sentence.text))[0]
    except InputError:
        return
    truth_s, places = np.array(list(true_times_s(sentence, words))), BoundaryArrays.of(boundaries(words))
    levels = mel_levels(audio.samples)
    jitter_s = np.where(places.at_silence, SILENCE_JITTER_S, JITTER_S)
    for width_s in (np.zeros(len(truth_s)), *[jitter_s] * COPIES):
        seen = places.shifted(np.maximum(chance.normal(0.0, width_s), -places.times_s))
        moves_s = truth_s - seen.times_s
        usable = np.abs(moves_s) < WIDEST_ERROR_S
        used = BoundaryArrays(seen.times_s[usable], seen.gaps_s[usable], seen.kinds[usable])
        yield Examples(levels, used, moves_s[usable].clip(-WIDEST_MOVE_S, WIDEST_MOVE_S))


def train(examples: Sequence[Examples]) -> BoundaryModel:
    """The subset of regressors: weights w of the supports s that minimise Σ h(K(x, s) w − y) + ridge × w' K(s, s) w,
    where h is Huber's: the square of an error up to `OUTLYING_S`, linear beyond. By weights of the examples, afresh in
    each of `ROUNDS`."""
    view = view_of(np.vstack([levels_around(each.levels, each.places.times_s) for each in examples]))
    points = np.vstack([view.points(each.levels, each.places) for each in examples])
    moves_s = np.concatenate([each.moves_s for each in examples])
    chosen = np.random.default_rng(SEED).permutation(len(points))[:SUPPORTS]
    supports = points[np.sort(chosen)]
    seen = kernel(points, supports)
    penalty = RIDGE * kernel(supports, supports).astype(float) + ROUNDING * np.eye(len(supports))
    trust = np.ones(len(points), np.float32)
    for _ in range(ROUNDS):
        trusted = seen * trust[:, None]
        weights_s = np.linalg.solve(trusted.T @ seen + penalty, trusted.T @ moves_s).astype(np.float32)
        trust = np.float32(OUTLYING_S) / np.maximum(np.abs(seen @ weights_s - moves_s), np.float32(OUTLYING_S))
    return BoundaryModel(view, supports, weights_s)


def view_of(seen: Points) -> BoundaryView:
    """The principal components of levels around boundaries, tapered, and scaled so that all weigh what they should."""
    mean = seen.mean(axis=0)
    taper = np.exp(-0.5 * (np.arange(-CONTEXT_STEPS, CONTEXT_STEPS + 1) / TAPER_STEPS) ** 2).repeat(BANDS)
    tapered = (seen - mean) * taper
    _, directions = np.linalg.eigh((tapered.T @ tapered).astype(float))
    scale = SPECTRUM_WEIGHT / np.sqrt(np.mean(np.sum(tapered**2, axis=1)))
    basis = scale * taper[:, None] * directions[:, ::-1][:, :COMPONENTS]
    return BoundaryView(mean, basis.astype(np.float32), KIND_WEIGHT, GAP_WEIGHT)


def true_times_s(sentence: Sentence, words: tuple[Word, ...]) -> Iterator[float]:
    """Where the labeller has each of `boundaries(words)`; NaN where he has no such boundary."""
    spans_s = [span for number, word in enumerate(words) for span in _true_spans_s(sentence, number, word)]
    phones = [phone for word in words for phone in word.phones]
    yield spans_s[0][0]
    for (left, right), ((_, end_s), (start_s, _)) in zip(pairwise(phones), pairwise(spans_s), strict=True):
        if not are_adjacent(left, right):
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
