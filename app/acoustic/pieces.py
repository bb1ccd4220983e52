"""Aligns long audio piece by piece: the decoder's time grows with the square of the words it is given at once.

Each piece is given more words than it can hold; the decoder says how many of them it heard before a pause, and the next
piece begins in that pause. Nothing is cut by loudness, so music or noise between sentences does not matter.
"""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from app.acoustic.decoder_process import Decoded, DecodedPhone, DecoderProcess
from app.model import SAMPLE_RATE_HZ, FloatArray

FRAMES_PER_S = 125
FRAME_SAMPLES = SAMPLE_RATE_HZ // FRAMES_PER_S
PADDING_FRAMES = 25
PIECE_S = 16.0
LONGEST_WHOLE_S = 40.0
"""Audio that is no longer is one piece, for the wider the decoder's view, the surer it is."""

MOST_PHONES_PER_S = 25.0
"""Nobody speaks faster."""

PEAK = 0.9
NOISE_AMPLITUDE = 3e-4
NOISE_SEED = 20_200

Pronunciations = Sequence[str]
"""The ways in which a word may be said, each phones between spaces."""


def decode_in_pieces(process: DecoderProcess, samples: FloatArray, words: Sequence[Pronunciations]) -> Decoded | None:
    """The phones of all `words`, frames counted from the first sample; None when the decoder finds no path.

    Raises what `DecoderProcess.align` does; its time limit holds for each piece.
    """
    found: list[list[DecodedPhone]] = []
    fillers: list[DecodedPhone] = []
    begin = 0
    while len(found) < len(words):
        piece = samples[begin * FRAME_SAMPLES :]
        more = len(piece) > LONGEST_WHOLE_S * SAMPLE_RATE_HZ
        if more:
            piece = piece[: round(PIECE_S * SAMPLE_RATE_HZ)]
        sayable = _sayable(words[len(found) :], len(piece) / SAMPLE_RATE_HZ)
        if not more and len(found) + len(sayable) < len(words):
            return None
        decoded = process.align(pcm(piece), sayable, more=more)
        if decoded is None:
            return None
        shift = begin - PADDING_FRAMES
        found += [[_later(phone, shift) for phone in word] for word in decoded.words]
        fillers += [_later(filler, shift) for filler in decoded.fillers]
        begin += decoded.end_frame - PADDING_FRAMES
    return Decoded(found, fillers, math.ceil(len(samples) / FRAME_SAMPLES))


def pcm(samples: FloatArray) -> bytes:
    """The signal as the decoder wants it: loud, 16-bit, between two stretches of faint noise, always the same."""
    noise = np.random.default_rng(NOISE_SEED).standard_normal(2 * PADDING_FRAMES * FRAME_SAMPLES) * NOISE_AMPLITUDE
    before, after = np.split(noise, 2)
    peak = float(np.abs(samples).max(initial=0.0)) or 1.0
    padded = np.concatenate([before, samples * (PEAK / peak), after])
    return (padded * 32767).round().astype("<i2").tobytes()


def _sayable(words: Sequence[Pronunciations], duration_s: float) -> Sequence[Pronunciations]:
    """The first of the words, as many as can be said in this time."""
    counts = np.cumsum([len(variants[0].split()) for variants in words])
    return words[: int(np.searchsorted(counts, MOST_PHONES_PER_S * duration_s, side="right"))]


def _later(phone: DecodedPhone, frames: int) -> DecodedPhone:
    return replace(phone, first_frame=phone.first_frame + frames)
