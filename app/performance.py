"""Runs all stages of a line in order: the paper's Figure 2, up to the schedule.

`perform_line` is the figure, a stage a line; the stages that say what is heard and meant come first, in `analyze`.
Every stage is a pure function over the values of `understudy.model`; what stages need besides (models, rules, tables)
is loaded once into an `Understudy` and never changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from .acoustic.stage import hear, with_prosody
from .behavior.candidates.notes import check_direction, conflicts
from .behavior.choice.offered import NEAR
from .behavior.idle.stillness import with_stillness
from .behavior.stage import (
    Performer,
    assemble,
    chooses_by_priority,
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
from .model import Analysis, Direction, Line, Notice, Performance
from .model.edits import WordEdit, WordMark
from .model.lead_in import with_lead_in
from .model.performance import Progress, no_progress
from .models import Understudy
from .options import AS_USUAL, Options
from .profiles.generation.script import GestureScript
from .rules.derivation import understand
from .rules.mapping import map_functions
from .rules.priorities import resolved_as_in_paper
from .text.transcript import read_transcript


@dataclass(frozen=True, slots=True)
class PerformedLine:
    """A line's analysis and performance, and the gesture script that its hands follow if the options name a profile."""

    analysis: Analysis
    performance: Performance
    script: GestureScript | None = None

    def written_script(self) -> GestureScript:
        """The gesture script (NGS §3.3); raises InputError `value_wrong` where the options name no profile."""
        if self.script is None:
            message = "profile: a gesture script needs a profile; name one"
            raise InputError("value_wrong", message, field="profile")
        return self.script


def perform_line(
    understudy: Understudy,
    line: Line,
    options: Options,
    progress: Progress = no_progress,
    *,
    analysis: Analysis | None = None,
    near: float = NEAR,
) -> PerformedLine:
    """The whole way of a line (paper §3, Figure 2), or from its `analysis` on if that is made already. Among the
    behaviours is what was offered and came so `near` (log-odds) to being shown.

    Raises InputError for audio, text, timings, functions, notes or options that cannot be used; names and notes are
    checked before anything is heard.
    """
    models, edits = understudy.behavior, options.edits
    contradictions = _checked(understudy, line, options, analysis)
    analysis = analysis or analyze(understudy, line, options, progress)  # §3.1 to §3.3
    progress("plan")
    known = _competing(understudy, analysis, options)
    mapped = map_functions(models.rules, known.utterance, known.functions, seed=options.seed, facts=known.facts)  # §3.4
    performer = performer_of(models, known, options, mapped=mapped, direction=line.direction, near=near)
    performer = _with_marked_words(performer, edits.words)
    planned = plan_line(performer)
    progress("mapping")
    candidates, moments = offer_candidates(performer, planned)
    progress("schedule")
    timed = replace(known, utterance=with_lead_in(analysis.utterance, options.lead_in_s))
    behaviors, script = schedule_line(performer, timed, planned, candidates)  # §3.5
    performance = assemble(performer, timed, moments, behaviors)
    performance = edited(performance, edits.behaviors, performer.character)
    performance = with_listeners(models, performance, options)  # §3.6
    performance = with_stillness(performance, options.stillness)
    lost = (*unmarked(edits.words, timed.utterance.words), *losses(performance, options.form))
    notices = (*contradictions, *performance.notices, *lost)
    return PerformedLine(analysis, replace(performance, notices=notices), script)


def perform(understudy: Understudy, line: Line, options: Options, progress: Progress = no_progress) -> Performance:
    """The performance of a line; raises as `perform_line` does."""
    return perform_line(understudy, line, options, progress).performance


def perform_analysis(
    understudy: Understudy,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
) -> Performance:
    """The performance of an analysed line, with a director's notes applied; raises as `perform_line` does."""
    line = Line(None, "", direction=direction)
    return perform_line(understudy, line, options, progress, analysis=analysis).performance


def analyze(
    understudy: Understudy, line: Line, options: Options = AS_USUAL, progress: Progress = no_progress
) -> Analysis:
    """The analysis of a line (paper §3.1 to §3.3). An author's edits correct word times; a line without a recording is
    timed by its words alone."""
    agitation, affect = options.agitation, options.affect
    said = hear(understudy.acoustic, line, progress, reference=options.reference)  # §3.1
    words, left_out = corrected(said.words, options.edits.words, duration_s=said.duration_s)
    progress("parse")
    parse = understudy.language.parser.parse(words)  # §3.2
    progress("stress")
    utterance = with_prosody(understudy.acoustic, replace(said, words=words), parse, agitation=agitation, affect=affect)
    progress("functions")
    known = understand(understudy.language.rules, utterance, given=line.functions)  # §3.3
    return replace(known, notices=(*said.notices, *left_out), heard=said.signal)


def _checked(understudy: Understudy, line: Line, options: Options, analysis: Analysis | None) -> tuple[Notice, ...]:
    """Notices of contradictions in a director's notes; raises InputError for unknown names, and where the notes do not
    fit the words."""
    understudy.behavior.characters.named(options.character)
    understudy.behavior.profile(options.profile)
    if line.direction is None:
        return ()
    words = analysis.utterance.words if analysis else read_transcript(line.text)
    check_direction(line.direction, words=len(words))
    return conflicts(line.direction)


def _competing(understudy: Understudy, analysis: Analysis, options: Options) -> Analysis:
    """The analysis with the functions by which behaviours are chosen: where that is by priority, those that share words
    have competed (paper §3.3)."""
    if not chooses_by_priority(understudy.behavior, options):
        return analysis
    return replace(analysis, functions=resolved_as_in_paper(analysis.functions))


def _with_marked_words(performer: Performer, edits: Sequence[WordEdit]) -> Performer:
    """The performer with a note for each word that the author marked."""
    words = performer.line.utterance.words
    important = {index for mark, index in marked(edits, words) if mark is WordMark.IMPORTANT}
    meanings = meanings_at(performer, important)
    return replace(performer, direction=with_marked(performer.direction, edits, words, meanings))
