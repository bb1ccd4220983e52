"""How long each speech sound usually lasts, from the words that humans placed in TIMIT, and ships it.

    python -m training.live.phone_durations [--timit FOLDER] [--output lexicon/phone_durations.yaml]

Only means are kept. `benchmarks.live.words` measures what they are for, on speakers left out.
"""

import argparse
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from training.alignment.timit import Sentence, read_sentences

HEAD = """\
# How long each speech sound lasts on average, in seconds: where only the times of words are known, their sounds share
# them in proportion (docs/live.md). Made by `python -m training.live.phone_durations` from TIMIT's hand-placed phones.

"""
DECIMALS = 3


def spoken(sentence: Sentence) -> list[tuple[int, list[str], list[float]]]:
    """Each word's number, its sounds and the moments between which they lie, one more."""
    found = []
    for number, word in enumerate(sentence.words):
        if said := sentence.said(number):
            found.append((number, [label for label, _ in said], [*(start_s for _, start_s in said), word.end_s]))
    return found


def mean_durations(sentences: Iterable[Sentence]) -> dict[str, float]:
    """Seconds by sound."""
    durations_s = defaultdict[str, list[float]](list)
    for sentence in sentences:
        for _, labels, edges_s in spoken(sentence):
            for label, duration_s in zip(labels, np.diff(edges_s).tolist(), strict=True):
                durations_s[label].append(duration_s)
    return {label: round(float(np.mean(each)), DECIMALS) for label, each in sorted(durations_s.items())}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, default=Path("../shared/data/speech/timit"))
    parser.add_argument("--output", type=Path, default=Path("lexicon/phone_durations.yaml"))
    arguments = parser.parse_args()
    means = mean_durations(read_sentences(arguments.timit)[0])
    unfinished = arguments.output.with_suffix(".unfinished")
    unfinished.write_text(HEAD + "".join(f"{label}: {mean}\n" for label, mean in means.items()), encoding="utf-8")
    unfinished.rename(arguments.output)


if __name__ == "__main__":
    main()
