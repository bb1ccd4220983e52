"""The process in which pocketsphinx works: whatever the native library does, it does not do it to the service.

Run by path, it imports nothing of ours. It reads requests from standard input until that ends, as it does when the
parent dies, and answers each on standard output:

    request  one line of JSON {"words": [[pronunciation, …], …], "bytes": n, "more": m}, then n bytes of 16-bit audio at
             16 kHz; m tells whether the audio goes on after these bytes, and the text perhaps after these words
    answer   one line of JSON {"words": [[[label, first frame, frames, score], …], …], "fillers": [[text, first frame,
             frames, score], …]}, or {"words": null}: no path. If there is more, only {"spans": [[is word, first
             frame, frames], …]} of the words and fillers that were heard, roughly: enough to find the pauses.

A pronunciation is a string of phones between spaces; every word has one or more. Each request has decoders of its own
(7 ms to make), so no answer depends on earlier requests.

The first pass listens by a grammar: the words in their order, "um" and "uh" between them where they are far likelier
than nothing, and, if there is more, an end after any word. The second aligns the phones of what was heard. A filler
that turns out too short, fits poorly or has no pause beside it is none: its sound belongs to the word beside it.

Four fifths of the time go into densities of the acoustic model, so the search is narrow at first, and two densities
are added up for a state, not the usual four; only what then fits badly, as in noise, is searched widely
(`python -m benchmarks.searches` compares them).
"""

import json
import sys
from dataclasses import dataclass
from itertools import pairwise
from typing import BinaryIO

from pocketsphinx import AlignmentEntry, Decoder

FRAMES_PER_S = 125


@dataclass(frozen=True, slots=True)
class Search:
    """How widely is searched: paths less likely than `beam` times the best are dropped, and the likelihood of a state
    is the sum of its `densities` best."""

    beam: float
    densities: int


ROUGH = Search(1e-60, 1)
"""Enough to find pauses by."""

NARROW = Search(1e-60, 2)
WIDE = Search(1e-200, 2)
"""Nothing is pruned that noise makes unlikely for a while."""

SURE_SCORE = -35.0
"""A frame, on average, as all scores here: what fits as well by the narrow search is what the wide one finds."""

LONGEST_SURE_FRAMES = 3 * FRAMES_PER_S // 5

FILLERS = {"um": ["AH M"], "uh": ["AH"]}
FILLER_PROBABILITY = 1e-12
SHORTEST_FILLER_FRAMES = 22
LOWEST_FILLER_SCORE = -48.0
"""What fits worse is a breath, a click, or part of a word."""

NOTHING = "(NULL)"
"""What pocketsphinx calls the step of a grammar that no word takes."""

Phone = tuple[str, int, int, int]
"""Label, first frame, frames, score; so are words and fillers told."""

Span = tuple[bool, int, int]
"""Whether it is a word, first frame, frames."""

Heard = list[tuple[Phone, list[Phone]]]
"""Words ("w" and their number) and fillers in order, each with its phones."""


def main(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answers requests until there are no more."""
    while line := requests.readline():
        request = json.loads(line)
        answer = answer_to(requests.read(request["bytes"]), request["words"], more=request["more"])
        answers.write(json.dumps(answer).encode() + b"\n")
        answers.flush()


def answer_to(audio: bytes, words: list[list[str]], *, more: bool) -> dict[str, object]:
    """The answer to a request."""
    if more:
        spans = _spans(audio, words, ROUGH)
        return {"spans": _spans(audio, words, WIDE) or [] if spans is None else spans}
    heard = aligned(audio, words, NARROW)
    if not _is_sure(heard):
        heard = aligned(audio, words, WIDE)
    spoken = [phones for each, phones in heard if each[0] not in FILLERS]
    fillers = [each for each, _ in heard if each[0] in FILLERS]
    return {"words": spoken if len(spoken) == len(words) else None, "fillers": fillers}


def _spans(audio: bytes, words: list[list[str]], search: Search) -> list[Span] | None:
    """Where the first of the words are, as many as are heard before the audio ends; None when there is no path."""
    decoder = _decoder(words, search)
    _listen(decoder, audio, len(words), more=True)
    if decoder.hyp() is None:
        return None
    heard = [segment for segment in decoder.seg() if _is_one_of_ours(segment.word)]
    return [
        (segment.word.startswith("w"), segment.start_frame, segment.end_frame + 1 - segment.start_frame)
        for segment in heard
    ]


def aligned(audio: bytes, words: list[list[str]], search: Search) -> Heard:
    """All the words and the fillers that are believed; nothing when there is no path."""
    decoder = _decoder(words, search)
    _listen(decoder, audio, len(words))
    heard = _placed(decoder, audio)
    by_a_pause = _are_by_a_pause([each for each, _ in heard])
    doubtful = [_is_doubtful(each, by_a_pause=by) for (each, _), by in zip(heard, by_a_pause, strict=True)]
    return _merged(heard, doubtful)


def _is_sure(heard: Heard) -> bool:
    """Whether the words are heard, fit well, and none is stretched over what may be music."""
    words = [(each, phones) for each, phones in heard if each[0] not in FILLERS]
    fit = sum(score - SURE_SCORE * frames for (_, _, frames, score), _ in words)
    longest = max((frames for _, phones in words for _, _, frames, _ in phones), default=0)
    return bool(words) and fit >= 0 and longest <= LONGEST_SURE_FRAMES


def _decoder(words: list[list[str]], search: Search) -> Decoder:
    """A decoder that knows the words as w0, w1, …, and the fillers."""
    decoder = Decoder(
        lm=None,
        dict=None,
        bestpath=False,
        frate=FRAMES_PER_S,
        topn=search.densities,
        beam=search.beam,
        pbeam=search.beam,
        wbeam=search.beam,
        loglevel="FATAL",
    )
    named = {f"w{number}": pronunciations for number, pronunciations in enumerate(words)}
    for name, pronunciations in {**FILLERS, **named}.items():
        for variant, phones in enumerate(pronunciations, start=1):
            decoder.add_word(name if variant == 1 else f"{name}({variant})", phones, False)
    return decoder


def _listen(decoder: Decoder, audio: bytes, count: int, *, more: bool = False) -> None:
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


def _is_doubtful(heard: Phone, *, by_a_pause: bool) -> bool:
    """A filler that is too short, fits too poorly, or has no pause beside it, as the drawn out end of a line has none:
    what goes on without one is part of a word."""
    name, _, frames, score = heard
    is_sound = frames >= SHORTEST_FILLER_FRAMES and score >= LOWEST_FILLER_SCORE * frames
    return name in FILLERS and not (is_sound and by_a_pause)


def _are_by_a_pause(heard: list[Phone]) -> list[bool]:
    """Whether there is a pause between each and a neighbour; the silence at the ends of the audio is none."""
    pauses = [not _touch(one, other) for one, other in pairwise(heard)]
    return [any(beside) for beside in zip([False, *pauses], [*pauses, False], strict=True)][: len(heard)]


def _merged(heard: Heard, doubtful: list[bool]) -> Heard:
    """Without what is doubtful. Its frames go to the word before it, or else after it, if there is no pause between:
    they are the end or the beginning of that word's sound."""
    kept: Heard = []
    left: Phone | None = None
    for (each, phones), is_doubtful in zip(heard, doubtful, strict=True):
        if is_doubtful and kept and _touch(kept[-1][0], each):
            word, sounds = kept[-1]
            kept[-1] = _joined(word, each), [*sounds[:-1], _joined(sounds[-1], each)]
        elif is_doubtful:
            left = each
        elif left and _touch(left, each):
            kept.append((_joined(each, left), [_joined(phones[0], left), *phones[1:]]))
        else:
            kept.append((each, phones))
    return kept


def _touch(one: Phone, other: Phone) -> bool:
    return one[1] + one[2] == other[1]


def _joined(phone: Phone, neighbour: Phone) -> Phone:
    """A phone with the frames of its neighbour."""
    name, first, frames, score = phone
    return name, min(first, neighbour[1]), frames + neighbour[2], score + neighbour[3]


def _decode(decoder: Decoder, audio: bytes) -> None:
    decoder.start_stream()
    decoder.start_utt()
    decoder.process_raw(audio, full_utt=True)
    decoder.end_utt()


if __name__ == "__main__":
    main(sys.stdin.buffer, sys.stdout.buffer)
