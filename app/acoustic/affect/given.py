"""The feeling of a line and its phrases where an author gives it instead of what is heard."""

import math

from ...model import Affect, AffectTrack, Interval, LineAffect, PhraseAffect, Word, mean_affect
from .phrases import phrase_interval, phrases_of

STEP_S = 0.05
"""How finely a track is averaged over a phrase."""


def given_line(track: AffectTrack, words: tuple[Word, ...], duration_s: float) -> LineAffect:
    """The feeling of the line and of its phrases as the track has it."""
    phrases = tuple(
        PhraseAffect(first, last, _between(track, phrase_interval(words, first, last)))
        for first, last in phrases_of(words)
    )
    return LineAffect(_between(track, Interval(0.0, duration_s)), phrases, given=True)


def _between(track: AffectTrack, interval: Interval) -> Affect:
    """The mean feeling over an interval."""
    if len(track.times_s) == 1:
        return track.affects[0]
    count = max(1, math.ceil(interval.duration_s / STEP_S))
    places = [interval.start_s + (place + 0.5) * interval.duration_s / count for place in range(count)]
    return mean_affect([track.at(place_s) for place_s in places], [1.0] * count)
