"""Whether the word that most likely has the focus has it: deliveries of the same words, and real speech.

    python -m benchmarks.acoustic.focus [--deliveries FOLDER] [--speech FOLDER]
        [--taught-on DELIVERIES_FOLDER REAL_FOLDER --lines DELIVERIES.jsonl]

Deliveries: `lines.jsonl` and `audio/`, spoken by flite's voices slt, rms and awb, manipulated by WORLD; lines that no
training saw. The figure is the share of them in which the word with the highest value is one with the focus ("first"),
and in which one of the two highest is ("among two"): by prominence, by the listeners' network alone (`emphases`), by
the shipped model, and, with `--taught-on` (folders as `training.focus` takes them; needs torch), by models taught
without the voice they are tested on.

Real speech: the sentences of TIMIT that no training saw (`training/alignment/timit.py`). Nobody has marked their focus;
the figure is the chance that a content word has a higher value than a function word, as in
`benchmarks/acoustic/prominence.py`. And a recorded speech, word by word, to be compared by ear.
"""

import argparse
import json
import zlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.acoustic.prominence import content_over_function, placed_words
from training.alignment.timit import Sentence, read_sentences
from training.prominence import SPEECH
from understudy.acoustic.alignment.aligner import Aligner
from understudy.acoustic.focus.focus_model import FocusModel
from understudy.acoustic.focus.listeners import Listeners
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.acoustic.stage import contours_of
from understudy.acoustic.stress import prominence
from understudy.files import resource_folder
from understudy.model import Audio, Contours, FloatArray, Word
from understudy.text.transcript import read_transcript

DELIVERIES = SPEECH.parents[1] / "directing" / "deliveries"
VOICES = ("slt", "rms", "awb")
"""Of the deliveries, by the checksum of the line's name."""


@dataclass(frozen=True, slots=True, eq=False)
class Heard:
    """A recording's words, all timed, its contours and the listeners' log odds; the words with the focus, if known."""

    words: tuple[Word, ...]
    contours: Contours
    listeners: dict[int, float]
    focus: frozenset[int] = frozenset()
    voice: str = ""


def main() -> None:
    """Prints the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--deliveries", type=Path, default=DELIVERIES)
    parser.add_argument("--speech", type=Path, default=SPEECH)
    parser.add_argument("--taught-on", type=Path, nargs=2, default=())
    parser.add_argument("--lines", type=Path)
    options = parser.parse_args()
    models = resource_folder("models")
    listeners, shipped = (
        Listeners.load(models / "focus" / "emphases.onnx"),
        FocusModel.load(models / "focus" / "focus.npz"),
    )
    with Aligner(models, resource_folder("lexicon") / "en") as aligner:
        deliveries = read_deliveries(options.deliveries, (aligner, listeners))
        speech = read_line(options.speech / "lines" / "jfk", (aligner, listeners))
    print_deliveries(deliveries, shipped, _without_voices(options.taught_on, options.lines))
    print_words(
        [_placed(sentence.audio, placed_words(sentence), listeners) for sentence in _unheard(options.speech)], shipped
    )
    for name, measure in measures(shipped).items():
        values = measure(speech)
        print(name, *(f"{word.text}:{value:.2f}" for word, value in zip(speech.words, values, strict=True)))


def measures(model: FocusModel) -> dict[str, Callable[[Heard], FloatArray]]:
    """What is compared, each a value a word."""
    return {
        "prominence": lambda heard: np.array([word.prominence or 0.0 for word in heard.words]),
        "listeners": lambda heard: 1 / (1 + np.exp(-np.array([heard.listeners[word.index] for word in heard.words]))),
        "focus": lambda heard: _shares(model, heard, heard.listeners),
        "focus, cues alone": lambda heard: _shares(model, heard, None),
    }


def _shares(model: FocusModel, heard: Heard, listeners: dict[int, float] | None) -> FloatArray:
    return np.array([word.focus for word in model.with_focus(heard.words, heard.contours, listeners)])


def read_deliveries(folder: Path, models: tuple[Aligner, Listeners]) -> list[Heard]:
    """The deliveries as they are heard."""
    found = []
    for line in map(json.loads, (folder / "lines.jsonl").read_text().splitlines()):
        text = " ".join(word.split(":", 1)[1] for word in line["words"])
        voice = VOICES[zlib.crc32(line["base"].encode()) % len(VOICES)]
        audio, _ = decode((folder / "audio" / f"{line['id']}.flac").read_bytes(), AudioLimits())
        words, _ = models[0].align(audio, read_transcript(text))
        found.append(_placed(audio, words, models[1], frozenset(line["focus"]), voice))
    return found


def read_line(path: Path, models: tuple[Aligner, Listeners]) -> Heard:
    """A recording and its text."""
    audio, _ = decode(path.with_suffix(".flac").read_bytes(), AudioLimits())
    words, _ = models[0].align(audio, read_transcript(path.with_suffix(".txt").read_text()))
    return _placed(audio, words, models[1])


def _placed(
    audio: Audio, words: tuple[Word, ...], listeners: Listeners, focus: frozenset[int] = frozenset(), voice: str = ""
) -> Heard:
    contours = contours_of(audio)
    timed = tuple(word for word in prominence(words, contours) if word.interval)
    return Heard(timed, contours, listeners.heard(audio, timed), focus, voice)


def _unheard(speech: Path) -> list[Sentence]:
    return read_sentences(speech / "timit")[0][1::2]


def _without_voices(folders: tuple[Path, ...], lines: Path | None) -> dict[str, FocusModel]:
    """A model for each voice of the deliveries, taught without it."""
    if not folders or lines is None:
        return {}
    from training.focus.__main__ import heard_lines, teach  # needs torch

    heard = heard_lines(tuple(folders), lines)
    return {voice: teach([line for line in heard if line.voice != voice]) for voice in VOICES}


def print_deliveries(deliveries: list[Heard], shipped: FocusModel, unheard: dict[str, FocusModel]) -> None:
    """How often the focus is found."""
    print(f"{len(deliveries)} deliveries{'':16}first  among two")
    compared = measures(shipped)
    if unheard:
        compared["focus, voice left out"] = lambda heard: _shares(unheard[heard.voice], heard, heard.listeners)
    for name, measure in compared.items():
        orders = [[heard.words[place].index for place in np.argsort(-measure(heard))] for heard in deliveries]
        first, among = (
            np.mean([bool(set(order[:most]) & heard.focus) for order, heard in zip(orders, deliveries, strict=True)])
            for most in (1, 2)
        )
        print(f"{name:30}{first:.3f}  {among:.3f}")


def print_words(sentences: list[Heard], model: FocusModel) -> None:
    """Content words against function words."""
    print(f"\n{len(sentences)} sentences of TIMIT: content words over function words")
    for name, measure in measures(model).items():
        print(f"{name:30}{np.mean([content_over_function(each.words, list(measure(each))) for each in sentences]):.3f}")


if __name__ == "__main__":
    main()
