"""Time saved by the decoder's narrow search, and accuracy lost, compared with a wide one.

    python -m benchmarks.acoustic.searches [--sentences N] [--timit FOLDER] [--ravdess FOLDER]

Recordings: the first N sentences of TIMIT's training half (`training/alignment/timit.py`) and every sixteenth clip of
RAVDESS. For each search: processor time of the decoder in multiples of the audio's length (the least of three, taken in
turn; as in the product only the decoder of the narrow search is kept from one recording to the next), and how many
recordings and phones lie just where the widest search puts them. One core: set OMP_NUM_THREADS=1.
"""

import time
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from pocketsphinx import get_model_path

from benchmarks.acoustic.alignment import ROOT, read_acted, read_options
from training.alignment.timit import read_sentences
from understudy.acoustic.alignment.decoder_process import FRAMES_PER_S, pcm
from understudy.acoustic.alignment.decoder_worker import NARROW, WIDE, BeamSearch, HeardPhones, Recognizer
from understudy.acoustic.pronunciation.normalisation import Normaliser
from understudy.acoustic.pronunciation.pronouncer import Pronouncer
from understudy.model import FloatArray
from understudy.text.transcript import read_transcript

RAVDESS_STEP = 16
REPEATS = 3
NEAR_S = 0.020
DICTIONARY = Path(get_model_path()) / "en-us" / "cmudict-en-us.dict"
SEARCHES: Mapping[str, BeamSearch] = {
    "wide, four densities": BeamSearch(WIDE.beam, 4),
    "narrow, four densities": BeamSearch(NARROW.beam, 4),
    "wide": WIDE,
    "narrow": NARROW,
}


def main() -> None:
    """Prints a row for each search."""
    options = read_options(__doc__)
    clips = [read_acted(path) for path in sorted(options.ravdess.glob("*.flac"))[::RAVDESS_STEP]]
    sentences = read_sentences(options.timit)[0][::2][: options.sentences]
    recordings = [*((sentence.audio, sentence.text) for sentence in sentences), *clips]
    words_of = _Words()
    recognizer = Recognizer()
    runs = [_by_every_search(recognizer, pcm(audio.samples), words_of(text)) for audio, text in recordings]
    total_s = sum(audio.duration_s for audio, _ in recordings)
    print(f"{len(recordings)} recordings, {total_s:.0f} s")
    widest = next(iter(SEARCHES))
    for name in SEARCHES:
        spent_s = sum(run[name][0] for run in runs)
        moves_s = [_moves_s(run[name][1], run[widest][1]) for run in runs]
        same = np.mean([len(moves) > 0 and not moves.any() for moves in moves_s])
        near = np.mean(np.concatenate(moves_s) <= NEAR_S)
        print(f"{name:24}{spent_s / total_s:.4f} × real time; {same:.0%} as by the widest, {near:.1%} within 20 ms")


class _Words:
    """Makes of a text the pronunciations of its words."""

    def __init__(self) -> None:
        self._pronouncer = Pronouncer.load(DICTIONARY, ROOT / "models" / "pronunciation" / "graphones.npz")
        abbreviations = ROOT / "lexicon" / "en" / "abbreviations.yaml"
        self._normaliser = Normaliser.load(abbreviations, self._pronouncer.dictionary.keys())

    def __call__(self, text: str) -> list[list[str]]:
        spoken = self._normaliser.spoken(read_transcript(text))
        said = [self._pronouncer.pronounce(token) for tokens in spoken for token in tokens]
        return [[" ".join(phones) for phones in each.variants] for each in said if each]


def _by_every_search(
    recognizer: Recognizer, audio: bytes, words: list[list[str]]
) -> dict[str, tuple[float, HeardPhones]]:
    """The least processor time of each search, seconds, and what it heard."""
    rounds = [
        {name: _timed(recognizer, audio, words, search) for name, search in SEARCHES.items()} for _ in range(REPEATS)
    ]
    return {name: (min(each[name][0] for each in rounds), rounds[0][name][1]) for name in SEARCHES}


def _timed(
    recognizer: Recognizer, audio: bytes, words: list[list[str]], search: BeamSearch
) -> tuple[float, HeardPhones]:
    began_s = time.process_time()
    heard = recognizer.aligned(audio, words, search)
    return time.process_time() - began_s, heard


def _moves_s(one: HeardPhones, other: HeardPhones) -> FloatArray:
    """How far the phones of both begin from one another; as far as can be when not the same were heard."""
    starts = [np.array([phone[1] for _, phones in heard for phone in phones]) for heard in (one, other)]
    if len(starts[0]) != len(starts[1]):
        return np.full(len(starts[1]), np.inf)
    moves_s: FloatArray = np.abs(starts[0] - starts[1]) / FRAMES_PER_S
    return moves_s


if __name__ == "__main__":
    main()
