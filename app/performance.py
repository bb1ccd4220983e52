"""Runs all stages of a line in order: the paper's Figure 2, up to the schedule.

Every stage is a pure function over the values of `understudy.model`; what stages need besides (models, rules, tables)
is loaded once into an `Understudy` and never changes. The doors (`understudy.cli`, `understudy.api`) call this module
and know nothing of the stages; it re-exports the writers of results (BML, TextGrid, CTM).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Self

from threadpoolctl import threadpool_limits

from .acoustic.agitation.speaker import SpeakerReference
from .acoustic.alignment.timings import to_ctm, to_textgrid
from .analysis import (
    AlignedLine,
    Analysis,
    Line,
    Options,
    SignalAnalysis,
    Timings,
)
from .behavior.candidates.notes import check_direction, conflicts
from .behavior.characters.overlays import DEFAULT_CHARACTER
from .bml.markup.documents import DialectName, TimeForm
from .bml.writing.writer import BmlForm, write_bml, write_bml_json, write_speech_file
from .edits.values import WordEdit
from .errors import InputError
from .hearing import AcousticModels, align, align_words, analyze_signal, make_reference
from .loading import (
    load_realizer,
)
from .model import (
    Agitation,
    Direction,
    Level,
    Listening,
    Notice,
    Parse,
    Performance,
    Utterance,
)
from .moving import BehaviorModels, move
from .on_demand import OnDemand
from .profiles.generation.script import GestureScript
from .progress import Progress, no_progress
from .rules.derivation import understand
from .settings import Settings
from .transcript import read_transcript
from .understanding import LanguageModels, find_functions, find_functions_in_all

if TYPE_CHECKING:
    from .realizer.realizing import Realizer

__all__ = [
    "DEFAULT_CHARACTER",
    "AcousticModels",
    "AlignedLine",
    "Analysis",
    "BehaviorModels",
    "BmlForm",
    "DialectName",
    "LanguageModels",
    "Line",
    "Options",
    "Progress",
    "SignalAnalysis",
    "SpeakerReference",
    "TimeForm",
    "Timings",
    "Understudy",
    "align",
    "analyze",
    "analyze_signal",
    "find_functions",
    "find_functions_in_all",
    "make_reference",
    "perform",
    "perform_heard",
    "script_analysis",
    "to_ctm",
    "to_textgrid",
    "write_bml",
    "write_bml_json",
    "write_listener",
    "write_script",
    "write_speech_file",
]


@dataclass(frozen=True, slots=True)
class Understudy:
    """All models, loaded once and shared by threads. `close` (or a `with` block) ends the aligner's process.

    The realizer is loaded on first use: most performances are never realized.
    """

    acoustic: AcousticModels
    language: LanguageModels
    behavior: BehaviorModels
    when_realizing: OnDemand[Realizer]

    @classmethod
    def load(cls, settings: Settings) -> Self:
        """Loads all but the realizer, authored files first because they may have mistakes. Raises as the loading of
        each does.

        From then on BLAS uses a single thread in the whole process: a line is too short to gain from more.
        """
        threadpool_limits(limits=1, user_api="blas")
        return cls(
            behavior=BehaviorModels.load(settings),
            language=LanguageModels.load(settings),
            acoustic=AcousticModels.load(settings),
            when_realizing=OnDemand(load_realizer),
        )

    @property
    def realizer(self) -> Realizer:
        """The realizer; on first use raises AuthoringError with the mistakes of gestures, face and rigs."""
        return self.when_realizing.get()

    def with_settings(self, settings: Settings) -> Self:
        """The same models with other limits; settings of what is already loaded have no effect."""
        return replace(
            self,
            acoustic=replace(self.acoustic, settings=settings),
            language=replace(self.language, settings=settings),
            behavior=replace(self.behavior, settings=settings),
        )

    def load_rest(self) -> None:
        """Loads what is otherwise loaded on first use; raises as `realizer` and `acoustic.aligner` do."""
        self.when_realizing.get()
        self.acoustic.when_aligning.get()

    def close(self) -> None:
        self.acoustic.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()


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
        reference=options.reference,
        edits=options.edits.words,
        progress=progress,
    )
    return analysis, notices


def listener_part(performance: Performance, listening: Listening) -> Performance:
    """A listener's behaviour as a performance of its own, in which nothing is said."""
    silent = replace(performance.utterance, words=(), parse=Parse((), (), ()))
    return Performance(silent, (), listening.behaviors, listening.name, performance.seed)


def write_listener(performance: Performance, listening: Listening, form: BmlForm) -> bytes:
    """A listener's BML. Its times are always absolute, because a listener has no speech whose sync points they could
    refer to."""
    return write_bml(listener_part(performance, listening), replace(form, timing=TimeForm.ABSOLUTE, audio_file=None))


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
    reference: SpeakerReference | None = None,
    edits: Sequence[WordEdit] = (),
    progress: Progress = no_progress,
) -> Analysis:
    """The analysis of a recorded line (paper §3.1 to §3.3); an author's `edits` correct word times."""
    acoustic, language = understudy.acoustic, understudy.language
    transcript = read_transcript(line.text, max_characters=language.settings.max_text_characters)
    heard = analyze_signal(acoustic, line.audio, progress, reference=reference)
    timed, thresholds = align_words(acoustic, heard, transcript, line.timings, progress, edits=edits)
    progress("parse")
    utterance = Utterance(
        words=timed.words,
        parse=language.parser.parse(timed.words),
        agitation=_certain(agitation) if agitation else heard.agitation,
        thresholds=thresholds,
        duration_s=heard.audio.duration_s,
        fillers=timed.fillers,
    )
    progress("functions")
    known = understand(language.rules, utterance, given=line.functions)
    return Analysis(utterance, known.functions, heard.notices + timed.notices, heard, known.facts)


def _certain(level: Level) -> Agitation:
    """Full membership in the level that the caller gave."""
    return Agitation(**{name.value: float(name is level) for name in Level})
