"""Runs all stages of a line in order: the paper's Figure 2, up to the schedule.

Every stage is a pure function over the values of `understudy.model`; what stages need besides (models, rules, tables)
is loaded once into an `Understudy` and never changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .acoustic.affect.given import given_line
from .acoustic.stage import AcousticModels, align_words, analyze_signal, hear_affect, hear_manners, measure_stress
from .behavior.candidates.notes import check_direction, conflicts
from .edits.values import WordEdit
from .edits.word_times import corrected
from .errors import InputError
from .model import (
    AffectTrack,
    Agitation,
    Analysis,
    Direction,
    Level,
    Line,
    LineAffect,
    Notice,
    Performance,
    SignalAnalysis,
    Utterance,
    Word,
)
from .model.speaker_reference import SpeakerReference
from .models import Understudy
from .moving import move
from .options import Options
from .profiles.generation.script import GestureScript
from .progress import Progress, no_progress
from .rules.derivation import understand
from .transcript import read_transcript


def perform(understudy: Understudy, line: Line, options: Options, progress: Progress = no_progress) -> Performance:
    """The performance of a recorded line (paper §3, Figure 2).

    Raises InputError for audio, text, timings, functions, notes or options that cannot be used.
    """
    return perform_heard(understudy, line, options, progress)[1]


def perform_heard(
    understudy: Understudy, line: Line, options: Options, progress: Progress = no_progress
) -> tuple[Analysis, Performance]:
    """The analysis of a line and its performance; raises as `perform` does."""
    analysis, direction_notices = _heard(understudy, line, options, progress)
    performance = perform_analysis(understudy, analysis, options, line.direction, progress)
    return analysis, replace(performance, notices=direction_notices + performance.notices)


def perform_analysis(
    understudy: Understudy,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
) -> Performance:
    """The performance of an analysed line (paper §3.4, §3.5), with a director's notes applied."""
    return move(understudy.behavior, analysis, options, direction, progress)[0]


def write_script(
    understudy: Understudy, line: Line, options: Options, progress: Progress = no_progress
) -> tuple[Performance, GestureScript]:
    """The performance of a recorded line and the gesture script that its hands follow, by the profile of the options
    (NGS §3.3); raises as `perform` does, and InputError `value_wrong` where there is no profile."""
    analysis, direction_notices = _heard(understudy, line, options, progress)
    performance, script = script_analysis(understudy, analysis, options, line.direction)
    return replace(performance, notices=direction_notices + performance.notices), script


def script_analysis(
    understudy: Understudy, analysis: Analysis, options: Options, direction: Direction | None = None
) -> tuple[Performance, GestureScript]:
    """The same for an analysed line."""
    performance, script = move(understudy.behavior, analysis, options, direction)
    if script is None:
        raise InputError("value_wrong", "profile: a gesture script is written by a profile; name one", field="profile")
    return performance, script


def _heard(
    understudy: Understudy, line: Line, options: Options, progress: Progress
) -> tuple[Analysis, tuple[Notice, ...]]:
    """The analysis, and notices of contradictions in a director's notes; names are checked first."""
    understudy.behavior.characters.named(options.character)
    understudy.behavior.profile(options.profile)
    notices = _checked_direction(understudy, line)
    analysis = analyze(
        understudy,
        line,
        agitation=options.agitation,
        affect=options.affect,
        reference=options.reference,
        edits=options.edits.words,
        progress=progress,
    )
    return analysis, notices


def _checked_direction(understudy: Understudy, line: Line) -> tuple[Notice, ...]:
    """Notices of contradictions in a director's notes; raises InputError where the notes do not fit the words."""
    if line.direction is None:
        return ()
    limit = understudy.language.settings.max_text_characters
    check_direction(line.direction, words=len(read_transcript(line.text, max_characters=limit)))
    return conflicts(line.direction)


def analyze(
    understudy: Understudy,
    line: Line,
    *,
    agitation: Level | None = None,
    affect: AffectTrack | None = None,
    reference: SpeakerReference | None = None,
    edits: Sequence[WordEdit] = (),
    progress: Progress = no_progress,
) -> Analysis:
    """The analysis of a recorded line (paper §3.1 to §3.3); an author's `edits` correct word times."""
    acoustic, language = understudy.acoustic, understudy.language
    transcript = read_transcript(line.text, max_characters=language.settings.max_text_characters)
    heard = analyze_signal(acoustic, line.audio, progress, reference=reference)
    progress("align")
    timed = align_words(acoustic, heard.audio, transcript, line.timings)
    words, edit_notices = corrected(timed.words, edits, duration_s=heard.audio.duration_s)
    progress("stress")
    words, thresholds = measure_stress(acoustic, words, heard.contours, heard.audio)
    progress("parse")
    level = _certain(agitation) if agitation else heard.agitation
    feeling = _feeling(acoustic, heard, words, affect, reference)
    utterance = Utterance(
        words=words,
        parse=language.parser.parse(words),
        agitation=level,
        thresholds=thresholds,
        duration_s=heard.audio.duration_s,
        fillers=timed.fillers,
        affect=feeling,
        manners=hear_manners(heard, words, level, feeling),
    )
    progress("functions")
    known = understand(language.rules, utterance, given=line.functions)
    return Analysis(utterance, known.functions, heard.notices + timed.notices + edit_notices, heard, known.facts)


def _feeling(
    acoustic: AcousticModels,
    heard: SignalAnalysis,
    words: tuple[Word, ...],
    given: AffectTrack | None,
    reference: SpeakerReference | None,
) -> LineAffect:
    """The feeling that is given, else the one that is heard."""
    if given is not None:
        return given_line(given, words, heard.audio.duration_s)
    return hear_affect(acoustic, heard, words, reference)


def _certain(level: Level) -> Agitation:
    """Full membership in the level that the caller gave."""
    return Agitation(**{name.value: float(name is level) for name in Level})
