"""The worker process that runs pocketsphinx, isolated so that crashes of the native library do not affect the service.

It is run by path and imports none of our modules. It reads requests from standard input until end of file, which also
occurs when the parent dies, and writes each response to standard output:

    request  one line of JSON {"words": [[pronunciation, …], …], "bytes": n, "more": m}, then n bytes of 16-bit audio at
             16 kHz; m tells whether the audio goes on after these bytes, and the text perhaps after these words
    answer   one line of JSON {"words": [[[label, first frame, frames, score], …], …], "fillers": [[text, first frame,
             frames, score], …]}, or {"words": null}: no path. If there is more, only {"spans": [[is word, first
             frame, frames], …]} of the words and fillers found, approximate but sufficient to find the pauses.

A pronunciation is a string of phones separated by spaces; every word has at least one. The default decoder is reused,
since creating one takes as long as decoding .2 s of speech; no response depends on earlier requests, because only the
vocabulary is kept.

The first pass decodes with a grammar: the words in order, with "um" and "uh" allowed between them at a low probability,
and, if there is more, an end after any word. The second pass, with a separate, less thorough decoder, aligns the phones
within the words found. A filler that is too short, fits poorly or is not next to a pause is rejected, and its frames
are assigned to the neighbouring word.

Four fifths of the time are spent on the densities of the acoustic model, so the first search is narrow and sums two
densities per state instead of the usual four; only if the result fits badly, as in noise, is a wide search made
(`python -m benchmarks.acoustic.searches` compares them).
"""

import json
import sys
from dataclasses import dataclass
from itertools import pairwise
from typing import BinaryIO

from pocketsphinx import AlignmentEntry, Decoder

FRAMES_PER_S = 100
"""At 125 the raw boundaries are more accurate, but not after refinement (`understudy.acoustic.alignment.boundaries`),
and decoding takes a quarter more time."""


@dataclass(frozen=True, slots=True)
class BeamSearch:
    """The parameters of a search: paths less likely than `beam` times the best are pruned, the likelihood of a state is
    the sum of its `densities` best, which are selected every `every` frames."""

    beam: float
    densities: int
    every: int = 1


ROUGH = BeamSearch(1e-48, 1)
"""Sufficient to find pauses."""

NARROW = BeamSearch(1e-48, 2)
WIDE = BeamSearch(1e-200, 2)
"""Does not prune paths that noise makes unlikely for a while."""

PLACING = BeamSearch(1e-48, 4, every=2)
"""For phones within known words, where a finer search hardly changes their times."""

SURE_SCORE = -35.0
"""The mean score per frame, as for all scores here, above which the wide search would find the same path."""

LONGEST_SURE_FRAMES = 3 * FRAMES_PER_S // 5

SILENCE_PROBABILITY = 0.1
"""The probability of a pause between two words. With pocketsphinx's default of .005, a breath before a line, or hiss in
a pause, is often taken for the first sound of the next word."""

FILLERS = {"um": "AH M", "uh": "AH"}
FILLER_PROBABILITY = 1e-12
SHORTEST_FILLER_FRAMES = 18
LOWEST_FILLER_SCORE = -48.0
"""What fits worse is a breath, a click, or part of a word."""

MOST_WORDS_KNOWN = 20_000
"""The vocabulary limit of a decoder: some ten megabytes."""

NOTHING = "(NULL)"
"""pocketsphinx's name for a grammar transition without a word."""

Phone = tuple[str, int, int, int]
"""Label, first frame, frames, score; also used for words and fillers."""

Span = tuple[bool, int, int]
"""Whether it is a word, first frame, frames."""

HeardPhones = list[tuple[Phone, list[Phone]]]
"""Words (by `_name`) and fillers in order, each with its phones."""


def main(requests: BinaryIO, answers: BinaryIO) -> None:
    """Respond to requests until end of file."""
    recognizer = Recognizer()
    while line := requests.readline():
        request = json.loads(line)
        answer = recognizer.response_to(requests.read(request["bytes"]), request["words"], more=request["more"])
        answers.write(json.dumps(answer).encode() + b"\n")
        answers.flush()
        recognizer.prepare()


class Recognizer:
    """Keeps the decoder of the narrow search, and one that will place the phones of the next line; others are created
    when needed."""

    def __init__(self) -> None:
        self._kept = _Vocabulary(NARROW)
        self._placers: list[Decoder] = []

    def prepare(self) -> None:
        """Create what the next line needs, while nobody waits for it."""
        if not self._placers:
            self._placers.append(_decoder(PLACING))

    def response_to(self, audio: bytes, words: list[list[str]], *, more: bool) -> dict[str, object]:
        """The response to a request."""
        if more:
            spans = self._spans(audio, words, ROUGH)
            return {"spans": self._spans(audio, words, WIDE) or [] if spans is None else spans}
        heard = self.aligned(audio, words, NARROW)
        if not _is_sure(heard):
            heard = self.aligned(audio, words, WIDE)
        spoken = [phones for each, phones in heard if each[0] not in FILLERS]
        fillers = [each for each, _ in heard if each[0] in FILLERS]
        return {"words": spoken if len(spoken) == len(words) else None, "fillers": fillers}

    def aligned(self, audio: bytes, words: list[list[str]], search: BeamSearch) -> HeardPhones:
        """All words and the accepted fillers; empty if there is no path."""
        decoder = self._knowing(words, search)
        _listen(decoder, audio, words)
        heard = self._placed(decoder, audio)
        by_a_pause = _are_by_a_pause([each for each, _ in heard])
        doubtful = [_is_doubtful(each, by_a_pause=by) for (each, _), by in zip(heard, by_a_pause, strict=True)]
        return _merged(heard, doubtful)

    def _placed(self, decoder: Decoder, audio: bytes) -> HeardPhones:
        """The decoder's current result with its phones; empty without a path or without words. A phone must be read
        while its word is current.

        The phones are aligned by a new decoder: where densities are not selected in each frame, a reused one starts
        with those of earlier audio.
        """
        if decoder.hyp() is None or any(segment.word == NOTHING for segment in decoder.seg()):
            return []
        decoder.set_alignment()
        self.prepare()
        placer = self._placers.pop()
        placer.set_alignment(decoder.get_alignment())
        _decode(placer, audio)
        heard = [(_told(word), [_told(phone) for phone in word]) for word in placer.get_alignment()]
        return [(each, phones) for each, phones in heard if _is_one_of_ours(each[0])]

    def _spans(self, audio: bytes, words: list[list[str]], search: BeamSearch) -> list[Span] | None:
        """The times of those first words that are found before the audio ends; None if there is no path."""
        decoder = self._knowing(words, search)
        _listen(decoder, audio, words, more=True)
        if decoder.hyp() is None:
            return None
        heard = [segment for segment in decoder.seg() if _is_one_of_ours(segment.word)]
        return [
            (segment.word not in FILLERS, segment.start_frame, segment.end_frame + 1 - segment.start_frame)
            for segment in heard
        ]

    def _knowing(self, words: list[list[str]], search: BeamSearch) -> Decoder:
        """A decoder whose vocabulary includes the words and the fillers."""
        if search != NARROW:
            return _Vocabulary(search).with_words(words)
        if self._kept.is_full:
            self._kept = _Vocabulary(NARROW)
        return self._kept.with_words(words)


class _Vocabulary:
    """A decoder and its vocabulary, which only grows."""

    def __init__(self, search: BeamSearch) -> None:
        self._decoder = _decoder(search)
        self._names = set(FILLERS)

    @property
    def is_full(self) -> bool:
        """Whether its vocabulary has reached the limit and it should be replaced."""
        return len(self._names) > MOST_WORDS_KNOWN

    def with_words(self, words: list[list[str]]) -> Decoder:
        """The decoder, with these words added to its vocabulary."""
        for pronunciation in (each for variants in words for each in variants):
            name = _name(pronunciation)
            if name not in self._names:
                self._decoder.add_word(name, pronunciation, False)
                self._names.add(name)
        return self._decoder


def _name(pronunciation: str) -> str:
    """The decoder's name for a word with this pronunciation."""
    return pronunciation.replace(" ", "_")


def _is_sure(heard: HeardPhones) -> bool:
    """Whether the words were found, fit well, and none is stretched over what may be music."""
    words = [(each, phones) for each, phones in heard if each[0] not in FILLERS]
    fit = sum(score - SURE_SCORE * frames for (_, _, frames, score), _ in words)
    longest = max((frames for _, phones in words for _, _, frames, _ in phones), default=0)
    return bool(words) and fit >= 0 and longest <= LONGEST_SURE_FRAMES


def _decoder(search: BeamSearch) -> Decoder:
    """A decoder that knows only the fillers."""
    decoder = Decoder(
        lm=None,
        dict=None,
        bestpath=False,
        frate=FRAMES_PER_S,
        topn=search.densities,
        ds=search.every,
        beam=search.beam,
        pbeam=search.beam,
        wbeam=search.beam,
        silprob=SILENCE_PROBABILITY,
        loglevel="FATAL",
    )
    for name, phones in FILLERS.items():
        decoder.add_word(name, phones, False)
    return decoder


def _listen(decoder: Decoder, audio: bytes, words: list[list[str]], *, more: bool = False) -> None:
    """The first pass, for the words in order."""
    last = len(words)
    spoken = [(place, place + 1, 1.0, _name(each)) for place, variants in enumerate(words) for each in variants]
    fillers = [(place, place, FILLER_PROBABILITY, name) for place in range(last + 1) for name in FILLERS]
    ends = [(0, last, 1.0), *((place, last, 1.0, name) for place, _, _, name in spoken if place < last - 1)]
    decoder.add_fsg("line", decoder.create_fsg("line", 0, last, [*spoken, *fillers, *(ends if more else ())]))
    decoder.activate_search("line")
    _decode(decoder, audio)


def _is_one_of_ours(name: str) -> bool:
    """Whether it is not one of pocketsphinx's pauses or noises, "<sil>" or "[NOISE]"."""
    return name[0].isalpha()


def _told(entry: AlignmentEntry) -> Phone:
    return entry.name, entry.start, entry.duration, entry.score


def _is_doubtful(heard: Phone, *, by_a_pause: bool) -> bool:
    """Whether a filler is too short, fits too poorly, or is not next to a pause, as in a drawn-out end of a line:
    sounds that continue without a pause belong to a word."""
    name, _, frames, score = heard
    is_sound = frames >= SHORTEST_FILLER_FRAMES and score >= LOWEST_FILLER_SCORE * frames
    return name in FILLERS and not (is_sound and by_a_pause)


def _are_by_a_pause(heard: list[Phone]) -> list[bool]:
    """Whether there is a pause between each item and a neighbour; silence at the ends of the audio does not count."""
    pauses = [not _touch(one, other) for one, other in pairwise(heard)]
    return [any(beside) for beside in zip([False, *pauses], [*pauses, False], strict=True)][: len(heard)]


def _merged(heard: HeardPhones, doubtful: list[bool]) -> HeardPhones:
    """The result without doubtful fillers, whose frames go to the previous word, or to the next if there is no pause
    between: they are the end or the beginning of its sound."""
    kept: HeardPhones = []
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
    """A phone extended by the frames of its neighbour."""
    name, first, frames, score = phone
    return name, min(first, neighbour[1]), frames + neighbour[2], score + neighbour[3]


def _decode(decoder: Decoder, audio: bytes) -> None:
    """Decode from the state of a new decoder: pocketsphinx 5.1 calls `start_stream` deprecated and unnecessary, but
    without it ten of 26 recordings were decoded differently after others."""
    decoder.start_stream()
    decoder.start_utt()
    decoder.process_raw(audio, full_utt=True)
    decoder.end_utt()


if __name__ == "__main__":
    main(sys.stdin.buffer, sys.stdout.buffer)
