"""How well agitation is told from voices that were not trained on (paper §3.1.4).

    python -m benchmarks.agitation [--speech FOLDER] [--ablation]

Speakers are never on both sides: RAVDESS in four folds of four actors (two women, two men), EmoDB and nEMO one speaker
at a time. Each fold trains anew, with the recipe of `training/agitation/`, on all other speakers of its training
corpora. Figures: balanced accuracy (mean recall of the three levels, chance .333), the share of all recordings whose
low was taken for high or high for low, and the mean negative log of the membership given to the right level (1.10 when
nothing is known). Recordings whose level is open are trained on, never tested on. "Noise" adds white noise 20 dB under
the tested recording's mean power. Cost and kernel were chosen on these same RAVDESS folds; their neighbours differ by
.02, which is also the standard error.

--ablation departs from the recipe one choice at a time, on RAVDESS.
"""

import argparse
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.acoustic.agitation import voice_features
from app.acoustic.spectrum import energy_db, mfcc
from app.model import Audio, FloatArray
from training.agitation.corpus import CORPUS_WEIGHTS, Samples, describe, hear, measure, read_recordings
from training.agitation.fuzzy_svm import train

Listener = Callable[[Audio], FloatArray]

SPEECH = Path(__file__).resolve().parents[2] / "shared" / "data" / "speech"
RAVDESS_FOLDS = 4
NOISE_DB = -20.0
UNHEARD = {"mbrola": 1.0}
"""Synthetic voices at three vocal efforts: measured, never trained on."""

LISTENERS: Mapping[str, Listener] = {
    "all frames (the paper's)": lambda audio: _features(audio, active_range_db=np.inf),
    "frames within 30 dB": lambda audio: _features(audio, active_range_db=30.0),
    "bands down to 80 dB, from 0 Hz": lambda audio: _features(audio, range_db=80.0, min_hz=0.0),
    "bands down to 80 dB": lambda audio: _features(audio, range_db=80.0),
    "bands from 0 Hz": lambda audio: _features(audio, min_hz=0.0),
}


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


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH, help="folder of labels.csv and the corpora it names")
    parser.add_argument("--ablation", action="store_true", help="depart from the recipe one choice at a time")
    options = parser.parse_args()
    print(f"{'tested on, trained on':<58} balanced low↔high  -log")
    if options.ablation:
        ablation(options.speech)
    else:
        by_corpus(options.speech)


def by_corpus(speech: Path) -> None:
    """Each corpus tested with the shipped recipe and by itself, clean and in noise."""
    recordings = read_recordings(speech, {**CORPUS_WEIGHTS, **UNHEARD})
    clean = describe(recordings, measure(recordings))
    noisy = replace(clean, features=measure(recordings, _in_noise(hear)))
    for corpus in CORPUS_WEIGHTS:
        _report(f"{corpus}, all (as shipped)", cross_validate(clean, clean, corpus, CORPUS_WEIGHTS))
        _report(f"{corpus} in noise, all (as shipped)", cross_validate(clean, noisy, corpus, CORPUS_WEIGHTS))
        _report(f"{corpus}, {corpus} alone", cross_validate(clean, clean, corpus, {corpus: 1.0}))
        others = {name: weight for name, weight in CORPUS_WEIGHTS.items() if name != corpus}
        _report(f"{corpus}, the other corpora", cross_validate(clean, clean, corpus, others))
    for corpus in UNHEARD:
        _report(f"{corpus} (synthetic), all (as shipped)", cross_validate(clean, clean, corpus, CORPUS_WEIGHTS))


def ablation(speech: Path) -> None:
    """RAVDESS with one choice of the recipe changed at a time, clean and in noise."""
    recordings = read_recordings(speech, CORPUS_WEIGHTS)
    for name, listen in {"as shipped": hear, **LISTENERS}.items():
        clean = describe(recordings, measure(recordings, listen))
        noisy = replace(clean, features=measure(recordings, _in_noise(listen)))
        _report(f"ravdess, {name}", cross_validate(clean, clean, "ravdess", CORPUS_WEIGHTS))
        _report(f"ravdess in noise, {name}", cross_validate(clean, noisy, "ravdess", CORPUS_WEIGHTS))
        if listen is hear:
            known = clean.where(clean.levels >= 0)
            _report("ravdess, no shared memberships", cross_validate(known, known, "ravdess", CORPUS_WEIGHTS))
            alike = dict.fromkeys(CORPUS_WEIGHTS, 1.0)
            _report("ravdess, all recordings alike", cross_validate(clean, clean, "ravdess", alike))


def cross_validate(samples: Samples, tested: Samples, corpus: str, corpus_weights: Mapping[str, float]) -> Judged:
    """The recordings of `corpus` in `tested`, judged by models trained on other speakers' rows of `samples`."""
    usable = np.isin(samples.corpora, list(corpus_weights))
    levels: list[int] = []
    memberships: list[Sequence[float]] = []
    for held_out in _folds(samples, corpus):
        model = train(samples.where(usable & ~held_out), corpus_weights)
        unknown = tested.where(held_out & (tested.levels >= 0))
        for features, level in zip(unknown.features, unknown.levels, strict=True):
            agitation = model.judge(features)
            levels.append(int(level))
            memberships.append((agitation.low, agitation.medium, agitation.high))
    return Judged(np.array(levels), np.array(memberships))


def _folds(samples: Samples, corpus: str) -> Iterator[NDArray[np.bool_]]:
    """Masks of the rows held out together. RAVDESS numbers men odd and women even, so pairs keep both in a fold."""
    speakers = np.unique(samples.speakers[samples.corpora == corpus])
    count = RAVDESS_FOLDS if corpus == "ravdess" else len(speakers)
    pairs = np.arange(len(speakers)) // 2 if corpus == "ravdess" else np.arange(len(speakers))
    for fold in range(count):
        yield np.isin(samples.speakers, speakers[pairs % count == fold])


def _features(
    audio: Audio, *, active_range_db: float = 20.0, range_db: float = 50.0, min_hz: float = 80.0
) -> FloatArray:
    coefficients = mfcc(audio, range_db=range_db, min_hz=min_hz)
    return voice_features(coefficients, energy_db(audio), active_range_db=active_range_db)


def _in_noise(listen: Listener) -> Listener:
    """Listens to the recording in white noise, the same noise each time."""

    def listen_in_noise(audio: Audio) -> FloatArray:
        power = np.mean(audio.samples**2) * 10 ** (NOISE_DB / 10)
        return listen(Audio(audio.samples + np.random.default_rng(0).normal(0, np.sqrt(power), len(audio.samples))))

    return listen_in_noise


def _report(name: str, judged: Judged) -> None:
    print(f"{name:<58} {judged.figures()}", flush=True)


if __name__ == "__main__":
    main()
