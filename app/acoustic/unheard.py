"""A line without a recording, as far as one could hear it: words at usual times, or at those of a synthesizer, their
stress by length and marks of emphasis, a neutral voice (Hartmann, Mancini & Pelachaud 2002, §5, whose agent speaks by a
synthesizer).

Where only the text is known, each phrase between pauses has its accent on the word that the text marks as emphasized,
else on its last content word (the nuclear stress rule, Chomsky & Halle 1968); other content words stand over function
words. In a synthesizer's times accents can be heard by their length (`understudy.acoustic.stress`). Words
that the text marks share the line's focus; without marks the focus is not known.
"""

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..errors import TooLargeError
from ..model import (
    FRAME_SHIFT_S,
    NEUTRAL,
    AffectTrack,
    Agitation,
    Contours,
    Filler,
    Level,
    LineAffect,
    Notice,
    Parse,
    PhraseAffect,
    Speaking,
    Timings,
    Utterance,
    Word,
)
from .affect.line_affect import given_line, phrases_of
from .affect.manner import unheard_manners
from .alignment.timings import read_fillers, read_timings
from .models import AcousticModels
from .pacing.word_times import paced, timed_elsewhere
from .stress import PAUSE_S, Measure, prominence, with_emphasis


@dataclass(frozen=True, slots=True)
class UnheardLine:
    """Words that nobody has spoken, with their times, and how long the line lasts; `emphasized` are those that the text
    marks, `is_synthesized` says whether the times are a synthesizer's."""

    words: tuple[Word, ...]
    duration_s: float
    emphasized: frozenset[int]
    notices: tuple[Notice, ...]
    fillers: tuple[Filler, ...] = ()
    is_synthesized: bool = False
    signal: None = None


def pace_words(
    acoustic: AcousticModels, transcript: tuple[Word, ...], speaking: Speaking, timings: Timings | None = None
) -> UnheardLine:
    """The words of a line without a recording, with the times of a synthesizer if the caller gave them, else with usual
    ones.

    Raises InputError as `align_words` does, TooLargeError `text_too_long` for a line that would last too long,
    AuthoringError for the files of usual times.
    """
    limit_s, pace = acoustic.settings.max_audio_s, acoustic.when_pacing.get()
    read = acoustic.aligner.read(transcript)
    emphasized = speaking.emphasized | read.capitalized
    fillers: tuple[Filler, ...] = ()
    if timings is None:
        line = paced(pace, read.words, replace(speaking, emphasized=emphasized), read.abbreviated)
        if line.duration_s > limit_s:
            message = (
                f"at an average speaking rate the text lasts {line.duration_s:.0f} s; at most {limit_s:g} s are allowed"
            )
            raise TooLargeError("text_too_long", message, field="text")
    else:
        timed = read_timings(timings.content, timings.format, transcript, duration_s=limit_s)
        line = timed_elsewhere(pace, timed, read.words)
        fillers = read_fillers(timings.content, timings.format, duration_s=limit_s)
    notices = (*_unread_tags(speaking), *read.notices)
    return UnheardLine(line.words, line.duration_s, emphasized, notices, fillers, is_synthesized=timings is not None)


def _unread_tags(speaking: Speaking) -> tuple[Notice, ...]:
    """A notice of tags that say nothing here."""
    if not speaking.unread_tags:
        return ()
    names = ", ".join(f"<{name}>" for name in speaking.unread_tags)
    return (Notice("tags_unread", f"unknown tags, of which only the content is read: {names}"),)


def unheard_utterance(
    acoustic: AcousticModels,
    line: UnheardLine,
    parse: Parse,
    *,
    agitation: Level | None = None,
    affect: AffectTrack | None = None,
) -> Utterance:
    """The utterance of a line that nobody has spoken: the voice is calm and neutral unless they are given."""
    words = _stressed(acoustic, line, parse)
    level = Agitation.certain(agitation or Level.MEDIUM)
    feeling = _neutral(words) if affect is None else given_line(affect, words, line.duration_s)
    return Utterance(
        words=words,
        parse=parse,
        agitation=level,
        duration_s=line.duration_s,
        fillers=line.fillers,
        affect=feeling,
        manners=unheard_manners(line.words, level, feeling, line.emphasized),
    )


def _stressed(acoustic: AcousticModels, line: UnheardLine, parse: Parse) -> tuple[Word, ...]:
    """The words of the line with their prominence, emphasis and focus."""
    words, marked = line.words, line.emphasized
    stressed = timed_stress(words, marked) if line.is_synthesized else usual_stress(words, parse, marked)
    return with_emphasis(stressed, Measure(acoustic.settings.emphasis))


def _neutral(words: tuple[Word, ...]) -> LineAffect:
    """The feeling of a line that nobody has spoken."""
    return LineAffect(NEUTRAL, tuple(PhraseAffect(first, last, NEUTRAL) for first, last in phrases_of(words)))


CONTENT = frozenset({"NOUN", "PROPN", "VERB", "ADJ", "ADV", "NUM", "INTJ"})
"""Parts of speech of content words (Universal Dependencies)."""

MARKED, NUCLEAR, ACCENTED, WEAK = 0.95, 0.6, 0.3, 0.1
"""The prominence of a marked word, of a phrase's last content word, of other content words and of function words. Only
the first two are above the threshold of emphasis, as of spoken words about one in five is."""


def usual_stress(words: tuple[Word, ...], parse: Parse, emphasized: Collection[int]) -> tuple[Word, ...]:
    """The words at usual times, with their prominence and focus."""
    content = {token.word for token in parse.tokens if token.part_of_speech in CONTENT}
    nuclei = set(_nuclei(words, content, emphasized))
    return with_focus(
        tuple(
            replace(word, prominence=_prominence(word.index, content, nuclei)) if word.interval else word
            for word in words
        ),
        emphasized,
    )


def timed_stress(words: tuple[Word, ...], emphasized: Collection[int]) -> tuple[Word, ...]:
    """The words at a synthesizer's times, with their prominence and focus."""
    return with_focus(prominence(words, _silence(words)), emphasized)


def with_focus(words: tuple[Word, ...], emphasized: Collection[int]) -> tuple[Word, ...]:
    """The words, with the focus shared among those that are emphasized, which are prominent."""
    marked = {word.index for word in words if word.index in emphasized and word.interval}
    return tuple(
        replace(
            word,
            prominence=max(word.prominence or 0.0, MARKED) if word.index in marked else word.prominence,
            focus=(1 / len(marked) if word.index in marked else 0.0) if marked else None,
        )
        for word in words
    )


def _nuclei(words: tuple[Word, ...], content: Collection[int], emphasized: Collection[int]) -> Iterator[int]:
    """The last content word of each phrase in which no word is emphasized; its last word if there is no other."""
    for phrase in _phrases(words):
        if not any(index in emphasized for index in phrase):
            yield max((index for index in phrase if index in content), default=phrase[-1])


def _phrases(words: tuple[Word, ...]) -> Iterator[list[int]]:
    """The timed words between pauses."""
    phrase: list[int] = []
    end_s = 0.0
    for word in words:
        if word.interval is None:
            continue
        if phrase and word.interval.start_s - end_s > PAUSE_S:
            yield phrase
            phrase = []
        phrase.append(word.index)
        end_s = word.interval.end_s
    if phrase:
        yield phrase


def _prominence(index: int, content: Collection[int], nuclei: Collection[int]) -> float:
    if index in nuclei:
        return NUCLEAR
    return ACCENTED if index in content else WEAK


def _silence(words: tuple[Word, ...]) -> Contours:
    """Contours in which nothing stands out, over all of the words."""
    end_s = max((word.interval.end_s for word in words if word.interval), default=0.0)
    count = round(end_s / FRAME_SHIFT_S) + 1
    return Contours(np.zeros(count), np.zeros(count), np.empty((count, 0)), np.empty((count, 0), dtype=np.float32))
