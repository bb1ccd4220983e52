"""How well tones, activation, valence and dominance are told of speakers that were not trained on.

    python -m benchmarks.acoustic.affect --spoken INDEX.jsonl … [--speech FOLDER] [--features FILE] [--corpora NAME...]

Speakers are never on both sides: RAVDESS in four folds of four actors (two women, two men), EmoDB and nEMO one speaker
at a time, synthetic voices one at a time; each fold trains anew, as `training/affect` does. Figures: the balanced
accuracy (mean recall) of the largest share among angry, sad, happy, afraid and neutral, of recordings of those tones
(calm and bored ones are not tested as neutral); the same of the reference machines against ten other recordings of the
speaker; the mean share of the right tone; the share of neutral; correlations of the three dimensions with what the
emotions are rated. "Without it" is trained on the other corpora alone.
"""

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from training.affect.__main__ import CORPORA, acted, spoken
from training.affect.corpus import SYNTHETIC, Taught, joined
from training.affect.experts import AffectRecipe, train_affect
from understudy.acoustic.affect.affect_model import DIMENSIONS, FEATURE_SET, AffectModel
from understudy.model import Affect, Tone
from understudy.model.voice.signal import SpeakerReference

SPEECH = Path(__file__).resolve().parents[3] / "shared" / "data" / "speech"
ALL = (*CORPORA, SYNTHETIC)
TESTED = (Tone.NEUTRAL, Tone.HAPPY, Tone.SAD, Tone.ANGRY, Tone.AFRAID)
RAVDESS_FOLDS = 4
OF_A_SPEAKER = 10


def main() -> None:
    """Prints a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--features", type=Path, help="file that keeps the features from one time to the next (.npz)")
    parser.add_argument("--spoken", type=Path, nargs="+", required=True, help="indexes of synthetic recordings")
    parser.add_argument("--spoken-features", type=Path, help="file that keeps those of synthetic recordings")
    parser.add_argument("--corpora", nargs="+", default=list(ALL), choices=ALL, help="those that are tested")
    options = parser.parse_args()
    people = acted(options.speech, options.features)
    material = joined(people, spoken(options.spoken, options.spoken_features))
    for corpus in options.corpora:
        tested_in_folds(material, corpus)
        others = [name for name in ALL if name != corpus]
        model = train_affect(material, others, AffectRecipe())
        rows = _clean(material, material.samples.corpora == corpus)
        report(f"{corpus}, trained without it", material, rows, [model.affect(f) for f in _features(material, rows)])


def tested_in_folds(material: Taught, corpus: str) -> None:
    """Each recording by the model that has not heard its speaker; without and with a reference."""
    rows: list[int] = []
    heard: list[Affect] = []
    known: list[Affect] = []
    for held_out in folds(material.samples.speakers, material.samples.corpora == corpus):
        model = train_affect(material.where(~held_out), ALL, AffectRecipe())
        tested = _clean(material, held_out)
        rows += tested.tolist()
        heard += [model.affect(features) for features in _features(material, tested)]
        known += [_against_own(model, material, row) for row in tested.tolist()]
    report(corpus, material, np.array(rows), heard)
    report(f"{corpus}, against {OF_A_SPEAKER} of the speaker", material, np.array(rows), known)


def folds(speakers: NDArray[np.str_], tested: NDArray[np.bool_]) -> Iterator[NDArray[np.bool_]]:
    """Masks of the rows held out together. RAVDESS numbers men odd and women even, so pairs keep both in a fold."""
    names = np.unique(speakers[tested])
    is_ravdess = str(names[0]).startswith("ravdess")
    count = RAVDESS_FOLDS if is_ravdess else len(names)
    group = np.arange(len(names)) // 2 if is_ravdess else np.arange(len(names))
    for fold in range(count):
        yield np.isin(speakers, names[group % count == fold])


def report(name: str, material: Taught, rows: NDArray[np.int64], heard: Sequence[Affect]) -> None:
    """Prints a line."""
    levels = material.samples.levels[rows]
    shares = np.array([affect.tones for affect in heard])
    columns = [list(Tone).index(tone) for tone in TESTED]
    guessed = np.array(columns)[shares[:, columns].argmax(axis=1)]
    recalls = [np.mean(guessed[levels == column] == column) for column in columns if (levels == column).any()]
    toned = levels >= 0
    right = shares[toned, levels[toned]].mean()
    told = np.array([[getattr(affect, dimension) for dimension in DIMENSIONS] for affect in heard])
    alike = [np.corrcoef(told[:, place], material.dimensions[rows, place])[0, 1] for place in range(3)]
    each = " ".join(f"{value:.2f}" for value in recalls)
    print(
        f"{name:<44} balanced {np.mean(recalls):.3f} ({each})  right {right:.2f}  neutral {shares[:, 0].mean():.2f}  "
        + "  ".join(f"{dimension} {value:.2f}" for dimension, value in zip(DIMENSIONS, alike, strict=True)),
        flush=True,
    )


def _clean(material: Taught, among: NDArray[np.bool_]) -> NDArray[np.int64]:
    return np.flatnonzero(among & (material.samples.conditions == "clean"))


def _features(material: Taught, rows: NDArray[np.int64]) -> Iterator[NDArray[np.float64]]:
    yield from material.samples.features[rows]


def _against_own(model: AffectModel, material: Taught, row: int) -> Affect:
    """Against other recordings of the row's speaker, drawn by chance."""
    samples = material.samples
    same = (samples.speakers == samples.speakers[row]) & (samples.conditions == samples.conditions[row])
    others = np.flatnonzero(same)
    others = np.random.default_rng(row).permutation(others[others != row])[:OF_A_SPEAKER]
    reference = SpeakerReference.of(FEATURE_SET, model.typical.completed(samples.features[others]))
    return model.affect(samples.features[row], reference)


if __name__ == "__main__":
    main()
