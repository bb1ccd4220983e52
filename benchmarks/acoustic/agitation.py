"""Accuracy of agitation on speakers that were not trained on (paper §3.1.4).

    python -m benchmarks.acoustic.agitation [--speech FOLDER] [--features FILE] [--ablation | --free]

Speakers are never on both sides: RAVDESS in four folds of four actors (two women, two men), EmoDB and nEMO one speaker
at a time. Each fold chooses its recipe and trains anew, as `training/agitation/` does, on all other speakers of all
corpora: the choice is made by leaving some of those out in turn, so that the tested speakers have no part in it.
"Chosen on these folds" is the other way, once for comparison: one recipe, chosen on all speakers.
Figures: balanced accuracy (mean recall of the three levels, chance .333), the share of all recordings whose low was
taken for high or high for low, and the mean negative log of the membership given to the right level (1.10 when nothing
is known). Recordings whose level is open are trained on and referred to, never tested on. "White noise" is 20 dB under
the tested recording's mean power, "telephone" its band alone. "Against n of his" gives the model a reference of n other
recordings of the tested speaker, drawn anew for each.

Then come the recipes that the folds chose, and how far memberships can be trusted: of the recordings whose strongest
membership lies in a bin, its mean and the share that were right.

--free measures the models that are trained on free data alone (`training.agitation --free`): on its speakers, one left
out at a time, and on the other corpora, of which they have heard nothing.

--ablation departs from the recipe one choice at a time, without reference. Features are measured by all processors in
some fifteen minutes; --features keeps them in a file. Training takes one processor an hour.
"""

import argparse
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from training.agitation.choosing import choose
from training.agitation.conditions import TEST_CONDITIONS, TRAINING_CONDITIONS
from training.agitation.corpus import CORPORA, FREE_CORPORA, Samples, describe, read_audio, read_recordings
from training.agitation.fuzzy_svm import Recipe, train
from training.agitation.measuring import measured
from understudy.acoustic.agitation.classifier import AgitationModel
from understudy.acoustic.agitation.utterance_features import FEATURE_SETS, paper_features
from understudy.acoustic.signal.spectrum import mel_db, mfcc
from understudy.acoustic.stage import contours_of
from understudy.model import Audio, Contours, FloatArray
from understudy.model.voice.signal import SpeakerReference

SPEECH = Path(__file__).resolve().parents[3] / "shared" / "data" / "speech"
RAVDESS_FOLDS = 4
UNHEARD = "mbrola"
"""Synthetic voices at three vocal efforts: measured, never trained on."""

ALL_OTHERS = 10_000
NO_REFERENCE: Mapping[str, int] = {"": 0}
REFERENCES: Mapping[str, int] = {
    **NO_REFERENCE,
    ", against 1 of his": 1,
    ", against 3 of his": 3,
    ", against 10 of his": 10,
    ", against all others of his": ALL_OTHERS,
}
PAPER_CHANGES: Mapping[str, Callable[[Audio, Contours], Contours]] = {
    "as shipped": lambda _audio, contours: contours,
    "all frames (the paper's)": lambda _audio, contours: replace(contours, energy_db=0 * contours.energy_db),
    "frames within 30 dB": lambda _audio, contours: replace(contours, energy_db=contours.energy_db * 20 / 30),
    "bands down to 80 dB": lambda _audio, contours: replace(contours, mfcc=mfcc(contours.mel_db, range_db=80.0)),
    "bands from 0 Hz": lambda audio, contours: replace(contours, mfcc=mfcc(mel_db(audio, min_hz=0.0))),
}
"""Frames within 20 dB of the loudest count, so that scaling the energy moves the border."""

BINS = (0.0, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)

COPIES: Mapping[str, tuple[str, ...]] = {"degraded copies": ("degraded",), "other voices": ("deeper", "higher")}
"""Kinds of copies that are trained on besides."""

GROUPS: Mapping[str, slice] = {
    "range of MFCC": slice(12, 24),
    "motion of MFCC": slice(24, 36),
    "energy range": slice(36, 37),
    "pauses and syllables": slice(37, 39),
    "pitch and voicing": slice(39, 44),
    "peak slope": slice(44, 45),
    "harmonicity and cepstral peak": slice(45, 47),
    "tilt": slice(47, 49),
    "spectral slopes": slice(49, 61),
    "spectral flux": slice(61, 63),
    "course of pitch": slice(63, 70),
    "what goes with loudness": slice(70, 81),
    "quartiles of MFCC": slice(81, 105),
    "spectrum": slice(105, 115),
    "steps": slice(115, 120),
    "decline": slice(120, 125),
    "flux and what it goes with": slice(125, 134),
    "time near the loudest": slice(134, 137),
    "steadiness": slice(137, 139),
    "bands that go with loudness": slice(139, 149),
}
"""Where groups of features stand in the full set."""


@dataclass(frozen=True, slots=True, eq=False)
class Judged:
    """Tested recordings: their level (index in `Level`) and the memberships given, one row each."""

    levels: NDArray[np.int64]
    memberships: FloatArray

    def figures(self) -> str:
        guessed = self.memberships.argmax(axis=1)
        recalls = [np.mean(guessed[self.levels == level] == level) for level in range(3)]
        opposite = np.mean(np.abs(guessed - self.levels) == 2)
        surprise = -np.mean(np.log(self.memberships[np.arange(len(self.levels)), self.levels]))
        return f"{np.mean(recalls):.3f}   {100 * opposite:5.1f} %   {surprise:.2f}"

    def reliability(self) -> Iterator[str]:
        """A line for each bin of the strongest membership."""
        strongest = self.memberships.max(axis=1)
        right = self.memberships.argmax(axis=1) == self.levels
        for low, high in pairwise(BINS):
            inside = (strongest > low) & (strongest <= high)
            if inside.any():
                yield f"{inside.sum():5d} {strongest[inside].mean():.2f} {right[inside].mean():.2f}"


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--features", type=Path, help="file that keeps the features from one time to the next (.npz)")
    parser.add_argument("--ablation", action="store_true", help="depart from the recipe one choice at a time")
    parser.add_argument("--free", action="store_true", help="the models of free data")
    options = parser.parse_args()
    if options.free:
        of_free_data(options.speech, options.features)
        return
    recordings = read_recordings(options.speech, (*CORPORA, UNHEARD))
    features = measured(recordings, {**TRAINING_CONDITIONS, **TEST_CONDITIONS}, options.features)
    samples = {name: describe(recordings, features[name]) for name in FEATURE_SETS}
    print(f"{'tested on':<58} balanced low↔high  -log")
    if options.ablation:
        ablation(samples["full"])
        ablation_of_frames(options.speech)
    else:
        for feature_set in FEATURE_SETS:
            by_corpus(feature_set, samples[feature_set])


def by_corpus(feature_set: str, samples: Samples) -> None:
    """Each corpus tested clean, against the speaker, in noise and by telephone, with recipes chosen within folds."""
    nested = Trainer(feature_set)
    for corpus in (*CORPORA, UNHEARD):
        name = f"{feature_set}, {corpus}"
        judged = _report(name, nested, samples, corpus, references=REFERENCES)
        for condition in TEST_CONDITIONS:
            _report(f"{name}, {condition}", nested, samples, corpus, condition=condition)
        if corpus in ("ravdess", "emodb"):
            print("reliability: recordings, membership, right", *judged.reliability(), sep="\n    ", flush=True)
    for recipe, count in Counter(str(recipe) for recipe in nested.recipes.values()).most_common():
        print(f"chosen {count} times: {recipe}", flush=True)
    others = Trainer(feature_set, [corpus for corpus in CORPORA if corpus != "ravdess"])
    _report(f"{feature_set}, ravdess, trained without it", others, samples, "ravdess")
    fixed = nested.always_by(choose(trainable(samples), feature_set))
    for corpus in CORPORA:
        _report(f"{feature_set}, {corpus}, chosen on these folds", fixed, samples, corpus)


def of_free_data(speech: Path, kept: Path | None) -> None:
    """Models of free data, tested on their own corpora and on the others, all clean."""
    print(f"{'tested on':<58} balanced low↔high  -log")
    taught = read_recordings(speech, FREE_CORPORA)
    features = measured(taught, TRAINING_CONDITIONS, kept)
    trainers = {name: Trainer(name, FREE_CORPORA) for name in FEATURE_SETS}
    for name, trainer in trainers.items():
        for corpus in FREE_CORPORA:
            _report(f"{name}, free, {corpus}", trainer, describe(taught, features[name]), corpus, references=REFERENCES)
    for corpus in CORPORA:
        if corpus not in FREE_CORPORA:
            heard = read_recordings(speech, (corpus,))
            clean = measured(heard, {"clean": TRAINING_CONDITIONS["clean"]}, None)
            for name, trainer in trainers.items():
                every = joined(describe(taught, features[name]), describe(heard, clean[name]))
                _report(f"{name}, free, {corpus}", trainer, every, corpus, references=REFERENCES)


def joined(first: Samples, second: Samples) -> Samples:
    """The rows of both."""
    names = [column.name for column in fields(Samples)]
    return Samples(*(np.concatenate([getattr(first, name), getattr(second, name)]) for name in names))


def ablation(samples: Samples) -> None:
    """`full` on RAVDESS and EmoDB without one kind of copies or one group of features."""
    recipe = choose(trainable(samples), "full")
    every = Trainer("full", recipe=recipe)
    for corpus in ("ravdess", "emodb"):
        for condition in ("clean", *TEST_CONDITIONS):
            _report(f"full, {corpus}, {condition}", every, samples, corpus, condition=condition)
            for name, copies in COPIES.items():
                kept = samples.where(~np.isin(samples.conditions, copies))
                without = Trainer("full", recipe=recipe)
                _report(f"full, {corpus}, {condition}, without {name}", without, kept, corpus, condition=condition)
        for name, columns in GROUPS.items():
            narrow = replace(samples, features=np.delete(samples.features, columns, axis=1))
            without = Trainer("full", recipe=replace(recipe, features=narrow.features.shape[1]))
            _report(f"full, {corpus}, without {name}", without, narrow, corpus)


def ablation_of_frames(speech: Path) -> None:
    """`paper` on RAVDESS with other frames and bands, trained and tested on the recordings as they are."""
    recordings = read_recordings(speech, CORPORA)
    heard = [(audio, contours_of(audio)) for audio in (read_audio(recording.path) for recording in recordings)]
    for name, change in PAPER_CHANGES.items():
        rows = np.array([paper_features(change(audio, contours)) for audio, contours in heard])
        samples = describe(recordings, {"clean": rows})
        fixed = Trainer("paper", recipe=choose(samples, "paper"))
        _report(f"paper, ravdess, {name}", fixed, samples, "ravdess")


@dataclass(frozen=True, slots=True)
class Trainer:
    """Chooses, unless it is given a recipe, and trains as what is shipped, on these corpora; the same speakers teach
    once."""

    feature_set: str
    corpora: Collection[str] = CORPORA
    recipe: Recipe | None = None
    models: dict[frozenset[str], AgitationModel] = field(default_factory=dict)
    recipes: dict[frozenset[str], Recipe] = field(default_factory=dict)

    def __call__(self, samples: Samples) -> AgitationModel:
        samples = trainable(samples, self.corpora)
        speakers = frozenset(samples.speakers.tolist())
        if speakers not in self.models:
            self.recipes[speakers] = self.recipe or choose(samples, self.feature_set)
            self.models[speakers] = train(samples, self.feature_set, self.recipes[speakers])
        return self.models[speakers]

    def always_by(self, recipe: Recipe) -> "Trainer":
        """A trainer by this recipe, which need not train anew where the same was chosen."""
        alike = {speakers: model for speakers, model in self.models.items() if self.recipes[speakers] == recipe}
        return replace(self, recipe=recipe, models=alike, recipes={})


def trainable(samples: Samples, corpora: Collection[str] = CORPORA) -> Samples:
    """What may be trained on."""
    conditions = np.isin(samples.conditions, list(TRAINING_CONDITIONS))
    return samples.where(np.isin(samples.corpora, list(corpora)) & conditions)


def cross_validate(
    samples: Samples, corpus: str, training: Trainer, *, condition: str = "clean", reference_size: int = 0
) -> Judged:
    """The recordings of `corpus` under a condition, judged by models trained on other speakers."""
    levels: list[int] = []
    memberships: list[tuple[float, float, float]] = []
    tested = (samples.corpora == corpus) & (samples.levels >= 0) & (samples.conditions == condition)
    for held_out in _folds(samples, corpus):
        model = training(samples.where(~held_out))
        completed = replace(samples, features=model.typical.completed(samples.features))
        for row in np.flatnonzero(held_out & tested):
            agitation = model.judge(completed.features[row], _reference(completed, int(row), reference_size, model))
            levels.append(int(samples.levels[row]))
            memberships.append((agitation.low, agitation.medium, agitation.high))
    return Judged(np.array(levels), np.array(memberships))


def _folds(samples: Samples, corpus: str) -> Iterator[NDArray[np.bool_]]:
    """Masks of the rows held out together. RAVDESS numbers men odd and women even, so pairs keep both in a fold."""
    speakers = np.unique(samples.speakers[samples.corpora == corpus])
    count = RAVDESS_FOLDS if corpus == "ravdess" else len(speakers)
    pairs = np.arange(len(speakers)) // 2 if corpus == "ravdess" else np.arange(len(speakers))
    for fold in range(count):
        yield np.isin(samples.speakers, speakers[pairs % count == fold])


def _reference(samples: Samples, row: int, size: int, model: AgitationModel) -> SpeakerReference | None:
    """The statistics of `size` recordings, drawn from the others of the row's speaker and condition."""
    if size == 0:
        return None
    same = (samples.speakers == samples.speakers[row]) & (samples.conditions == samples.conditions[row])
    (others,) = np.nonzero(same)
    others = np.random.default_rng(row).permutation(others[others != row])[:size]
    return SpeakerReference.of(model.feature_set, samples.features[others])


def _report(
    name: str,
    training: Trainer,
    samples: Samples,
    corpus: str,
    *,
    references: Mapping[str, int] = NO_REFERENCE,
    condition: str = "clean",
) -> Judged:
    """Prints a line for each reference; what was judged against the first comes back."""
    judged = []
    for told, size in references.items():
        judged.append(cross_validate(samples, corpus, training, condition=condition, reference_size=size))
        print(f"{name + told:<58} {judged[-1].figures()}", flush=True)
    return judged[0]


if __name__ == "__main__":
    main()
