"""Whether "um" and "uh" are detected where they are spoken, and nowhere else.

    python -m benchmarks.acoustic.fillers [--sentences N] [--timit FOLDER] [--ravdess FOLDER] [--lines FOLDER]

False: fillers heard in recordings that have none: TIMIT (read), the lines (read), and every sixth clip of RAVDESS
(acted). Found: into each sentence of TIMIT one filler of the speaker's own voice is spliced, between two words drawn at
random: his longest AH or AX, drawn out to a quarter of a second, for "um" with his longest M after it, drawn out
likewise, and a short pause on both sides. It is found when exactly one filler is heard, at that boundary. Word errors
are those of `benchmarks/acoustic/alignment.py`, the time of the splice taken out; without the search for fillers they
would be the decoder's that must put the sound into a word. No recording with real, labelled fillers was at hand.
"""

import argparse
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
import soundfile
import soxr
from librosa import effects

from benchmarks.acoustic.alignment import RAVDESS, RAVDESS_STEP, ROOT, TIMIT, read_acted
from training.alignment.timit import Sentence, read_sentences
from understudy.acoustic.alignment.aligner import Aligner, Alignment
from understudy.errors import InputError
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray
from understudy.text.transcript import read_transcript

LINES = ROOT.parent / "shared" / "data" / "speech" / "lines"
SOUND_S = 0.25
PAUSE_S = 0.12
SHORTEST_SOURCE_S = 0.03
FADE_S = 0.01
NOISE_AMPLITUDE = 1e-4
VOWELS, NASALS = ("ah", "ax"), ("m",)


def main() -> None:
    """Prints both parts."""
    options = _options()
    sentences = read_sentences(options.timit)[0][: options.sentences]
    lines = [_read_line(path) for path in sorted(options.lines.glob("*.flac"))]
    acted = [read_acted(path) for path in sorted(options.ravdess.glob("*.flac"))[::RAVDESS_STEP]]
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en") as aligner:
        print_false("TIMIT", aligner, [(each.audio, each.text) for each in sentences])
        print_false("lines", aligner, lines)
        print_false("RAVDESS", aligner, acted)
        print_found(aligner, sentences)


def print_false(name: str, aligner: Aligner, cases: Sequence[tuple[Audio, str]]) -> None:
    """One row: how many fillers are heard in recordings without any."""
    heard = [_listen(aligner, audio, text) for audio, text in cases]
    wrong = [filler for alignment in heard if alignment for filler in alignment.fillers]
    minutes = sum(audio.duration_s for audio, _ in cases) / 60
    recordings = sum(bool(alignment and alignment.fillers) for alignment in heard)
    print(
        f"{name:10}{len(wrong)} fillers in {len(cases)} recordings without any, {minutes:.1f} min: "
        f"{len(wrong) / minutes:.2f} a minute, in {recordings / len(cases):.1%} of the recordings"
    )


def print_found(aligner: Aligner, sentences: Sequence[Sentence]) -> None:
    """How many of the fillers that were spliced in are heard, and what they do to the words."""
    chance = np.random.default_rng(5)
    outcomes: dict[str, Counter[str]] = {"um": Counter(), "uh": Counter()}
    errors_s: list[float] = []
    for number, sentence in enumerate(sentences):
        kind = ("um", "uh")[number % 2]
        sound = _filler(sentence, with_nasal=kind == "um")
        boundary = int(chance.integers(1, len(sentence.words)))
        if sound is None:
            continue
        at_s = sentence.words[boundary].start_s
        alignment = _listen(aligner, _spliced(sentence.audio, sound, at_s, chance), sentence.text)
        outcomes[kind][_outcome(alignment, at_s, at_s + len(sound) / SAMPLE_RATE_HZ + 2 * PAUSE_S, kind)] += 1
        if alignment:
            errors_s += _word_errors_s(sentence, alignment, boundary, len(sound) / SAMPLE_RATE_HZ + 2 * PAUSE_S)
    for kind, counts in outcomes.items():
        shares = ", ".join(f"{name} {count / counts.total():.1%}" for name, count in counts.most_common())
        print(f"{kind} spliced in {counts.total()} sentences: {shares}")
    print(
        f"words around: within 50 ms {np.mean(np.array(errors_s) <= 0.05):.1%}, mean {np.mean(errors_s) * 1e3:.1f} ms"
    )


def _outcome(alignment: Alignment | None, start_s: float, end_s: float, kind: str) -> str:
    if alignment is None:
        return "refused"
    if not alignment.fillers:
        return "missed"
    (first, *more) = alignment.fillers
    middle_s = (first.interval.start_s + first.interval.end_s) / 2
    if more or not start_s <= middle_s <= end_s:
        return "misplaced"
    return "found" if first.text == kind else "found as the other"


def _word_errors_s(sentence: Sentence, alignment: Alignment, boundary: int, length_s: float) -> Iterable[float]:
    for index, (truth, word) in enumerate(zip(sentence.words, alignment.words, strict=True)):
        if word.interval is not None:
            delay_s = length_s if index >= boundary else 0.0
            yield abs(word.interval.start_s - truth.start_s - delay_s)
            if index != boundary - 1:  # the word before may end with the splice's pause
                yield abs(word.interval.end_s - truth.end_s - delay_s)


def _filler(sentence: Sentence, *, with_nasal: bool) -> FloatArray | None:
    """The sound in the voice of the sentence, drawn out; None where the sentence has no such vowel."""
    vowel = _longest(sentence, VOWELS)
    nasal = _longest(sentence, NASALS) if with_nasal else np.zeros(0)
    if vowel is None or nasal is None:
        return None
    parts = [_drawn_out(vowel), *([_drawn_out(nasal)] if with_nasal else [])]
    return np.concatenate(parts)


def _longest(sentence: Sentence, labels: tuple[str, ...]) -> FloatArray | None:
    intervals = [interval for label, interval in sentence.phones if label in labels]
    longest = max(intervals, key=lambda interval: interval.duration_s, default=None)
    if longest is None or longest.duration_s < SHORTEST_SOURCE_S:
        return None
    first, end = (round(time_s * SAMPLE_RATE_HZ) for time_s in (longest.start_s, longest.end_s))
    return sentence.audio.samples[first:end]


def _drawn_out(sound: FloatArray) -> FloatArray:
    """The sound at `SOUND_S`, its pitch kept, faded in and out."""
    rate = len(sound) / SAMPLE_RATE_HZ / SOUND_S
    drawn: FloatArray = effects.time_stretch(sound, rate=rate, n_fft=256)
    ramp = np.minimum(np.arange(len(drawn)) / (FADE_S * SAMPLE_RATE_HZ), 1.0)
    return drawn * ramp * ramp[::-1]


def _spliced(audio: Audio, sound: FloatArray, at_s: float, chance: np.random.Generator) -> Audio:
    at = round(at_s * SAMPLE_RATE_HZ)
    before, after = chance.standard_normal((2, round(PAUSE_S * SAMPLE_RATE_HZ))) * NOISE_AMPLITUDE
    return Audio(np.concatenate([audio.samples[:at], before, sound, after, audio.samples[at:]]))


def _listen(aligner: Aligner, audio: Audio, text: str) -> Alignment | None:
    try:
        return aligner.listen(audio, read_transcript(text))
    except InputError:
        return None


def _read_line(path: Path) -> tuple[Audio, str]:
    samples, rate_hz = soundfile.read(path, always_2d=True)
    return Audio(soxr.resample(samples[:, 0], rate_hz, SAMPLE_RATE_HZ)), path.with_suffix(".txt").read_text()


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, default=TIMIT)
    parser.add_argument("--ravdess", type=Path, default=RAVDESS)
    parser.add_argument("--lines", type=Path, default=LINES)
    parser.add_argument("--sentences", type=int, default=None, help="only the first N sentences of TIMIT")
    return parser.parse_args()


if __name__ == "__main__":
    main()
