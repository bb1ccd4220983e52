"""Aligns long audio in pieces, and speech beside sounds that last too long to be speech.

Decoding time grows with the square of the number of words. So the decoder first makes a rough pass over a stretch of
many sentences, with more words than can be spoken in it, and reports their times. The stretch is cut in clear pauses
between words, and each piece is then aligned as a line of its own; the rest after the last cut begins the next stretch.
Cuts do not depend on loudness, so music or noise between sentences does not matter.

Music before a line, a horn or a hissing pause is taken for a vowel or for breath. Where a phone or filler is that long,
all but its end, where the actual sound may be, is silenced, and the audio is decoded again. For a vowel that really is
that long ("Nooo!") the surrounding words fit equally well before and after, so only a clearly better alignment is kept;
for sounds that nobody can sustain, an equally good one is kept too.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from ...model import SAMPLE_RATE_HZ, FloatArray
from .decoder_process import (
    FRAME_SAMPLES,
    FRAMES_PER_S,
    PADDING_FRAMES,
    DecodedLine,
    DecodedPhone,
    DecoderProcess,
    FrameSpan,
    Pronunciations,
    pcm,
)

STRETCH_FRAMES = 30 * FRAMES_PER_S
PIECE_FRAMES = 12 * FRAMES_PER_S
"""The preferred maximum length of a piece, if there is a pause to cut in."""

LONGEST_WHOLE_S = 40.0
"""Shorter audio is aligned in one piece, since more context makes the decoder more reliable."""

CLEAR_PAUSE_FRAMES = FRAMES_PER_S // 5
UNSURE_FRAMES = 2 * FRAMES_PER_S
"""Words this close to the end of a stretch may change with what follows."""

MOST_PHONES_PER_S = 25.0
"""An upper limit of speaking rate."""

MOST_SILENCINGS = 2
LONGEST_SOUND_S = 0.8
LONGEST_SOUND_FRAMES = round(LONGEST_SOUND_S * FRAMES_PER_S)
KEPT_FRAMES = round(0.15 * FRAMES_PER_S)
CLEARLY_BETTER = 3.0
"""In score per frame, averaged over phones: phones squeezed together to make room for music fit very badly."""

_NEVER_LONG = frozenset({"P", "T", "K", "B", "D", "G", "CH", "JH", "HH", "um", "uh"})


@dataclass(frozen=True, slots=True)
class Cut:
    """The end of a piece: the number of words before it, and its frame."""

    words: int
    frame: int


def decode_in_pieces(
    process: DecoderProcess, samples: FloatArray, words: Sequence[Pronunciations]
) -> DecodedLine | None:
    """The phones of all `words`, in frames from the first sample; None if the decoder finds no path.

    Raises as `DecoderProcess.align` does; its time limit applies to each piece.
    """
    found: list[list[DecodedPhone]] = []
    fillers: list[DecodedPhone] = []
    for start, end in pairwise(_cuts(process, samples, words)):
        piece = samples[start.frame * FRAME_SAMPLES : end.frame * FRAME_SAMPLES]
        said = words[start.words : end.words]
        if not said:
            continue
        if len(_sayable(said, len(piece) / SAMPLE_RATE_HZ)) < len(said):
            return None
        decoded = decode_speech(process, piece, said)
        if decoded is None:
            return None
        decoded = decoded.delayed(start.frame)
        found += decoded.words
        fillers += decoded.fillers
    return DecodedLine(found, fillers)


def cuts_in_pauses(spans: Sequence[FrameSpan], frames: int) -> list[Cut]:
    """Where to cut a stretch of this many frames, given the words found in it, up to where these are reliable.

    Each piece ends in the last clear pause that keeps it within `PIECE_FRAMES`, or in the next one. Without a clear
    pause the stretch ends in its longest one; without words, where the unreliable part begins.
    """
    sure = frames - UNSURE_FRAMES
    words = np.cumsum([span.is_word for span in spans], dtype=int).tolist()
    pauses = [
        (following.first_frame - span.end_frame, Cut(count, min((span.end_frame + following.first_frame) // 2, sure)))
        for count, (span, following) in zip(words, pairwise([*spans, FrameSpan(False, frames, 0)]), strict=True)
        if span.end_frame <= sure
    ]
    clear = [cut for length, cut in pauses if length >= CLEAR_PAUSE_FRAMES]
    if not clear:
        return [max(pauses, key=lambda pause: pause[0])[1] if pauses else Cut(0, sure)]
    cuts = [Cut(0, 0)]
    for cut, following_cut in pairwise(clear):
        if following_cut.frame - cuts[-1].frame > PIECE_FRAMES:
            cuts.append(cut)
    return [*cuts[1:], clear[-1]]


def _cuts(process: DecoderProcess, samples: FloatArray, words: Sequence[Pronunciations]) -> Iterator[Cut]:
    """The beginning, every cut, and the end."""
    frames = -(-len(samples) // FRAME_SAMPLES)
    last = Cut(0, 0)
    yield last
    while last.words < len(words) and frames - last.frame > LONGEST_WHOLE_S * FRAMES_PER_S:
        stretch = samples[last.frame * FRAME_SAMPLES :][: STRETCH_FRAMES * FRAME_SAMPLES]
        heard = process.find(pcm(stretch), _sayable(words[last.words :], STRETCH_FRAMES / FRAMES_PER_S))
        spans = [replace(span, first_frame=span.first_frame - PADDING_FRAMES) for span in heard]
        before = last
        for cut in cuts_in_pauses(spans, STRETCH_FRAMES):
            last = Cut(before.words + cut.words, before.frame + cut.frame)
            yield last
    yield Cut(len(words), frames)


def _sayable(words: Sequence[Pronunciations], duration_s: float) -> Sequence[Pronunciations]:
    """The first words, as many as can be spoken in this time."""
    counts = np.cumsum([len(variants[0].split()) for variants in words])
    return words[: int(np.searchsorted(counts, MOST_PHONES_PER_S * duration_s, side="right"))]


def decode_speech(process: DecoderProcess, samples: FloatArray, words: Sequence[Pronunciations]) -> DecodedLine | None:
    """The phones of the words, in frames from the first sample, none of them stretched over music or a pause; None if
    the decoder finds no path.

    Raises as `DecoderProcess.align` does.
    """
    decoded = _decoded(process, samples, words)
    for _ in range(MOST_SILENCINGS):
        rest = silenced(samples, decoded) if decoded else None
        again = None if rest is None else _decoded(process, rest, words)
        if rest is None or decoded is None or again is None or not fits_better(again, decoded):
            break
        samples, decoded = rest, again
    return decoded


def _decoded(process: DecoderProcess, samples: FloatArray, words: Sequence[Pronunciations]) -> DecodedLine | None:
    decoded = process.align(pcm(samples), words)
    return decoded.delayed(-PADDING_FRAMES) if decoded else None


def silenced(samples: FloatArray, decoded: DecodedLine) -> FloatArray | None:
    """The signal without the sounds that are too long in `decoded`; None if there are none."""
    long = _too_long(decoded)
    if not long:
        return None
    rest = samples.copy()
    for each in long:
        end = each.first_frame + each.frames - KEPT_FRAMES
        rest[max(each.first_frame, 0) * FRAME_SAMPLES : end * FRAME_SAMPLES] = 0.0
    return rest


def fits_better(one: DecodedLine, other: DecodedLine) -> bool:
    """Whether `one` fits its audio clearly better than `other`, or as well and without sounds that nobody can
    sustain."""
    gain = _mean_score(one) - _mean_score(other)
    was_no_speech = any(each.label in _NEVER_LONG for each in _too_long(other))
    return gain > CLEARLY_BETTER or (was_no_speech and gain > -CLEARLY_BETTER)


def _too_long(decoded: DecodedLine) -> list[DecodedPhone]:
    sounds = [phone for word in decoded.words for phone in word] + decoded.fillers
    return [each for each in sounds if each.frames > LONGEST_SOUND_FRAMES]


def _mean_score(decoded: DecodedLine) -> float:
    return float(np.mean([phone.score / phone.frames for word in decoded.words for phone in word]))
