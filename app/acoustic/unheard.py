"""A line without a recording, as far as one could hear it: words at usual times, or at those of a synthesizer, their
stress by length and marks of emphasis, a neutral voice (Hartmann, Mancini & Pelachaud 2002, §5, whose agent speaks by a
synthesizer)."""

from dataclasses import dataclass, replace

from ..errors import TooLargeError
from ..model import NEUTRAL, Agitation, Filler, LineAffect, Manner, Notice, Parse, PhraseAffect, Speaking, Timings, Word
from .affect.line_affect import phrases_of
from .affect.manner import unheard_manners
from .alignment.timings import read_fillers, read_timings
from .pacing.pacing import paced, timed_elsewhere
from .pacing.unheard_stress import timed_stress, usual_stress
from .stage import AcousticModels
from .stress.stress import Measure, with_emphasis


@dataclass(frozen=True, slots=True)
class UnheardLine:
    """Words that nobody has spoken, with their times, and how long the line lasts; `emphasized` are
    those that the text marks."""

    words: tuple[Word, ...]
    duration_s: float
    emphasized: frozenset[int]
    notices: tuple[Notice, ...]
    fillers: tuple[Filler, ...] = ()


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
                f"spoken at a usual pace the text lasts {line.duration_s:.0f} s; at most {limit_s:g} s are allowed"
            )
            raise TooLargeError("text_too_long", message, field="text")
    else:
        timed = read_timings(timings.content, timings.format, transcript, duration_s=limit_s)
        line = timed_elsewhere(pace, timed, read.words)
        fillers = read_fillers(timings.content, timings.format, duration_s=limit_s)
    return UnheardLine(line.words, line.duration_s, emphasized, read.notices, fillers)


def stress_unheard(acoustic: AcousticModels, line: UnheardLine, parse: Parse, *, timed: bool) -> tuple[Word, ...]:
    """The words of the line with their prominence, emphasis and focus; `timed` if a synthesizer told their times."""
    words, marked = line.words, line.emphasized
    stressed = timed_stress(words, marked) if timed else usual_stress(words, parse, marked)
    return with_emphasis(stressed, Measure(acoustic.settings.emphasis))


def unheard_affect(words: tuple[Word, ...]) -> LineAffect:
    """The feeling of a line that nobody has spoken: neutral."""
    return LineAffect(NEUTRAL, tuple(PhraseAffect(first, last, NEUTRAL) for first, last in phrases_of(words)))


def unheard_manner(line: UnheardLine, agitation: Agitation, affect: LineAffect) -> tuple[Manner, ...]:
    """How a movement is made on each word of a line without a recording."""
    return unheard_manners(line.words, agitation, affect, line.emphasized)
