"""The fallback if the aligner finds no path: the words are spread over the loud parts, with phones of equal length.

Word boundaries are then off by half a second on average, so there is always a notice, and each word is marked
(`Word.spread`).
"""

from dataclasses import replace

import numpy as np

from ...errors import InputError
from ...model import Audio, FloatArray, Interval, Notice, Word
from ..signal.background import FRAME_S, frame_power

BELOW_LOUDEST_DB = 30.0
MOST_PHONES_PER_S = 25.0
"""An upper limit of speaking rate."""


def spread(audio: Audio, words: tuple[Word, ...]) -> tuple[tuple[Word, ...], tuple[Notice, ...]]:
    """The words (with phones but no times) over the frames within 30 dB of the loudest, and the notice about it.

    Raises InputError `transcript_mismatch` if the audio is too short for the words.
    """
    power = frame_power(audio)
    loud_s = np.flatnonzero(power >= power.max() * 10 ** (-BELOW_LOUDEST_DB / 10)) * FRAME_S
    count = sum(len(word.phones) for word in words)
    if count > MOST_PHONES_PER_S * len(loud_s) * FRAME_S:
        raise InputError(
            "transcript_mismatch",
            f"the text has {count} speech sounds, too many for {len(loud_s) * FRAME_S:.2f} s of sound; "
            "send the words of this recording",
            field="text",
        )
    edges_s = np.interp(
        np.linspace(0, len(loud_s), count + 1), np.arange(len(loud_s) + 1), [*loud_s, loud_s[-1] + FRAME_S]
    )
    named = ", ".join(f"{word.index} ({word.text})" for word in words)
    notice = Notice(
        "alignment_low_confidence",
        f"the aligner found no way through the audio; times are guessed from loudness for word {named}",
    )
    return tuple(_placed(words, edges_s.round(3))), (notice,)


def _placed(words: tuple[Word, ...], edges_s: FloatArray) -> list[Word]:
    placed = []
    first = 0
    for word in words:
        edges = [float(edge) for edge in edges_s[first : first + len(word.phones) + 1]]
        phones = tuple(
            replace(phone, interval=Interval(start_s, end_s))
            for phone, start_s, end_s in zip(word.phones, edges, edges[1:], strict=False)
        )
        placed.append(replace(word, interval=Interval(edges[0], edges[-1]), phones=phones, spread=True))
        first += len(word.phones)
    return placed
