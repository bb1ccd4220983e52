"""How well agitation is told from voices that were not trained on (paper §3.1.4).

    python -m benchmarks.agitation [--speech FOLDER] [--ablation]

Speakers are never on both sides: RAVDESS in four folds of four actors (two women, two men), EmoDB and nEMO one speaker
at a time. Each fold trains anew, with the recipe of `training/agitation/`, on all other speakers of all corpora.
Figures: balanced accuracy (mean recall of the three levels, chance .333), the share of all recordings whose low was
taken for high or high for low, and the mean negative log of the membership given to the right level (1.10 when nothing
is known). Recordings whose level is open are trained on and referred to, never tested on. "Noise" adds white noise 20
dB under the tested recording's mean power. "Against n of his" gives the model a reference of n other recordings of the
tested speaker, drawn anew for each. Kernel, corpus weights and features were chosen on these same folds; neighbouring
choices differ by .02, which is also the standard error.

Last comes how far memberships can be trusted: of the recordings whose strongest membership lies in a bin, its mean and
the share that were right.

--ablation departs from the recipe one choice at a time, without reference.
"""

import argparse
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from sklearn.linear_model import LogisticRegression

from app.acoustic.agitation import AgitationModel, FuzzySvm
from app.acoustic.speaker import SpeakerReference
from app.acoustic.spectrum import mfcc
from app.acoustic.utterance_features import full_features, paper_features
from app.model import Audio, Contours, FloatArray
from training.agitation.corpus import CORPUS_WEIGHTS, Samples, describe, listen, measure, read_audio, read_recordings
from training.agitation.fuzzy_svm import GAMMA, balanced_weights, held_out_values, train

SPEECH = Path(__file__).resolve().parents[2] / "shared" / "data" / "speech"
RAVDESS_FOLDS = 4
NOISE_DB = -20.0
UNHEARD = {"mbrola": 1.0}
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
    "bands down to 80 dB": lambda audio, contours: replace(contours, mfcc=mfcc(audio, range_db=80.0)),
    "bands from 0 Hz": lambda audio, contours: replace(contours, mfcc=mfcc(audio, min_hz=0.0)),
}
"""Frames within 20 dB of the loudest count, so that scaling the energy moves the border."""

BINS = (0.0, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)

GROUPS: Mapping[str, slice] = {
    "range of MFCC": slice(12, 24),
    "motion of MFCC": slice(24, 36),
    "energy range": slice(36, 37),
    "pauses and syllables": slice(37, 39),
    "pitch and voicing": slice(39, 44),
    "peak slope": slice(44, 45),
    "harmonicity and cepstral peak": slice(45, 47),
    "tilt": slice(47, 49),
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
    parser.add_argument("--ablation", action="store_true", help="depart from the recipe one choice at a time")
    options = parser.parse_args()
    print(f"{'tested on':<58} balanced low↔high  -log")
    if options.ablation:
        ablation(options.speech)
    else:
        by_corpus(options.speech)


def by_corpus(speech: Path) -> None:
    """Each corpus tested with either feature set, clean, in noise and against the speaker."""
    recordings = read_recordings(speech, {**CORPUS_WEIGHTS, **UNHEARD})
    clean = measure(recordings, list(GAMMA))
    noisy = measure(recordings, list(GAMMA), in_noise)
    for feature_set in GAMMA:
        samples = describe(recordings, clean[feature_set])
        in_the_noise = replace(samples, features=noisy[feature_set])
        recipe = Recipe(feature_set)
        for corpus in (*CORPUS_WEIGHTS, *UNHEARD):
            judged = _report(f"{feature_set}, {corpus}", recipe, samples, corpus, references=REFERENCES)
            _report(f"{feature_set}, {corpus} in noise", recipe, samples, corpus, tested=in_the_noise)
            if corpus in ("ravdess", "emodb"):
                print("reliability: recordings, membership, right", *judged.reliability(), sep="\n    ", flush=True)
        others = {name: weight for name, weight in CORPUS_WEIGHTS.items() if name != "ravdess"}
        _report(f"{feature_set}, ravdess, trained without it", Recipe(feature_set, others), samples, "ravdess")


def ablation(speech: Path) -> None:
    """RAVDESS and EmoDB with one choice of the recipe changed at a time."""
    recordings = read_recordings(speech, CORPUS_WEIGHTS)
    heard = [(audio, listen(audio)) for audio in (read_audio(recording.path) for recording in recordings)]
    for name, change in PAPER_CHANGES.items():
        rows = np.array([paper_features(audio, change(audio, contours)) for audio, contours in heard])
        _report(f"paper, ravdess, {name}", Recipe("paper"), describe(recordings, rows), "ravdess")
    samples = describe(recordings, np.array([full_features(*both) for both in heard]))
    for corpus in ("ravdess", "emodb"):
        _report(f"full, {corpus}", Recipe("full"), samples, corpus)
        _report(f"full, {corpus}, separate logistic functions", train_separately, samples, corpus)
        for name, columns in GROUPS.items():
            fewer = replace(samples, features=np.delete(samples.features, columns, axis=1))
            _report(f"full, {corpus}, without {name}", Recipe("full"), fewer, corpus)


@dataclass(frozen=True, slots=True)
class Recipe:
    """Training as shipped, on the corpora that have a weight; the same speakers teach once."""

    feature_set: str
    weights: Mapping[str, float] = field(default_factory=lambda: CORPUS_WEIGHTS)
    models: dict[frozenset[str], AgitationModel] = field(default_factory=dict)

    def __call__(self, samples: Samples) -> AgitationModel:
        usable = samples.where(np.isin(samples.corpora, list(self.weights)))
        speakers = frozenset(usable.speakers.tolist())
        if speakers not in self.models:
            self.models[speakers] = train(usable, self.feature_set, self.weights)
        return self.models[speakers]


class SeparatelyCalibrated(FuzzySvm):
    """Memberships from a logistic function for each machine, scaled to sum to 1."""

    def memberships(self, features: FloatArray) -> FloatArray:
        values = self.decision_values(features)
        evidence = np.array([m.slope * value + m.offset for m, value in zip(self.machines, values, strict=True)])
        raw = 1 / (1 + np.exp(-evidence))
        memberships: FloatArray = raw / raw.sum()
        return memberships


def train_separately(samples: Samples) -> AgitationModel:
    """The full recipe, but each machine's logistic function is fitted by itself."""
    model, weights = train(samples, "full", CORPUS_WEIGHTS), balanced_weights(samples, CORPUS_WEIGHTS)
    svm = model.unknown_speaker
    points = (model.typical.completed(samples.features) - svm.mean) / svm.scale
    values = held_out_values(points, weights, samples.speakers, svm.gamma)
    machines = []
    for index, machine in enumerate(svm.machines):
        inside, column = weights[:, index], np.tile(values[:, index], 2)[:, np.newaxis]
        both = np.concatenate([inside, weights.sum(axis=1) - inside])
        logistic = LogisticRegression(C=1e3).fit(column, np.repeat([1, 0], len(inside)), both)
        machines.append(replace(machine, slope=float(logistic.coef_[0, 0]), offset=float(logistic.intercept_[0])))
    return replace(model, unknown_speaker=SeparatelyCalibrated(svm.mean, svm.scale, svm.gamma, tuple(machines)))


def in_noise(audio: Audio) -> Audio:
    """The recording in white noise, the same noise each time."""
    power = np.mean(audio.samples**2) * 10 ** (NOISE_DB / 10)
    return Audio(audio.samples + np.random.default_rng(0).normal(0, np.sqrt(power), len(audio.samples)))


def cross_validate(
    samples: Samples,
    corpus: str,
    training: Callable[[Samples], AgitationModel],
    *,
    tested: Samples | None = None,
    reference_size: int = 0,
) -> Judged:
    """The recordings of `corpus`, as they sound in `tested`, judged by models trained on other speakers."""
    tested = tested or samples
    levels: list[int] = []
    memberships: list[tuple[float, float, float]] = []
    for held_out in _folds(samples, corpus):
        model = training(samples.where(~held_out))
        completed = replace(tested, features=model.typical.completed(tested.features))
        for row in np.flatnonzero(held_out & (tested.levels >= 0)):
            agitation = model.judge(completed.features[row], _reference(completed, int(row), reference_size, model))
            levels.append(int(tested.levels[row]))
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
    """The statistics of `size` recordings, drawn from the others of the row's speaker."""
    if size == 0:
        return None
    (others,) = np.nonzero(samples.speakers == samples.speakers[row])
    others = np.random.default_rng(row).permutation(others[others != row])[:size]
    return SpeakerReference.of(model.feature_set, samples.features[others])


def _report(
    name: str,
    training: Callable[[Samples], AgitationModel],
    samples: Samples,
    corpus: str,
    *,
    references: Mapping[str, int] = NO_REFERENCE,
    tested: Samples | None = None,
) -> Judged:
    """Prints a line for each reference; what was judged against the first comes back."""
    judged = []
    for told, size in references.items():
        judged.append(cross_validate(samples, corpus, training, tested=tested, reference_size=size))
        print(f"{name + told:<58} {judged[-1].figures()}", flush=True)
    return judged[0]


if __name__ == "__main__":
    main()
