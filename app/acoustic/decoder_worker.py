"""The process in which pocketsphinx works: whatever the native library does, it does not do it to the service.

Run by path, it imports nothing of ours. It reads requests from standard input until that ends, as it does when the
parent dies, and answers each on standard output:

    request  one line of JSON {"words": [[pronunciation, …], …], "bytes": n, "more": m}, then n bytes of 16-bit audio at
             16 kHz; m tells whether the audio goes on after these bytes, and the text perhaps after these words
    answer   one line of JSON {"words": [[[label, first frame, frames, score], …], …], "fillers": [[text, first frame,
             frames, score], …], "end": frame}, or {"words": null}: no path. "end" is where the next piece of the audio
             begins; the words given back are those before it.

A pronunciation is a string of phones between spaces; every word has one or more. Each request has a decoder of its
own (7 ms to make), so no answer depends on earlier requests.

The first pass listens by a grammar: the words in their order, "um" and "uh" between them where they are far likelier
than nothing, and, if there is more, an end after any word. The second aligns the words and fillers so found, for the
grammar's own times are less exact; the third aligns their phones. Fillers that then fit poorly are taken back.
"""

import json
import sys
from itertools import pairwise
from typing import BinaryIO

from pocketsphinx import Alignment, Decoder

FRAMES_PER_S = 125
BYTES_PER_FRAME = 2 * 16_000 // FRAMES_PER_S
BEAM = 1e-200
"""Wide: nothing is pruned that noise makes unlikely for a while."""

FILLERS = {"um": ["AH M"], "uh": ["AH"]}
FILLER_PROBABILITY = 1e-20
SHORTEST_FILLER_FRAMES = 15
LOWEST_FILLER_SCORE = -36.0
"""A frame, on average: what fits worse is a breath, a click, or part of a word."""

UNSURE_FRAMES = 2 * FRAMES_PER_S
"""What is heard so near the end of a piece may change with what follows."""

Phones = list[tuple[str, int, int, int]]


Heard = list[tuple[str, int, int]]
"""Words ("w" and their number) and fillers with first and last frame."""


def main(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answers requests until there are no more."""
    while line := requests.readline():
        request = json.loads(line)
        answer = aligned(requests.read(request["bytes"]), request["words"], more=request["more"])
        answers.write(json.dumps(answer).encode() + b"\n")
        answers.flush()


def aligned(audio: bytes, words: list[list[str]], *, more: bool) -> dict[str, object]:
    """The answer to a request."""
    decoder = _decoder(words)
    heard = _heard(decoder, audio, len(words), more=more)
    end = len(audio) // BYTES_PER_FRAME
    if more:
        heard, end = _before_a_pause(heard, end)
        if not heard:
            return {"words": [], "fillers": [], "end": end}
    names = [name for name, _, _ in heard]
    placed = _placed(decoder, audio[: end * BYTES_PER_FRAME], names)
    if placed and any(map(_is_poor, placed[1])):
        placed = _placed(decoder, audio[: end * BYTES_PER_FRAME], _believed(names, placed[1]))
    return {"words": placed[0], "fillers": placed[1], "end": end} if placed else {"words": None}


def _placed(decoder: Decoder, audio: bytes, names: list[str]) -> tuple[list[Phones], Phones] | None:
    """The phones of the words among `names`, and the fillers among them; None when there is no path."""
    if not names:
        return None
    decoder.set_align_text(" ".join(names))
    _decode(decoder, audio)
    if decoder.hyp() is None:
        return None
    decoder.set_alignment()
    _decode(decoder, audio)
    words, fillers = _phones(decoder.get_alignment())
    return (words, fillers) if len(words) + len(fillers) == len(names) else None


def _is_poor(filler: tuple[str, int, int, int]) -> bool:
    _, _, frames, score = filler
    return score < LOWEST_FILLER_SCORE * frames


def _believed(names: list[str], fillers: Phones) -> list[str]:
    """The names without the fillers that fit poorly."""
    verdicts = iter(fillers)
    return [name for name in names if name not in FILLERS or not _is_poor(next(verdicts))]


def _decoder(words: list[list[str]]) -> Decoder:
    """A decoder that knows the words as w0, w1, …, and the fillers."""
    decoder = Decoder(
        lm=None, dict=None, bestpath=False, frate=FRAMES_PER_S, beam=BEAM, pbeam=BEAM, wbeam=BEAM, loglevel="FATAL"
    )
    named = {f"w{number}": pronunciations for number, pronunciations in enumerate(words)}
    for name, pronunciations in {**FILLERS, **named}.items():
        for variant, phones in enumerate(pronunciations, start=1):
            decoder.add_word(name if variant == 1 else f"{name}({variant})", phones, False)
    return decoder


def _heard(decoder: Decoder, audio: bytes, count: int, *, more: bool) -> Heard:
    """The words and fillers of the first pass, in order: all words, or with `more` the first few; none: no path."""
    transitions: list[tuple[int, int, float, str] | tuple[int, int, float]] = [
        (number, number + 1, 1.0, f"w{number}") for number in range(count)
    ]
    transitions += [(number, number, FILLER_PROBABILITY, name) for number in range(count + 1) for name in FILLERS]
    transitions += [(number, count, 1.0) for number in range(count) if more]
    decoder.add_fsg("line", decoder.create_fsg("line", 0, count, transitions))
    decoder.activate_search("line")
    _decode(decoder, audio)
    if decoder.hyp() is None:
        return []
    named = [(segment.word.partition("(")[0], segment.start_frame, segment.end_frame) for segment in decoder.seg()]
    heard = [each for each in named if each[0].startswith("w") or _is_filler(*each)]
    complete = sum(name.startswith("w") for name, _, _ in heard) == count
    return heard if more or complete else []


def _is_filler(name: str, first: int, last: int) -> bool:
    return name in FILLERS and last - first + 1 >= SHORTEST_FILLER_FRAMES


def _before_a_pause(heard: Heard, frames: int) -> tuple[Heard, int]:
    """What is surely heard, and where to cut after it: in the longest pause of the piece's later half, or else
    (everything) of all of it. Nothing heard for sure: the cut is where the unsure part begins."""
    sure = frames - UNSURE_FRAMES
    gaps = [
        (following - last, (last + following) // 2, number)
        for number, ((_, _, last), (_, following, _)) in enumerate(pairwise([*heard, ("", frames, frames)]), start=1)
        if last < sure
    ]
    if not gaps:
        return [], sure
    _, cut, number = max([gap for gap in gaps if gap[1] > frames // 2] or gaps)
    return heard[:number], min(cut, sure)


def _decode(decoder: Decoder, audio: bytes) -> None:
    decoder.start_stream()
    decoder.start_utt()
    decoder.process_raw(audio, full_utt=True)
    decoder.end_utt()


def _phones(alignment: Alignment) -> tuple[list[Phones], Phones]:
    """Phones word by word, and the fillers. A phone must be read while its word is there."""
    words, fillers = [], []
    for word in alignment:
        phones = [(phone.name, phone.start, phone.duration, phone.score) for phone in word]
        if word.name.startswith("w"):
            words.append(phones)
        elif word.name in FILLERS:
            fillers.append((word.name, word.start, word.duration, word.score))
    return words, fillers


if __name__ == "__main__":
    main(sys.stdin.buffer, sys.stdout.buffer)
