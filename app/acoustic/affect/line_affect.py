"""Hears the feeling of a line, and of each of its phrases.

A phrase is short, so what it sounds like counts by its length, and the line's feeling for the rest.
"""

from collections.abc import Iterator
from typing import Protocol

from ...model import Affect, LineAffect, PhraseAffect, Word, mean_affect
from ...model.voice.speaker_reference import SpeakerReference
from .affect_model import AffectModel
from .phrases import phrase_interval, phrases_of
from .stretch import Stretch

HALF_TRUSTED_S = 0.8
"""A phrase so long counts as much as the line does."""


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
