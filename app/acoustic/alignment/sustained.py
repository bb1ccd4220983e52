"""Handles sounds that last too long to be speech, such as music before a line, a horn or a hissing pause.

The decoder takes them for vowels or for breath. Where a phone or filler is that long, all but its end, where the actual
sound may be, is silenced, and the audio is decoded again. For a vowel that really is that long ("Nooo!") the
surrounding words fit equally well before and after, so only a clearly better alignment is kept; for sounds that nobody
can sustain, an equally good one is kept too.
"""

from collections.abc import Sequence

import numpy as np

from ...model import FloatArray
from .decoder_process import Decoded, DecodedPhone, DecoderProcess, Pronunciations
from .decoder_signal import FRAME_SAMPLES, FRAMES_PER_S, PADDING_FRAMES, pcm

MOST_SILENCINGS = 2
LONGEST_SOUND_S = 0.8
LONGEST_SOUND_FRAMES = round(LONGEST_SOUND_S * FRAMES_PER_S)
KEPT_FRAMES = round(0.15 * FRAMES_PER_S)
CLEARLY_BETTER = 3.0
"""In score per frame, averaged over phones: phones squeezed together to make room for music fit very badly."""

_NEVER_LONG = frozenset({"P", "T", "K", "B", "D", "G", "CH", "JH", "HH", "um", "uh"})


def decode_speech(process: DecoderProcess, samples: FloatArray, words: Sequence[Pronunciations]) -> Decoded | None:
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


def _decoded(process: DecoderProcess, samples: FloatArray, words: Sequence[Pronunciations]) -> Decoded | None:
    decoded = process.align(pcm(samples), words)
    return decoded.delayed(-PADDING_FRAMES) if decoded else None


def silenced(samples: FloatArray, decoded: Decoded) -> FloatArray | None:
    """The signal without the sounds that are too long in `decoded`; None if there are none."""
    long = _too_long(decoded)
    if not long:
        return None
    rest = samples.copy()
    for each in long:
        end = each.first_frame + each.frames - KEPT_FRAMES
        rest[max(each.first_frame, 0) * FRAME_SAMPLES : end * FRAME_SAMPLES] = 0.0
    return rest


def fits_better(one: Decoded, other: Decoded) -> bool:
    """Whether `one` fits its audio clearly better than `other`, or as well and without sounds that nobody can
    sustain."""
    gain = _mean_score(one) - _mean_score(other)
    was_no_speech = any(each.label in _NEVER_LONG for each in _too_long(other))
    return gain > CLEARLY_BETTER or (was_no_speech and gain > -CLEARLY_BETTER)


def _too_long(decoded: Decoded) -> list[DecodedPhone]:
    sounds = [phone for word in decoded.words for phone in word] + decoded.fillers
    return [each for each in sounds if each.frames > LONGEST_SOUND_FRAMES]


def _mean_score(decoded: Decoded) -> float:
    return float(np.mean([phone.score / phone.frames for word in decoded.words for phone in word]))
