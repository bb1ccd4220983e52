"""Sounds that last too long to be speech: music before a line, a horn in it. The decoder takes them for vowels.

Where a phone or filler is that long, its sound is silenced but for its end, where the true one may be, and the audio
is decoded again. Of a vowel that really is that long ("Nooo!") the words around fit as well before as after, so only an
alignment that fits clearly better is kept.
"""

import numpy as np

from app.acoustic.decoder_process import Decoded
from app.acoustic.pieces import FRAME_SAMPLES, FRAMES_PER_S
from app.model import FloatArray

LONGEST_SOUND_S = 0.8
LONGEST_SOUND_FRAMES = round(LONGEST_SOUND_S * FRAMES_PER_S)
KEPT_FRAMES = round(0.15 * FRAMES_PER_S)
CLEARLY_BETTER = 3.0
"""In score a frame, averaged over phones: those squeezed together to make room for music fit very badly."""


def silenced(samples: FloatArray, decoded: Decoded) -> FloatArray | None:
    """The signal without the sounds that are too long in `decoded`; None when there are none."""
    sounds = [phone for word in decoded.words for phone in word] + decoded.fillers
    long = [(each.first_frame, each.frames) for each in sounds if each.frames > LONGEST_SOUND_FRAMES]
    if not long:
        return None
    rest = samples.copy()
    for first, frames in long:
        rest[max(first, 0) * FRAME_SAMPLES : (first + frames - KEPT_FRAMES) * FRAME_SAMPLES] = 0.0
    return rest


def fits_better(one: Decoded, other: Decoded) -> bool:
    """Whether `one` fits its audio clearly better than `other` did, or as well without a filler that was too long."""
    gain = _mean_score(one) - _mean_score(other)
    fillers_were_long = any(filler.frames > LONGEST_SOUND_FRAMES for filler in other.fillers)
    return gain > CLEARLY_BETTER or (fillers_were_long and gain > -CLEARLY_BETTER)


def _mean_score(decoded: Decoded) -> float:
    return float(np.mean([phone.score / phone.frames for word in decoded.words for phone in word]))
