"""The process in which pocketsphinx works: whatever the native library does, it does not do it to the service.

Run by path, it imports nothing of ours. It reads requests from standard input until that ends, as it does when the
parent dies, and answers each on standard output:

    request  one line of JSON {"words": [[pronunciation, …], …], "bytes": n}, then n bytes of 16-bit audio at 16 kHz
    answer   one line of JSON {"words": [[[label, first frame, frames, score], …], …]}, or {"words": null}: no path

A pronunciation is a string of phones between spaces; every word has one or more. Each request has a decoder of its
own (7 ms to make), so no answer depends on earlier requests.
"""

import json
import sys
from typing import BinaryIO

from pocketsphinx import Alignment, Decoder

FRAMES_PER_S = 125
BEAM = 1e-200
"""Wide: nothing is pruned that noise makes unlikely for a while."""

Phones = list[tuple[str, int, int, int]]


def main(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answers requests until there are no more."""
    while line := requests.readline():
        request = json.loads(line)
        words = aligned(requests.read(request["bytes"]), request["words"])
        answers.write(json.dumps({"words": words}).encode() + b"\n")
        answers.flush()


def aligned(audio: bytes, words: list[list[str]]) -> list[Phones] | None:
    """The phones of each word, from a first pass that places the words and a second that places their phones."""
    decoder = Decoder(
        lm=None, dict=None, bestpath=False, frate=FRAMES_PER_S, beam=BEAM, pbeam=BEAM, wbeam=BEAM, loglevel="FATAL"
    )
    for number, pronunciations in enumerate(words):
        for variant, phones in enumerate(pronunciations, start=1):
            decoder.add_word(f"w{number}" if variant == 1 else f"w{number}({variant})", phones, False)
    decoder.set_align_text(" ".join(f"w{number}" for number in range(len(words))))
    _decode(decoder, audio)
    if decoder.hyp() is None:
        return None
    decoder.set_alignment()
    _decode(decoder, audio)
    found = _phones(decoder.get_alignment())
    return found if len(found) == len(words) else None


def _decode(decoder: Decoder, audio: bytes) -> None:
    decoder.start_utt()
    decoder.process_raw(audio, full_utt=True)
    decoder.end_utt()


def _phones(alignment: Alignment) -> list[Phones]:
    """Phones word by word, fillers left out. A phone must be read while its word is there."""
    words = []
    for word in alignment:
        phones = [(phone.name, phone.start, phone.duration, phone.score) for phone in word]
        if word.name.startswith("w"):
            words.append(phones)
    return words


if __name__ == "__main__":
    main(sys.stdin.buffer, sys.stdout.buffer)
