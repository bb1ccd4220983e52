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
than nothing, and, if there is more, an end after any word. The second aligns the phones of what was heard. Only where a
filler turns out too short or fits poorly are the words without it aligned afresh, and their phones again.
"""

import json
import sys
from itertools import pairwise
from typing import BinaryIO

from pocketsphinx import AlignmentEntry, Decoder

FRAMES_PER_S = 125
BYTES_PER_FRAME = 2 * 16_000 // FRAMES_PER_S
BEAM = 1e-200
"""Wide: nothing is pruned that noise makes unlikely for a while."""

FILLERS = {"um": ["AH M"], "uh": ["AH"]}
FILLER_PROBABILITY = 1e-20
SHORTEST_FILLER_FRAMES = 22
LOWEST_FILLER_SCORE = -42.0
"""A frame, on average: what fits worse is a breath, a click, or part of a word."""

UNSURE_FRAMES = 2 * FRAMES_PER_S
"""What is heard so near the end of a piece may change with what follows."""

CLEAR_PAUSE_FRAMES = FRAMES_PER_S // 5
NOTHING = "(NULL)"
"""What pocketsphinx calls the step of a grammar that no word takes."""

Phone = tuple[str, int, int, int]
"""Label, first frame, frames, score; so are words and fillers told."""

Heard = list[tuple[Phone, list[Phone]]]
"""Words ("w" and their number) and fillers in order, each with its phones."""


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
    _listen(decoder, audio, len(words), more=more)
    end = len(audio) // BYTES_PER_FRAME
    heard = _placed(decoder, audio)
    believed = [each[0] for each, _ in heard if not _is_doubtful(each)]
    if len(believed) < len(heard):
        heard = _aligned_afresh(decoder, audio, believed)
    if more:
        heard, end = _before_a_pause(heard, end)
    spoken = [phones for each, phones in heard if each[0] not in FILLERS]
    fillers = [each for each, _ in heard if each[0] in FILLERS]
    return {"words": spoken if more or len(spoken) == len(words) else None, "fillers": fillers, "end": end}


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


def _listen(decoder: Decoder, audio: bytes, count: int, *, more: bool) -> None:
    """The first pass, for the words w0 to w(count − 1)."""
    transitions: list[tuple[int, int, float, str] | tuple[int, int, float]] = [
        (number, number + 1, 1.0, f"w{number}") for number in range(count)
    ]
    transitions += [(number, number, FILLER_PROBABILITY, name) for number in range(count + 1) for name in FILLERS]
    if more:
        transitions += [(0, count, 1.0), *((number, count, 1.0, f"w{number}") for number in range(count - 1))]
    decoder.add_fsg("line", decoder.create_fsg("line", 0, count, transitions))
    decoder.activate_search("line")
    _decode(decoder, audio)


def _aligned_afresh(decoder: Decoder, audio: bytes, names: list[str]) -> Heard:
    """The words and fillers of these names, whatever was heard before."""
    if not names:
        return []
    decoder.set_align_text(" ".join(names))
    _decode(decoder, audio)
    return _placed(decoder, audio)


def _placed(decoder: Decoder, audio: bytes) -> Heard:
    """What the decoder just heard, with its phones; nothing when it found no path, or one without words. A phone must
    be read while its word is there."""
    if decoder.hyp() is None or any(segment.word == NOTHING for segment in decoder.seg()):
        return []
    decoder.set_alignment()
    _decode(decoder, audio)
    heard = [(_told(word), [_told(phone) for phone in word]) for word in decoder.get_alignment()]
    return [(each, phones) for each, phones in heard if _is_one_of_ours(each[0])]


def _is_one_of_ours(name: str) -> bool:
    return name.startswith("w") or name in FILLERS


def _told(entry: AlignmentEntry) -> Phone:
    return entry.name.partition("(")[0], entry.start, entry.duration, entry.score


def _is_doubtful(heard: Phone) -> bool:
    """A filler that is too short, or fits too poorly."""
    name, _, frames, score = heard
    return name in FILLERS and (frames < SHORTEST_FILLER_FRAMES or score < LOWEST_FILLER_SCORE * frames)


def _before_a_pause(heard: Heard, frames: int) -> tuple[Heard, int]:
    """What is surely heard, and where to cut after it: in the last clear pause of the piece's later half, or else
    (everything) in the longest of all. Nothing heard for sure: the cut is where the unsure part begins."""
    sure = frames - UNSURE_FRAMES
    spans = [(first, first + length) for (_, first, length, _), _ in heard]
    gaps = [
        (following - end, (end + following) // 2, number)
        for number, ((_, end), (following, _)) in enumerate(pairwise([*spans, (frames, frames)]), start=1)
        if end <= sure
    ]
    if not gaps:
        return [], sure
    clear = [gap for gap in gaps if gap[0] >= CLEAR_PAUSE_FRAMES and gap[1] > frames // 2]
    _, cut, number = clear[-1] if clear else max(gaps)
    return heard[:number], min(cut, sure)


def _decode(decoder: Decoder, audio: bytes) -> None:
    decoder.start_stream()
    decoder.start_utt()
    decoder.process_raw(audio, full_utt=True)
    decoder.end_utt()


if __name__ == "__main__":
    main(sys.stdin.buffer, sys.stdout.buffer)
