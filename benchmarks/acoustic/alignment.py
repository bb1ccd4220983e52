"""Accuracy of word and phone times against hand labels, and whether a wrong text is detected.

    python -m benchmarks.acoustic.alignment [--sentences N] [--timit FOLDER] [--ravdess FOLDER]

Data: TIMIT, as `training/alignment/timit.py` reads it; the boundary model was trained on every second sentence, the
others are the test. Errors are |ours − theirs| of every word's start and end, and of every phone's start where both
have the same folded labels in a word. Texts that must be flagged: the next speaker's sentence, half of the words
missing, and eight words of another sentence appended; false alarms are correct texts flagged, in TIMIT and in every
sixth clip of RAVDESS (acted, from calm to shouting). The speed is processor time, the decoder's process included.
"""

import argparse
import resource
import time
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import soundfile
import soxr

from training.alignment.timit import Sentence, read_sentences
from understudy.acoustic.alignment.aligner import Aligner
from understudy.errors import InputError
from understudy.model import SAMPLE_RATE_HZ, Audio, Word
from understudy.text.transcript import read_transcript

ROOT = Path(__file__).resolve().parents[2]
TIMIT = ROOT.parent / "shared" / "data" / "speech" / "timit"
RAVDESS = TIMIT.with_name("ravdess")
RAVDESS_TEXTS = {"01": "Kids are talking by the door", "02": "Dogs are sitting by the door"}
RAVDESS_STEP = 6
TOLERANCES_S = (0.020, 0.050, 0.100)
FLAGS = {"transcript_suspect", "alignment_low_confidence"}


def main() -> None:
    """Prints the table."""
    options = read_options(__doc__)
    sentences, count = read_sentences(options.timit)
    sentences = sentences[: options.sentences]
    total_s = sum(sentence.audio.duration_s for sentence in sentences)
    print(f"{len(sentences)} of {count} sentences, {total_s:.0f} s")
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en") as aligner:
        began_s = processor_s()
        pairs = [(sentence, aligned_words(aligner, sentence.audio, sentence.text)) for sentence in sentences]
        aligner.close()
        print(f"{'× real time':24}{(processor_s() - began_s) / total_s:.3f}")
        for name, part in {"test half": pairs[1::2], "training half": pairs[::2], "all": pairs}.items():
            print_errors(f"words, {name}", [error for pair in part for error in word_errors(*pair)])
            print_errors(f"phones, {name}", [error for pair in part for error in phone_errors(*pair)])
        print_flags(aligner, sentences)
        acted = [read_acted(path) for path in sorted(options.ravdess.glob("*.flac"))[::RAVDESS_STEP]]
        print_outcomes("correct text, acted", [outcome(aligner, audio, text) for audio, text in acted])


def read_acted(path: Path) -> tuple[Audio, str]:
    """A clip of RAVDESS, whose name tells which of its two sentences is said."""
    samples, rate_hz = soundfile.read(path, always_2d=True)
    return Audio(soxr.resample(samples[:, 0], rate_hz, SAMPLE_RATE_HZ)), RAVDESS_TEXTS[path.stem.split("-")[4]]


def aligned_words(aligner: Aligner, audio: Audio, text: str) -> tuple[Word, ...]:
    """The words in time; none when the text is refused, which then counts as no match at all."""
    try:
        return aligner.align(audio, _words(text))[0]
    except InputError:
        return ()


def word_errors(sentence: Sentence, words: tuple[Word, ...]) -> Iterable[float]:
    """Absolute errors of starts and ends, seconds; a word without a time is wrong by the sentence's length."""
    intervals = [word.interval for word in words] or [None] * len(sentence.words)
    for truth, ours in zip(sentence.words, intervals, strict=True):
        if ours is None:
            yield from (sentence.audio.duration_s,) * 2
        else:
            yield from (abs(ours.start_s - truth.start_s), abs(ours.end_s - truth.end_s))


def phone_errors(sentence: Sentence, words: tuple[Word, ...]) -> Iterable[float]:
    """Absolute errors of phone starts in the words whose phones, folded, are those that were said."""
    for number, word in enumerate(words):
        said = sentence.said(number)
        if [label for label, _ in said] == [phone.label for phone in word.phones]:
            for (_, start_s), phone in zip(said, word.phones, strict=True):
                yield abs(phone.interval.start_s - start_s)


def print_errors(name: str, errors: list[float]) -> None:
    """One row: share within each tolerance, mean, median, how many."""
    values = np.array(errors)
    within = " / ".join(f"{np.mean(values <= tolerance_s):.1%}" for tolerance_s in TOLERANCES_S)
    print(
        f"{name:24}within 20 / 50 / 100 ms {within}, mean {values.mean() * 1e3:.1f} ms, "
        f"median {np.median(values) * 1e3:.1f} ms ({len(values)})"
    )


def print_flags(aligner: Aligner, sentences: list[Sentence]) -> None:
    """How often each kind of wrong text is refused or flagged."""
    others = [*sentences[11:], *sentences[:11]]
    pairs = list(zip(sentences, others, strict=True))
    kinds = {
        "correct text": [(one, one.text) for one in sentences],
        "another sentence": [(one, other.text) for one, other in pairs if one.text != other.text],
        "second half missing": [(one, " ".join(one.text.split()[: len(one.words) // 2])) for one in sentences],
        "eight words too many": [(one, " ".join([one.text, *other.text.split()[:8]])) for one, other in pairs],
    }
    for kind, cases in kinds.items():
        print_outcomes(kind, [outcome(aligner, sentence.audio, text) for sentence, text in cases])


def print_outcomes(kind: str, outcomes: list[str]) -> None:
    """One row: shares refused and warned about, and how many texts."""
    refused, warned = (outcomes.count(name) / max(len(outcomes), 1) for name in ("refused", "warned"))
    print(f"{kind:24}refused {refused:.1%}, warned {warned:.1%} ({len(outcomes)})")


def outcome(aligner: Aligner, audio: Audio, text: str) -> str:
    """ "refused", "warned" or "passed"."""
    try:
        _, notices = aligner.align(audio, _words(text))
    except InputError:
        return "refused"
    return "warned" if FLAGS & {notice.code for notice in notices} else "passed"


def processor_s() -> float:
    """Processor time so far, ours and that of the processes that have ended."""
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + ended.ru_utime + ended.ru_stime


def _words(text: str) -> tuple[Word, ...]:
    return read_transcript(text)


def read_options(description: str | None) -> argparse.Namespace:
    """The folders and how many sentences, from the command line."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, default=TIMIT)
    parser.add_argument("--ravdess", type=Path, default=RAVDESS)
    parser.add_argument("--sentences", type=int, default=None, help="only the first N")
    return parser.parse_args()


if __name__ == "__main__":
    main()
