"""TIMIT's sentences with the words and phones that humans placed (`.wrd`, `.phn`: start and end in samples at 16 kHz).

Some files of ../shared have lost bytes, after which every sample is noise at full scale; TIMIT itself is never that
loud. They are left out, but their beginnings may serve in training. Of the others every second, from the first, is for
training, the rest for testing.
"""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import soundfile

from understudy.model import SAMPLE_RATE_HZ, Audio, Interval

FULL_SCALE = 0.95
BEFORE_DAMAGE_S = 0.100
"""A word that ends so much before the noise is whole."""

FEWEST_WORDS = 2
FOLDED = {
    "ax": "ah",
    "ax-h": "ah",
    "ix": "ih",
    "axr": "er",
    "ux": "uw",
    "hv": "hh",
    "nx": "n",
    "em": "m",
    "en": "n",
    "eng": "ng",
    "el": "l",
    "dx": "t",
}
CLOSURES = frozenset({"bcl", "dcl", "gcl", "pcl", "tcl", "kcl", "epi", "pau", "h#", "q"})


@dataclass(frozen=True, slots=True)
class Sentence:
    """A recording with its text, and the words and phones that a human placed."""

    audio: Audio
    text: str
    words: tuple[Interval, ...]
    phones: tuple[tuple[str, Interval], ...]

    def said(self, word: int) -> list[tuple[str, float]]:
        """The phones of a word, folded to the decoder's labels, with their starts; a closure counts to its stop."""
        opened = []
        closed_s = None
        for label, interval in self.phones:
            if not self.words[word].start_s <= interval.start_s < self.words[word].end_s:
                continue
            if label in CLOSURES:
                closed_s = interval.start_s if closed_s is None else closed_s
                continue
            opened.append((FOLDED.get(label, label).upper(), interval.start_s if closed_s is None else closed_s))
            closed_s = None
        return opened


def read_sentences(folder: Path) -> tuple[list[Sentence], int]:
    """The undamaged sentences below `folder`, by path, and how many there were with the damaged."""
    everything = [read_sentence(path) for path in sorted(folder.rglob("*.wrd"))]
    return [each for each in everything if np.abs(each.audio.samples).max() < FULL_SCALE], len(everything)


def read_beginnings(folder: Path) -> list[Sentence]:
    """The damaged sentences below `folder`, each up to the end of the last word before the damage."""
    beginnings = [_before_damage(read_sentence(path)) for path in sorted(folder.rglob("*.wrd"))]
    return [each for each in beginnings if each is not None]


def _before_damage(sentence: Sentence) -> Sentence | None:
    """None: it is not damaged, or too little is left."""
    damaged = np.flatnonzero(np.abs(sentence.audio.samples) >= FULL_SCALE)
    if not len(damaged):
        return None
    usable_s = damaged[0] / SAMPLE_RATE_HZ - BEFORE_DAMAGE_S
    words = tuple(word for word in sentence.words if word.end_s < usable_s)
    if len(words) < FEWEST_WORDS:
        return None
    samples = sentence.audio.samples[: round(words[-1].end_s * SAMPLE_RATE_HZ)]
    return replace(sentence, audio=Audio(samples), text=" ".join(sentence.text.split()[: len(words)]), words=words)


def read_sentence(path: Path) -> Sentence:
    """The sentence whose words lie at `path` (.wrd), its other files beside it."""
    samples, rate_hz = soundfile.read(path.with_suffix(".flac"))
    assert rate_hz == SAMPLE_RATE_HZ
    rows = [line.split() for line in path.read_text().splitlines()]
    phones = [line.split() for line in path.with_suffix(".phn").read_text().splitlines()]
    return Sentence(
        Audio(samples),
        " ".join(word for _, _, word in rows),
        tuple(_interval(start, end) for start, end, _ in rows),
        tuple((label, _interval(start, end)) for start, end, label in phones),
    )


def _interval(start: str, end: str) -> Interval:
    return Interval(int(start) / SAMPLE_RATE_HZ, int(end) / SAMPLE_RATE_HZ)
