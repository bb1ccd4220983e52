"""When the words of a line begin, in seconds, and how slowly they are said, heard or not."""

from itertools import accumulate

from ...model import Utterance

USUAL_WORD_S = 0.3
"""Seconds a word, with the pauses, where nothing was heard."""

SLOWEST, FASTEST = 2.0, 0.6
"""Pauses and haste count up to these multiples of the usual time of a word."""


def usual_times_s(count: int) -> list[float]:
    """The times of words of which none was heard."""
    return [word * USUAL_WORD_S for word in range(count)]


def times_s_of(utterance: Utterance) -> list[float]:
    """The times at which the words begin; a word that was not heard has the time of the one before it, and where none
    was heard, all have usual times."""
    begun = [word.interval.start_s if word.interval else 0.0 for word in utterance.words]
    return list(accumulate(begun, max)) if any(begun) else usual_times_s(len(begun))


def pace_of(utterance: Utterance) -> float:
    """How long a word takes, pauses included, relative to the usual; 1 where nothing was heard."""
    heard = [word.interval for word in utterance.words if word.interval]
    if len(heard) < 2:
        return 1.0
    of_word_s = (heard[-1].end_s - heard[0].start_s) / len(heard)
    return min(max(of_word_s / USUAL_WORD_S, FASTEST), SLOWEST)
