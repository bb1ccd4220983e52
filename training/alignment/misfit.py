"""Fits the probability that a text differs from what is said, from its aligned phones
(`app/acoustic/alignment/fit.py`).

    python -m training.alignment.misfit [--shared ../shared] [--every N] [--plain FOLDER]

A logistic regression on `evidence` of correct and of other texts (`transcripts.py`); a correct text has the weight of
three wrong ones, because it must not be refused. Prints the accuracy on each half of the material with the weights of
the other half, then the weights fitted to all, which are those in the code (`--every 2`). With `--plain`, also what
`training/affect/plain_speech.py --held-out` has said with voices of espeak-ng. Where nothing is said, any text is a
wrong one. Twenty minutes on one core.
"""

import argparse
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

import numpy as np
from sklearn.linear_model import LogisticRegression

from understudy.acoustic.alignment.aligner import Aligner
from understudy.acoustic.alignment.fit import EVIDENCE, REFUSED, SUSPECT, evidence
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray
from understudy.text.transcript import read_transcript

from .transcripts import OTHERS, OWN, Recording, read_plain, read_recordings, texts_for

ROOT = Path(__file__).resolve().parents[2]
PENALTY = 1.0
RIGHT_COUNTS = 3.0
TEXTS_OF_NOTHING, WORD_S, SILENCE_S, HUM_HZ = 40, 0.4, 0.5, 50.0


@dataclass(frozen=True, slots=True, eq=False)
class Example:
    """What the phones of a text say of it, `half` of the material it is in, and whether it is another text."""

    seen: FloatArray
    half: int
    is_other: bool


def examples_of(aligner: Aligner, recordings: list[Recording]) -> Iterable[Example]:
    """Of each recording with its own text and with others, but for those for which there is no path."""
    for number, recording in enumerate(recordings):
        for kind, text in texts_for(recordings, number):
            if kind in (OWN, *OTHERS):
                decoded = aligner.decode(recording.audio, read_transcript(text))
                if decoded is not None:
                    seen = np.array(evidence(list(chain.from_iterable(decoded.words))))
                    yield Example(seen, recording.half, kind != OWN)


def examples_of_nothing(aligner: Aligner, texts: Sequence[str]) -> Iterable[Example]:
    """Of each text, and of its first two words, with silence, a constant, noise or hum in place of speech."""
    chance = np.random.default_rng(0)
    for number, text in enumerate(texts):
        for half, said in enumerate((text, " ".join(text.split()[:2]))):
            times_s = np.arange(round(SAMPLE_RATE_HZ * (SILENCE_S + WORD_S * len(said.split())))) / SAMPLE_RATE_HZ
            kinds = (0 * times_s, 0 * times_s + 0.1, 0.01 * chance.standard_normal(len(times_s)))
            samples = (*kinds, 0.1 * np.sin(2 * np.pi * HUM_HZ * times_s))[number % (len(kinds) + 1)]
            decoded = aligner.decode(Audio(samples), read_transcript(said))
            if decoded is not None:
                yield Example(np.array(evidence(list(chain.from_iterable(decoded.words)))), half, is_other=True)


def fitted(examples: list[Example]) -> FloatArray:
    """The weights (E,) of the evidence, and after them the bias."""
    seen, is_other = np.array([each.seen for each in examples]), [each.is_other for each in examples]
    middle, spread = seen.mean(axis=0), seen.std(axis=0)
    regression = LogisticRegression(C=PENALTY, class_weight={False: RIGHT_COUNTS, True: 1.0}, max_iter=1000)
    regression.fit((seen - middle) / spread, is_other)
    weights = regression.coef_[0] / spread
    return np.append(weights, regression.intercept_[0] - weights @ middle)


def print_halves(examples: list[Example]) -> None:
    """How each half fares by the weights of the other."""
    own: list[float] = []
    others: list[float] = []
    for half in (0, 1):
        weights = fitted([each for each in examples if each.half != half])
        for each in examples:
            if each.half == half:
                (others if each.is_other else own).append(float(weights[:-1] @ each.seen + weights[-1]))
    right, wrong = np.array(own), np.array(others)
    print(f"own text, {len(own)}: above {REFUSED} {(right > REFUSED).sum()}, above {SUSPECT} {(right > SUSPECT).sum()}")
    print(f"another text, {len(others)}: not above {REFUSED} {(wrong <= REFUSED).sum()}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared")
    parser.add_argument("--every", type=int, default=1, help="only every Nth recording of people and of flite")
    parser.add_argument("--plain", type=Path, help="the folder of plain speech")
    options = parser.parse_args()
    sources = [read_recordings(options.shared)[:: options.every]]
    sources += [read_plain(options.plain, options.shared / "directing")] if options.plain else []
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en", refined=False) as aligner:
        examples = [example for source in sources for example in examples_of(aligner, source)]
        examples += examples_of_nothing(aligner, [each.text for each in sources[-1][:TEXTS_OF_NOTHING]])
    print_halves(examples)
    for name, weight in zip((*EVIDENCE, "bias"), fitted(examples), strict=True):
        print(f"{weight:10.4f}  {name}")


if __name__ == "__main__":
    main()
