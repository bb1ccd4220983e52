"""What is known of words of which only the times are: where their sounds lie, and which are stressed.

    python -m benchmarks.live.words [--timit FOLDER]

On TIMIT's sentences, each speaker left out of the durations that spread his words:

- boundaries between sounds of a word, off by so much on average, and frames of .01 s in the right sound: with the
  sounds spread evenly, and by how long they usually last.
- emphasis of words beside that of the recording with its sounds where humans placed them: correlation, and F of which
  words are emphasised; before anything is heard, and when all is; chance is as many words drawn at random.
"""

import argparse
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from training.alignment.timit import Sentence, read_sentences
from training.live.phone_durations import mean_durations, spoken
from understudy.acoustic.models import AcousticModels
from understudy.acoustic.pacing.phone_durations import PhoneDurations
from understudy.acoustic.stage import contours_of, measure_stress
from understudy.live.ear import RecentVoice
from understudy.model import EMPHASISED, Contours, Interval, Phone, Word
from understudy.settings import Settings

FRAME_S = 0.01


@dataclass(slots=True)
class Found:
    """By how the sounds are spread: boundaries off in seconds, frames right; by that and what is heard, pairs of
    emphasis: the recording's and ours."""

    off_s: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    right: dict[str, list[bool]] = field(default_factory=lambda: defaultdict(list))
    emphasis: dict[str, list[tuple[float, float]]] = field(default_factory=lambda: defaultdict(list))


def placed(sentence: Sentence) -> list[Word]:
    """The words with their sounds where humans placed them."""
    return [
        Word(number, str(number), sentence.words[number], tuple(map(_phone, labels, edges_s, edges_s[1:])))
        for number, labels, edges_s in spoken(sentence)
    ]


def _phone(label: str, begin_s: float, end_s: float) -> Phone:
    return Phone(label, Interval(begin_s, end_s))


def edges_of(word: Word) -> np.ndarray:
    """Where its sounds begin, and the last ends."""
    return np.array([phone.interval.start_s for phone in word.phones] + [word.phones[-1].interval.end_s])


def compare(found: Found, acoustic: AcousticModels, sentence: Sentence, durations: PhoneDurations) -> None:
    words, contours = placed(sentence), contours_of(sentence.audio)
    whole = emphases(acoustic, words, contours)
    unheard = RecentVoice().during(0.0, sentence.audio.duration_s)
    even = PhoneDurations(dict.fromkeys(durations.usual_s, 1.0))
    for name, spreading in (("evenly", even), ("by durations", durations)):
        spread = [spreading.spread(word, word.interval) for word in words if word.interval]
        for one, other in zip(words, spread, strict=True):
            theirs, ours = edges_of(one), edges_of(other)
            frames = np.arange(theirs[0], theirs[-1], FRAME_S)
            found.off_s[name] += np.abs(ours - theirs)[1:-1].tolist()
            found.right[name] += list(
                np.searchsorted(theirs, frames, "right") == np.searchsorted(ours, frames, "right")
            )
        for heard, known in (("nothing heard", unheard), ("all heard", contours)):
            found.emphasis[f"{name}, {heard}"] += zip(whole, emphases(acoustic, spread, known), strict=True)


def emphases(acoustic: AcousticModels, words: list[Word], contours: Contours) -> list[float]:
    return [word.emphasis or 0.0 for word in measure_stress(acoustic, tuple(words), contours)[0]]


def report(found: Found) -> None:
    for name, off_s in found.off_s.items():
        print(
            f"{name:30s} {1000 * np.mean(off_s):.1f} ms off, {100 * np.mean(found.right[name]):.1f} % of frames right"
        )
    for name, pairs in found.emphasis.items():
        theirs, ours = np.array(pairs).T
        one, other = theirs > EMPHASISED, ours > EMPHASISED
        f = 2 * (one & other).sum() / (one.sum() + other.sum())
        chance = 2 * one.mean() * other.mean() / (one.mean() + other.mean())
        print(f"{name:30s} emphasis r {np.corrcoef(theirs, ours)[0, 1]:.3f}, F {f:.3f} (chance {chance:.3f})")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, default=Path("../shared/data/speech/timit"))
    arguments = parser.parse_args()
    folders = sorted(path for path in arguments.timit.iterdir() if path.is_dir())
    sentences = {folder: read_sentences(folder)[0] for folder in folders}
    acoustic, found = AcousticModels.load(Settings()), Found()
    for speaker in folders:
        others = (each for folder in folders if folder != speaker for each in sentences[folder])
        durations = PhoneDurations(mean_durations(others))
        for sentence in sentences[speaker]:
            compare(found, acoustic, sentence, durations)
    report(found)


if __name__ == "__main__":
    main()
