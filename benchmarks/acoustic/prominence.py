"""Agreement of the prominence of syllables with the stress perceived by listeners.

    python -m benchmarks.acoustic.prominence [--speech FOLDER] [--timit FOLDER]

Syllables: EmoDB (`training/emodb.py`), times as labelled. The figure is Spearman's rank correlation with the
listeners' mean judgement, within each sentence, averaged over the sentences. The weighed cues are fitted without the
speaker they are tested on; "as shipped" is fitted to all, and so only says that it is the same. The length expected
of a syllable is the sum of its phones' mean lengths in TIMIT, its phones being read off the German spelling, roughly.

How many syllables are heard and found stressed, and in how many sentences none is, by emotion: weights and threshold
(above which there are as many as are heard) are fitted to the other speakers, once as shipped, once with differences
as they are ("as lively"), not divided by the root of their spread.

Words: TIMIT, read American English, for which no judgements are known. The figure is the chance that, in a sentence, a
content word has a higher value than a function word (.5 knows nothing): accents fall mostly on the former. Words and
phones are those a human placed.
"""

import argparse
import re
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from scipy.stats import mannwhitneyu, spearmanr

from training.alignment.timit import Sentence, read_sentences
from training.emodb import JudgedSentence, read_judged
from training.prominence import SPEECH, STRESSED, fit, regression, threshold
from understudy.acoustic.focus.listeners import Listeners
from understudy.acoustic.stage import contours_of
from understudy.acoustic.stress import PROMINENT, cues, log_odds, prominence, stress, with_listeners
from understudy.files import resource_folder
from understudy.model import Contours, FloatArray, Interval, Phone, Word

FUNCTION_WORDS = frozenset(
    re.findall(
        r"\w+",
        """a an the this that these those my your his her its our their i you he she it we they me him us them and or
    but if as than so in on at by of to for from with into is are was were be been am have has had do does did will
    would can could shall should may might must not""",
    )
)
GERMAN = (
    ("sch", "SH"), ("ch", "HH"), ("ck", "K"), ("ng", "NG"), ("ie", "IY"), ("ei", "AY"), ("eu", "OY"), ("äu", "OY"),
    ("au", "AW"), ("a", "AA"), ("e", "EH"), ("i", "IH"), ("o", "AO"), ("u", "UH"), ("ä", "EH"), ("ö", "ER"),
    ("ü", "UW"), ("z", "S"), ("w", "V"), ("v", "F"), ("j", "Y"), ("ß", "S"), ("h", "HH"), ("c", "K"),
)  # fmt: skip
TYPICAL_PHONE_S = 0.07
"""For phones that TIMIT has not."""

CUES = ("duration", "f0 maximum", "f0 rise", "energy over neighbours'", "pause")
"""As `understudy.acoustic.stress.cues` has them."""

EMOTIONS = {"N": "neutral", "L": "bored", "T": "sad", "A": "afraid", "E": "disgusted", "F": "happy", "W": "angry"}


def main() -> None:
    """Prints the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=SPEECH, help="folder of emodb and emodb_labels")
    parser.add_argument("--timit", type=Path, default=SPEECH / "timit", help="folder of TIMIT's speakers")
    options = parser.parse_args()
    spoken, _ = read_sentences(options.timit)
    print_syllables(read_judged(options.speech), phone_lengths(spoken))
    print_words(spoken)


def phone_lengths(sentences: Sequence[Sentence]) -> dict[str, float]:
    """The mean length of each phone, by its ARPABET label, in seconds."""
    lengths: dict[str, list[float]] = {}
    for sentence in sentences:
        for word in placed_words(sentence):
            for phone in word.phones:
                lengths.setdefault(phone.label, []).append(phone.interval.duration_s)
    return {label: float(np.mean(found)) for label, found in lengths.items()}


def placed_words(sentence: Sentence) -> tuple[Word, ...]:
    """The sentence's words with their phones, as a human placed them."""
    words = []
    for index, (text, interval) in enumerate(zip(sentence.text.split(), sentence.words, strict=True)):
        said = sentence.said(index)
        ends_s = [*(start_s for _, start_s in said[1:]), interval.end_s]
        phones = (Phone(label, Interval(at_s, end_s)) for (label, at_s), end_s in zip(said, ends_s, strict=True))
        words.append(Word(index, text, interval, tuple(phones)))
    return tuple(words)


def print_syllables(sentences: list[JudgedSentence], lengths_s: dict[str, float]) -> None:
    """Each cue alone, then weighed together."""
    print(f"{sum(len(sentence.syllables) for sentence in sentences)} syllables, {len(sentences)} sentences")
    heard = [contours_of(sentence.audio) for sentence in sentences]
    ours = [cues(sentence.syllables, contours) for sentence, contours in zip(sentences, heard, strict=True)]
    levels = [
        _highest(sentence.syllables, contours.energy_db) for sentence, contours in zip(sentences, heard, strict=True)
    ]
    expected = [np.log([_expected_s(spelling, lengths_s) for spelling in each.spellings]) for each in sentences]
    rows = {
        "the paper's stressed ratio": [
            _ratios(each, contours) for each, contours in zip(sentences, heard, strict=True)
        ],
        **{name: [cue[:, column] for cue in ours] for column, name in enumerate(CUES)},
        "duration over that expected": [cue[:, 0] - length for cue, length in zip(ours, expected, strict=True)],
        "energy": levels,
        "prominence, speakers held out": held_out(sentences, ours),
        **{
            f"  without {name}": held_out(sentences, [np.delete(cue, column, axis=1) for cue in ours])
            for column, name in enumerate(CUES)
        },
        "  and the length expected": held_out(sentences, _beside(ours, expected)),
        "  and energy": held_out(sentences, _beside(ours, levels)),
        "prominence, as shipped": [log_odds(cue) for cue in ours],
    }
    for name, scores in rows.items():
        print(f"{name:38}{_mean_correlation(sentences, scores):.3f}")
    found = {"as shipped": rows["prominence, speakers held out"], "as lively": held_out(sentences, ours, _as_lively)}
    print_numbers(sentences, found)


def print_numbers(sentences: list[JudgedSentence], found: dict[str, list[FloatArray]]) -> None:
    """How many syllables listeners hear stressed, and how many are found (of a score above 0); and in which part of
    the sentences there is none."""
    heard = [np.array(sentence.stresses) >= STRESSED for sentence in sentences]
    kinds = {"heard": heard} | {name: [score > 0 for score in scores] for name, scores in found.items()}
    print(f"\n{'stressed, none in the sentence':38}" + "".join(f"{name:>14}" for name in kinds))
    for letter, emotion in EMOTIONS.items():
        places = [place for place, sentence in enumerate(sentences) if sentence.emotion == letter]
        told = [[kind[place] for place in places] for kind in kinds.values()]
        shares = ((np.mean(np.concatenate(each)), np.mean([not one.any() for one in each])) for each in told)
        print(f"{emotion:38}" + "".join(f"{share:9.3f} {none:4.2f}" for share, none in shares))
    counts = [np.array([one.sum() for one in kind]) for kind in kinds.values()]
    misses = "".join(f"{np.mean(np.abs(each - counts[0])):14.2f}" for each in counts)
    print(f"{'more or fewer than heard, a sentence':38}{misses}\n")


Scorer = Callable[[FloatArray], FloatArray]
"""The log odds of a sentence's syllables from their cues."""


def held_out(
    sentences: list[JudgedSentence],
    seen: list[FloatArray],
    fitting: Callable[[Sequence[FloatArray], Sequence[Sequence[float]]], Scorer] | None = None,
) -> list[FloatArray]:
    """The log odds of each sentence as fitted (default: as shipped) to the other speakers, less their threshold."""
    scores: dict[int, FloatArray] = {}
    for speaker in {sentence.speaker for sentence in sentences}:
        own = [place for place, sentence in enumerate(sentences) if sentence.speaker == speaker]
        others = [place for place, sentence in enumerate(sentences) if sentence.speaker != speaker]
        stresses = [sentences[place].stresses for place in others]
        score = (fitting or _as_shipped)([seen[place] for place in others], stresses)
        limit = threshold(np.concatenate([score(seen[place]) for place in others]), np.concatenate(stresses))
        scores |= {place: score(seen[place]) - limit for place in own}
    return [scores[place] for place in range(len(sentences))]


def _as_shipped(seen: Sequence[FloatArray], stresses: Sequence[Sequence[float]]) -> Scorer:
    weights, bias = fit(seen, stresses)
    return lambda measured: log_odds(measured, weights, bias)


def _as_lively(seen: Sequence[FloatArray], stresses: Sequence[Sequence[float]]) -> Scorer:
    weights, bias = regression(np.concatenate(seen), np.concatenate(stresses) >= STRESSED)
    return lambda measured: measured @ weights + bias


def print_words(sentences: list[Sentence]) -> None:
    """Content words against function words, by the paper's ratio and by prominence."""
    measures: dict[str, Callable[[Word], float]] = {
        "the paper's stressed ratio": lambda word: word.stressed_ratio or 0.0,
        "syllables' prominence": lambda word: word.prominence or 0.0,
    }
    listeners = Listeners.load(resource_folder("models") / "focus" / "emphases.onnx")
    print(f"\n{sum(len(sentence.words) for sentence in sentences)} words, {len(sentences)} sentences")
    heard = [_stressed(sentence) for sentence in sentences]
    for name, measure in measures.items():
        _print_words(name, heard, measure)
    heard = [
        with_listeners(words, listeners.heard(sentence.audio, words))
        for words, sentence in zip(heard, sentences, strict=True)
    ]
    _print_words("prominence, with listeners", heard, measures["syllables' prominence"])
    prominent = np.mean([(word.prominence or 0.0) > PROMINENT for words in heard for word in words])
    print(f"{'words that prominence emphasises':38}{prominent:.3f}")


def _print_words(name: str, heard: list[tuple[Word, ...]], measure: Callable[[Word], float]) -> None:
    print(f"{name:38}{np.mean([content_over_function(words, list(map(measure, words))) for words in heard]):.3f}")


def _highest(syllables: Sequence[Interval], contour: FloatArray) -> FloatArray:
    """The contour's highest value in each syllable."""
    firsts = [min(round(syllable.start_s * 100), len(contour) - 1) for syllable in syllables]
    return np.array(
        [
            contour[first : round(syllable.end_s * 100) + 1].max()
            for first, syllable in zip(firsts, syllables, strict=True)
        ]
    )


def _ratios(sentence: JudgedSentence, contours: Contours) -> FloatArray:
    """The stressed ratio of each syllable, as if it were a word."""
    words = tuple(Word(index, "", syllable) for index, syllable in enumerate(sentence.syllables))
    return np.array([word.stressed_ratio for word in stress(words, contours)[0]])


def _expected_s(spelling: str, lengths_s: dict[str, float]) -> float:
    """The mean lengths of a German syllable's phones, summed."""
    rest, total_s = re.sub(r"(.)\1", r"\1", re.sub(r"[^a-zäöüß]", "", spelling.lower())), 0.0
    while rest:
        letters, phone = next((pair for pair in GERMAN if rest.startswith(pair[0])), (rest[0], rest[0].upper()))
        rest, total_s = rest[len(letters) :], total_s + lengths_s.get(phone, TYPICAL_PHONE_S)
    return max(total_s, TYPICAL_PHONE_S)


def _beside(seen: list[FloatArray], more: list[FloatArray]) -> list[FloatArray]:
    """The cues and one more, less its mean in the sentence."""
    return [np.column_stack([cue, added - added.mean()]) for cue, added in zip(seen, more, strict=True)]


def _mean_correlation(sentences: list[JudgedSentence], scores: Sequence[FloatArray]) -> float:
    """Sentences all of whose syllables score the same count as 0."""
    pairs = [(each.stresses, score) for each, score in zip(sentences, scores, strict=True)]
    return float(np.mean([spearmanr(heard, score).statistic if np.ptp(score) > 0 else 0.0 for heard, score in pairs]))


def _stressed(sentence: Sentence) -> tuple[Word, ...]:
    contours = contours_of(sentence.audio)
    return stress(prominence(placed_words(sentence), contours), contours)[0]


def content_over_function(words: tuple[Word, ...], values: Sequence[float]) -> float:
    """The chance that a content word's value exceeds a function word's, ties counted half."""
    content = [value for word, value in zip(words, values, strict=True) if word.text.lower() not in FUNCTION_WORDS]
    function = [value for word, value in zip(words, values, strict=True) if word.text.lower() in FUNCTION_WORDS]
    if not content or not function:
        return 0.5
    return float(mannwhitneyu(content, function).statistic / (len(content) * len(function)))


if __name__ == "__main__":
    main()
