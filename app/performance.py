"""Runs all stages of a line in order: the paper's Figure 2, up to the schedule.

Read `analyze`, then `perform_behaviors`, its two halves, in which a line is a stage; `perform_line` joins them. Every
stage is a pure function over the values of `understudy.model`; what stages need besides (models, rules, tables) is
loaded once into an `Understudy` and never changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from .acoustic.affect.line_affect import given_line
from .acoustic.stage import (
    AcousticModels,
    align_words,
    analyze_signal,
    hear_affect,
    hear_manners,
    measure_stress,
)
from .acoustic.unheard import pace_words, stress_unheard, unheard_affect, unheard_manner
from .behavior.candidates.notes import check_direction, conflicts
from .behavior.choice.offered import NEAR
from .behavior.idle.stillness import with_stillness
from .behavior.stage import (
    Performer,
    assemble,
    meanings_at,
    offer_candidates,
    performer_of,
    plan_line,
    schedule_line,
    with_listeners,
)
from .bml.writing.writer import losses
from .edits.applying import edited
from .edits.words import corrected, marked, unmarked, with_marked
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
    Speaking,
    Utterance,
    Word,
)
from .model.edits import WordEdit, WordMark
from .model.lead_in import with_lead_in
from .model.voice.signal import SpeakerReference
from .models import BehaviorModels, Understudy
from .options import Options
from .profiles.generation.script import GestureScript
from .progress import Progress, no_progress
from .rules.derivation import understand
from .rules.mapping import map_functions
from .transcript import read_transcript


@dataclass(frozen=True, slots=True)
class PerformedLine:
    """A line's analysis and performance, and the gesture script that its hands follow if the options name a profile."""

    analysis: Analysis
    performance: Performance
    script: GestureScript | None = None

    def written_script(self) -> GestureScript:
        """The gesture script (NGS §3.3); raises InputError `value_wrong` where the options name no profile."""
        if self.script is None:
            message = "profile: a gesture script is written by a profile; name one"
            raise InputError("value_wrong", message, field="profile")
        return self.script


def perform_line(
    understudy: Understudy, line: Line, options: Options, progress: Progress = no_progress
) -> PerformedLine:
    """The whole way of a recorded line (paper §3, Figure 2).

    Raises InputError for audio, text, timings, functions, notes or options that cannot be used; names and notes are
    checked before anything is heard.
    """
    understudy.behavior.characters.named(options.character)
    understudy.behavior.profile(options.profile)
    contradictions = _checked_direction(understudy, line)
    analysis = analyze(
        understudy,
        line,
        agitation=options.agitation,
        affect=options.affect,
        reference=options.reference,
        edits=options.edits.words,
        progress=progress,
    )
    performed = perform_behaviors(understudy.behavior, analysis, options, line.direction, progress)
    performance = performed.performance
    return replace(performed, performance=replace(performance, notices=contradictions + performance.notices))


def perform_behaviors(
    models: BehaviorModels,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
    *,
    near: float = NEAR,
) -> PerformedLine:
    """The second half of Figure 2: from an analysed line to its behaviours (paper §3.4, §3.5), with a director's notes.
    Among the behaviours is what was offered and came so `near` (log-odds) to being shown.

    Raises InputError `unknown_character`, `unknown_profile`.
    """
    progress("plan")
    performer = replace(_performer(models, analysis, options, direction), near=near)
    planned = plan_line(performer)
    progress("mapping")
    candidates, moments = offer_candidates(performer, planned)
    progress("schedule")
    timed = replace(analysis, utterance=with_lead_in(analysis.utterance, options.lead_in_s))
    behaviors, script = schedule_line(performer, timed, planned, candidates)
    performance = assemble(performer, timed, moments, behaviors)
    performance = edited(performance, options.edits.behaviors, performer.character)
    performance = with_listeners(models, performance, options)
    performance = with_stillness(performance, options.stillness)
    lost = (*unmarked(options.edits.words, timed.utterance.words), *losses(performance, options.form))
    return PerformedLine(analysis, replace(performance, notices=(*performance.notices, *lost)), script)


def perform(understudy: Understudy, line: Line, options: Options, progress: Progress = no_progress) -> Performance:
    """The performance of a recorded line; raises as `perform_line` does."""
    return perform_line(understudy, line, options, progress).performance


def perform_analysis(
    understudy: Understudy,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
) -> Performance:
    """The performance of an analysed line (paper §3.4, §3.5), with a director's notes applied."""
    return perform_behaviors(understudy.behavior, analysis, options, direction, progress).performance


def _performer(models: BehaviorModels, analysis: Analysis, options: Options, direction: Direction | None) -> Performer:
    """Who performs the line, with what the mapping rules offer (paper §3.4) and the words that the author marked."""
    mapped = map_functions(
        models.rules, analysis.utterance, analysis.functions, seed=options.seed, facts=analysis.facts
    )
    performer = performer_of(
        models, analysis, options, offers=mapped.offers, demands=mapped.demands, direction=direction
    )
    edits, words = options.edits.words, analysis.utterance.words
    important = {index for mark, index in marked(edits, words) if mark is WordMark.IMPORTANT}
    return replace(performer, direction=with_marked(direction, edits, words, meanings_at(performer, important)))


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
    """The analysis of a line (paper §3.1 to §3.3); an author's `edits` correct word times. A line without a recording
    is timed by its words alone (`pace_words`)."""
    if line.audio is None:
        return _analyze_unheard(understudy, line, agitation=agitation, affect=affect, edits=edits, progress=progress)
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


def _analyze_unheard(
    understudy: Understudy,
    line: Line,
    *,
    agitation: Level | None,
    affect: AffectTrack | None,
    edits: Sequence[WordEdit],
    progress: Progress,
) -> Analysis:
    """The analysis of a line that nobody has spoken: its voice is calm and neutral unless the caller says otherwise."""
    language = understudy.language
    transcript = read_transcript(line.text, max_characters=language.settings.max_text_characters)
    progress("align")
    spoken = pace_words(understudy.acoustic, transcript, line.speaking, line.timings)
    words, edit_notices = corrected(spoken.words, edits, duration_s=spoken.duration_s)
    progress("parse")
    parse = language.parser.parse(words)
    progress("stress")
    timed = replace(spoken, words=words)
    words = stress_unheard(understudy.acoustic, timed, parse, timed=line.timings is not None)
    level = _certain(agitation or Level.MEDIUM)
    feeling = unheard_affect(words) if affect is None else given_line(affect, words, spoken.duration_s)
    utterance = Utterance(
        words=words,
        parse=parse,
        agitation=level,
        duration_s=spoken.duration_s,
        fillers=spoken.fillers,
        affect=feeling,
        manners=unheard_manner(timed, level, feeling),
    )
    progress("functions")
    known = understand(language.rules, utterance, given=line.functions)
    notices = (*_unread(line.speaking), *spoken.notices, *edit_notices)
    return Analysis(utterance, known.functions, notices, facts=known.facts)


def _unread(speaking: Speaking) -> tuple[Notice, ...]:
    """A notice of tags that say nothing here."""
    if not speaking.unread_tags:
        return ()
    names = ", ".join(f"<{name}>" for name in speaking.unread_tags)
    return (Notice("tags_unread", f"tags that are not read, only what is inside: {names}"),)


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
