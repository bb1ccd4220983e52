"""Hears the feeling of a line, and of each of its phrases; or takes both from an author who gives them.

Phrases are the words between pauses, each of which may sound different. Short ones join the next: what is heard in less
than half a second says little about a feeling. A phrase is short, so what it sounds like counts by its length, and the
line's feeling for the rest.

A stretch of a recording with what is measured in it, of which shorter stretches can be taken.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import Protocol

from ...model import (
    FRAME_SHIFT_S,
    SAMPLE_RATE_HZ,
    Affect,
    AffectTrack,
    Audio,
    Contours,
    FloatArray,
    Interval,
    LineAffect,
    PhraseAffect,
    VoiceQuality,
    Word,
    mean_affect,
)
from ...model.voice.signal import SpeakerReference
from ..agitation.utterance_features import full_features
from .affect_model import AffectModel

SHORTEST_PAUSE_S = 0.25
SHORTEST_PHRASE_S = 0.6

HALF_TRUSTED_S = 0.8
"""A phrase so long counts as much as the line does."""

STEP_S = 0.05
"""How finely a track is averaged over a phrase."""


def phrases_of(words: tuple[Word, ...]) -> tuple[tuple[int, int], ...]:
    """First and last word of each phrase, in order; none if no word has a time. A word that is not spoken belongs to
    the phrase before it."""
    starts = list(_starts(words))
    return tuple(zip(starts, [*(start - 1 for start in starts[1:]), len(words) - 1], strict=True)) if starts else ()


def phrase_interval(words: tuple[Word, ...], first: int, last: int) -> Interval:
    """From the start of its first word to the end of its last; at least one of them has a time."""
    timed = [word.interval for word in words[first : last + 1] if word.interval]
    return Interval(timed[0].start_s, timed[-1].end_s)


def _starts(words: tuple[Word, ...]) -> Iterator[int]:
    """The first word of each phrase; the first phrase has the words before it too."""
    timed = [(word.index, word.interval) for word in words if word.interval]
    if not timed:
        return
    yield 0
    begun_s, end_s = timed[0][1].start_s, timed[-1][1].end_s
    for (_, before), (index, after) in pairwise(timed):
        long_enough = before.end_s - begun_s >= SHORTEST_PHRASE_S and end_s - after.start_s >= SHORTEST_PHRASE_S
        if after.start_s - before.end_s >= SHORTEST_PAUSE_S and long_enough:
            begun_s = after.start_s
            yield index


@dataclass(frozen=True, slots=True, eq=False)
class Stretch:
    """Sound with its contours and voice quality, frame by frame; `described` are its features, if they are known."""

    audio: Audio
    contours: Contours
    quality: VoiceQuality
    described: FloatArray | None = None

    @property
    def duration_s(self) -> float:
        return self.audio.duration_s

    def between(self, interval: Interval) -> "Stretch | None":
        """The part in an interval; None if it is too short to be described."""
        first, last = (round(time_s / FRAME_SHIFT_S) for time_s in (interval.start_s, interval.end_s))
        frames = slice(max(first, 0), last)
        if len(self.contours.energy_db[frames]) < FEWEST_FRAMES:
            return None
        start, end = (round(time_s * SAMPLE_RATE_HZ) for time_s in (interval.start_s, interval.end_s))
        return Stretch(
            Audio(self.audio.samples[max(start, 0) : end]),
            Contours(**{each.name: getattr(self.contours, each.name)[frames] for each in fields(Contours)}),
            VoiceQuality(**{each.name: getattr(self.quality, each.name)[frames] for each in fields(VoiceQuality)}),
        )

    def features(self) -> FloatArray:
        """The features of affect, NaN where unknown."""
        return full_features(self.contours, self.quality) if self.described is None else self.described


class AffectJudge(Protocol):
    """What tells the feeling of a stretch: our model, or a user's."""

    def affect_of(self, stretch: Stretch, reference: SpeakerReference | None = None) -> Affect:
        """The feeling, relative to the speaker's usual voice where that is known."""
        ...


class FeatureJudge:
    """Our model, which knows a stretch by its features."""

    def __init__(self, model: AffectModel) -> None:
        self._model = model

    def affect_of(self, stretch: Stretch, reference: SpeakerReference | None = None) -> Affect:
        """Raises InputError `reference_other_features`."""
        return self._model.affect(stretch.features(), reference)


def line_affect(
    judge: AffectJudge,
    stretch: Stretch,
    heard: Affect,
    words: tuple[Word, ...],
    reference: SpeakerReference | None = None,
) -> LineAffect:
    """The feeling of the phrases of a line, whose whole `stretch` was `heard` so."""
    return LineAffect(heard, tuple(_phrase_affects(judge, stretch, heard, words, reference)))


def _phrase_affects(
    judge: AffectJudge,
    stretch: Stretch,
    heard: Affect,
    words: tuple[Word, ...],
    reference: SpeakerReference | None,
) -> Iterator[PhraseAffect]:
    phrases = phrases_of(words)
    for first, last in phrases:
        part = stretch.between(phrase_interval(words, first, last)) if len(phrases) > 1 else None
        if part is None:
            yield PhraseAffect(first, last, heard)
            continue
        alone = judge.affect_of(part, reference)
        yield PhraseAffect(first, last, mean_affect([alone, heard], [part.duration_s, HALF_TRUSTED_S]))


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


FEWEST_FRAMES = 30
"""What is shorter is not described."""
