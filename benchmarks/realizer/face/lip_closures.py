"""Whether the lips shut when the speaker's did: our closures against those that humans labelled in TIMIT.

    python -m benchmarks.realizer.face.lip_closures [--timit FOLDER] [--rate HZ]

Of the half of TIMIT's sentences that the aligner's boundaries were not trained on (`training.alignment.timit`). TIMIT
has the closures of P and B apart from their bursts (`pcl`, `bcl`), and M, F and V, all of which our lips are to be shut
for. Everything takes part: aligner, visemes, face. A labelled closure is matched with the phone of ours of the same
name that overlaps it; "shut" is the part of it for which our mouth is shut, closing and parting how late ours are
(before is negative). Closures that run into another or into silence, which have no end of their own, are left out of
the times.
"""

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from benchmarks.acoustic.alignment import TIMIT, aligned_words
from benchmarks.realizer.face.lip_closure import SHUT, Closure, lip_closures, lip_opening
from benchmarks.realizer.face.lips import still_body
from training.alignment.timit import Sentence, read_sentences
from understudy.acoustic.alignment.aligner import Aligner
from understudy.behavior.speech import visemes
from understudy.files import resource_folder
from understudy.model import Interval, Schedule, Word
from understudy.realizer.face.blendshapes import face_weights
from understudy.realizer.face.face_tables import FaceTables

CLOSED_IN = {"pcl": "P", "bcl": "B", "m": "M", "em": "M", "f": "F", "v": "V"}
BURSTS = frozenset({"p", "b"})
LONGEST_S = 0.25
"""What is shut for longer is more than one closure, or silence."""


@dataclass(frozen=True, slots=True)
class Compared:
    """A labelled closure and ours: the part of it in which we are shut, and how late we close and part, if that can be
    said."""

    phone: str
    shut: float
    closing_s: float | None
    parting_s: float | None


def labelled(sentence: Sentence) -> Iterator[tuple[str, Interval]]:
    """The closures that a human placed; of P and B those that have a burst."""
    for (label, interval), (following, _) in pairwise(sentence.phones):
        if label in CLOSED_IN and (not label.endswith("cl") or following in BURSTS):
            yield CLOSED_IN[label], interval


def compare(tables: FaceTables, sentence: Sentence, words: tuple[Word, ...], rate_hz: int) -> Iterator[Compared]:
    spoken, _ = visemes(words, sentence.audio.duration_s)
    body, skeleton = still_body(sentence.audio.duration_s, rate_hz)
    shapes = face_weights(tables, Schedule((), sentence.audio.duration_s, words, spoken), body, skeleton, seed=0)
    closures = lip_closures(spoken, shapes, body.times_s)
    phones = [phone for word in words for phone in word.phones]
    for name, interval in labelled(sentence):
        if any(phone.label == name and _overlap_s(phone.interval, interval) > 0 for phone in phones):
            opening = lip_opening(shapes, to_teeth=name in {"F", "V"})
            during = (body.times_s >= interval.start_s) & (body.times_s <= interval.end_s)
            ours = _nearest(closures, interval)
            late = (ours.start_s - interval.start_s, ours.end_s - interval.end_s) if ours else (None, None)
            yield Compared(name, float(np.mean(opening[during] <= SHUT)), *late)


def _nearest(closures: Sequence[Closure], interval: Interval) -> Interval | None:
    """Our closure that overlaps the labelled one most, if it has an end of its own."""
    shut = [closure.closed for closure in closures if closure.closed]
    most = max(shut, key=lambda each: _overlap_s(each, interval), default=None)
    return most if most and most.duration_s < LONGEST_S and _overlap_s(most, interval) > 0 else None


def _overlap_s(one: Interval, other: Interval) -> float:
    return min(one.end_s, other.end_s) - max(one.start_s, other.start_s)


def told(name: str, found: Sequence[Compared]) -> str:
    shares = [each.shut for each in found]
    closing, parting = (
        1000 * np.array([late for each in found if (late := getattr(each, field)) is not None])
        for field in ("closing_s", "parting_s")
    )
    return (
        f"{name:4s}{len(found):4d}: shut for {100 * np.mean(shares):.0f} % of it, at all in "
        f"{100 * np.mean(np.array(shares) > 0):.0f} %; closing {np.median(closing):+.0f} ms, "
        f"|{np.median(np.abs(closing)):.0f}|; parting {np.median(parting):+.0f} ms, |{np.median(np.abs(parting)):.0f}|"
    )


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--timit", type=Path, default=TIMIT)
    arguments.add_argument("--rate", type=int, default=60)
    options = arguments.parse_args()
    tables = FaceTables.load(resource_folder("lexicon") / "face.yaml")
    sentences = read_sentences(options.timit)[0][1::2]
    with Aligner(resource_folder("models"), resource_folder("lexicon") / "en") as aligner:
        heard = [(sentence, aligned_words(aligner, sentence.audio, sentence.text)) for sentence in sentences]
    found = [each for sentence, words in heard for each in compare(tables, sentence, words, options.rate)]
    print(f"{len(sentences)} sentences; medians of lateness, and of its size between bars")
    for name in ("P", "B", "M", "F", "V"):
        print(told(name, [each for each in found if each.phone == name]))
    print(told("all", found))


if __name__ == "__main__":
    main()
