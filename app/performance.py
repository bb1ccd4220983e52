"""The whole way of a line, in order: read it and you have read the paper's Figure 2, up to the schedule.

Every stage is a pure function over the values of `understudy.model`; what they need besides (models, rules, tables) is
loaded once into an `Understudy` and never changes. The doors (`understudy.cli`, `understudy.api`) call this module and
know nothing of the stages; the forms in which results leave (BML, TextGrid, CTM) are passed on from here.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial, reduce
from types import MappingProxyType
from typing import TYPE_CHECKING, Self

from threadpoolctl import threadpool_limits

from .acoustic.agitation.speaker import SpeakerReference
from .acoustic.alignment.timings import to_ctm, to_textgrid
from .acting.candidates import Stage, candidates_of
from .acting.families import Families
from .acting.notes import check_direction, conflicts, directed, unplayed_notes
from .acting.planning import Planner, plan
from .acting.targets import mentions, pointing_candidates, without_overlapped
from .analysis import (
    AlignedLine,
    Analysis,
    Line,
    Options,
    SignalAnalysis,
    Timings,
)
from .bml.choice.characters.characters import DEFAULT_CHARACTER, Character, Characters
from .bml.choice.characters.gesture_forms import FormedCharacters
from .bml.choice.listeners.addressees import addressed, placed_listeners
from .bml.choice.listeners.head_rates import HeadRates
from .bml.choice.listeners.listening import Listener, listen
from .bml.choice.scheduling import numbered, schedule
from .bml.choice.speech.lead_in import with_lead_in
from .bml.choice.speech.visemes import visemes
from .bml.choice.stillness import with_stillness
from .bml.markup.documents import DialectName, TimeForm
from .bml.writing.writer import BmlForm, losses, write_bml, write_bml_json, write_speech_file
from .errors import InputError
from .gesture_scripts import (
    as_speaker,
    gesture_script,
    repertoire_of,
    scripted_behaviors,
    without_chosen_gestures,
    without_planned_gestures,
)
from .hearing import AcousticModels, align, align_words, analyze_signal, make_reference
from .loading import (
    load_characters,
    load_families,
    load_gesture_table,
    load_mapping_rules,
    load_profile,
    load_realizer,
    profile_names,
)
from .model import (
    Agitation,
    BehaviorCandidates,
    Direction,
    Level,
    Listening,
    Moment,
    Notice,
    Parse,
    Performance,
    Utterance,
)
from .on_demand import OnDemand
from .profiles.generation.script import GestureScript
from .profiles.profile import Profile
from .progress import Progress, no_progress
from .resources import resource_folder
from .rules.derivation import understand
from .rules.mapping import MappingRules, offer_movements
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
class BehaviorModels:
    """What moving needs (paper §3.4, §3.5)."""

    settings: Settings
    characters: Characters
    rules: MappingRules
    families: Families
    planner: Planner
    head_rates: HeadRates
    performers: FormedCharacters
    profiles: Mapping[str, OnDemand[Profile]]

    @classmethod
    def load(cls, settings: Settings) -> Self:
        """Raises AuthoringError with every mistake in characters, behaviour table, families and mapping rules,
        ServiceError when a model is missing or broken."""
        lexicon = resource_folder("lexicon")
        characters = load_characters()
        families = load_families(characters)
        rules, models = load_mapping_rules(characters.behavior_names), resource_folder("models")
        return cls(
            settings=settings,
            characters=characters,
            rules=rules,
            families=families,
            planner=Planner.load(models / "acting", lexicon / "acting", families, rules.program.argument_counts),
            head_rates=HeadRates.load(lexicon / "acting" / "head_rates.yaml"),
            performers=FormedCharacters.of(characters, load_gesture_table(characters.gesture_lexemes)),
            profiles={
                name: OnDemand(partial(load_profile, name, characters.gesture_lexemes)) for name in profile_names()
            },
        )

    def profile(self, profile: Profile | str | None) -> Profile | None:
        """The profile, or that of this name in the lexicon; raises InputError `unknown_profile`."""
        if not isinstance(profile, str):
            return profile
        if profile not in self.profiles:
            return load_profile(profile, self.characters.gesture_lexemes)
        return self.profiles[profile].get()


QUANTITY = MappingProxyType({Level.LOW: 0.9, Level.MEDIUM: 1.0, Level.HIGH: 1.15})
"""How much the body does at each level of agitation (paper §1), beside how much it does by itself."""


@dataclass(frozen=True, slots=True)
class Understudy:
    """The whole of it, loaded once and shared by threads. `close` (or a `with` block) ends the aligner's process.

    The realizer is loaded when it is first asked for: most performances are never realized.
    """

    acoustic: AcousticModels
    language: LanguageModels
    behavior: BehaviorModels
    when_realizing: OnDemand[Realizer]

    @classmethod
    def load(cls, settings: Settings) -> Self:
        """All but the realizer, what may be wrong with authored files first. Raises as the loading of each does.

        Products of matrices stay on one processor from then on, in the whole process: a line is too short to share.
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
        """Raises AuthoringError, when it is first asked for, with the mistakes of gestures, face and rigs."""
        return self.when_realizing.get()

    def with_settings(self, settings: Settings) -> Self:
        """The same models within other limits; settings of what is loaded stay without effect."""
        return replace(
            self,
            acoustic=replace(self.acoustic, settings=settings),
            language=replace(self.language, settings=settings),
            behavior=replace(self.behavior, settings=settings),
        )

    def load_rest(self) -> None:
        """Loads what is otherwise loaded when it is first asked for; raises as `realizer` and `acoustic.aligner` do."""
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
    """What was heard and understood in a line, and its performance; raises as `perform` does."""
    understudy.behavior.characters.named(options.character)
    direction_notices = _checked_direction(understudy, line)
    analysis = analyze(understudy, line, agitation=options.agitation, reference=options.reference, progress=progress)
    performance = perform_analysis(understudy, analysis, options, line.direction, progress)
    return analysis, replace(performance, notices=direction_notices + performance.notices)


def perform_analysis(
    understudy: Understudy,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
) -> Performance:
    """The performance of a line that was heard and understood (paper §3.4, §3.5), with a director's notes on it."""
    return _performed(understudy, analysis, options, direction, progress)[0]


def write_script(
    understudy: Understudy, line: Line, options: Options, progress: Progress = no_progress
) -> tuple[Performance, GestureScript]:
    """The performance of a recorded line and the gesture script that its hands follow, by the profile of the options
    (NGS §3.3); raises as `perform` does, and InputError `value_wrong` where there is no profile."""
    analysis = analyze(understudy, line, agitation=options.agitation, progress=progress)
    return script_analysis(understudy, analysis, options, line.direction)


def script_analysis(
    understudy: Understudy, analysis: Analysis, options: Options, direction: Direction | None = None
) -> tuple[Performance, GestureScript]:
    """The same for a line that was heard and understood."""
    performance, script = _performed(understudy, analysis, options, direction)
    if script is None:
        raise InputError("value_wrong", "profile: a gesture script is written by a profile; name one", field="profile")
    return performance, script


def _performed(
    understudy: Understudy,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
) -> tuple[Performance, GestureScript | None]:
    behavior, agitation = understudy.behavior, analysis.utterance.agitation
    profile = behavior.profile(options.profile)
    level = agitation.level if agitation else Level.MEDIUM
    character = behavior.performers.named(options.character, level)
    if profile is not None:
        character = as_speaker(character, profile)
    progress("plan")
    moments = plan_moments(behavior, analysis, character, direction)
    if profile is not None:
        moments = without_planned_gestures(moments)
    targets = placed_listeners(options.listeners, options.targets)
    utterance = with_lead_in(analysis.utterance, options.lead_in_s)
    progress("mapping")
    candidates = _candidates(behavior, replace(analysis, utterance=utterance), moments, character, seed=options.seed)
    if profile is not None:
        candidates = tuple(without_chosen_gestures(candidates, character.lexemes))
    named = mentions(utterance, options.targets)
    pointing = tuple(pointing_candidates(named, analysis.functions))
    candidates = (*without_overlapped(candidates, named), *pointing)
    moments += tuple(each.moment for each in pointing if each.moment)
    progress("schedule")
    behaviors = schedule(
        candidates,
        utterance,
        character,
        seed=options.seed,
        mode=options.mode,
        several_listeners=len(options.listeners) > 1,
    )
    script = None
    if profile is not None:
        repertoire = repertoire_of(character, behavior.families, direction, behaviors)
        script = gesture_script(profile, repertoire, utterance, analysis.functions, seed=options.seed)
        behaviors = numbered((*behaviors, *scripted_behaviors(script, analysis.functions, behaviors)))
    behaviors = addressed(behaviors, options.listeners, targets)
    lips, lip_notices = visemes(utterance.words, utterance.duration_s or 0.0)
    performance = Performance(
        utterance=utterance,
        functions=analysis.functions,
        behaviors=behaviors,
        character=character.name,
        seed=options.seed,
        notices=analysis.notices + lip_notices + unplayed_notes(moments, behaviors),
        visemes=lips,
        moments=moments,
        targets=targets,
    )
    performance = reduce(partial(_heard_by, behavior, dict(options.played_by)), options.listeners, performance)
    performance = with_stillness(performance, options.stillness)
    return replace(performance, notices=performance.notices + losses(performance, options.form)), script


def _candidates(
    behavior: BehaviorModels, analysis: Analysis, moments: tuple[Moment, ...], character: Character, *, seed: int
) -> tuple[BehaviorCandidates, ...]:
    """What could show the functions, or the moments of a line that is planned."""
    candidates = offer_movements(
        behavior.rules, analysis.utterance, analysis.functions, seed=seed, facts=analysis.facts
    )
    if not moments and behavior.settings.choice != "terms":
        return candidates
    return candidates_of(Stage(behavior.families, character.entries, seed), analysis.utterance, moments, candidates)


def _checked_direction(understudy: Understudy, line: Line) -> tuple[Notice, ...]:
    """What a director's notes say against each other; raises InputError where they do not fit the words."""
    if line.direction is None:
        return ()
    limit = understudy.language.settings.max_text_characters
    check_direction(line.direction, words=len(read_transcript(line.text, max_characters=limit)))
    return conflicts(line.direction)


def plan_moments(
    behavior: BehaviorModels, analysis: Analysis, character: Character, direction: Direction | None = None
) -> tuple[Moment, ...]:
    """What the line's phrases mean to the body, a director's notes first; nothing but these where functions choose by
    priority alone, as in the paper.

    How much is done depends on the speaker's agitation (paper §1) and on who performs.
    """
    moments: tuple[Moment, ...] = ()
    if behavior.settings.choice == "terms":
        agitation = analysis.utterance.agitation
        quantity = QUANTITY[agitation.level if agitation else Level.MEDIUM] * character.liveliness
        moments = plan(behavior.planner, analysis.utterance, analysis.functions, analysis.facts, quantity=quantity)
    return moments if direction is None else directed(direction, moments)


def listener_part(performance: Performance, listening: Listening) -> Performance:
    """What a listener does as a performance of his own, in which nothing is said."""
    silent = replace(performance.utterance, words=(), parse=Parse((), (), ()))
    return Performance(silent, (), listening.behaviors, listening.name, performance.seed)


def write_listener(performance: Performance, listening: Listening, form: BmlForm) -> bytes:
    """A listener's BML. Its times are absolute in either form: he has no speech with marks to tell them by."""
    return write_bml(listener_part(performance, listening), replace(form, timing=TimeForm.ABSOLUTE, audio_file=None))


def _heard_by(
    behavior: BehaviorModels, played_by: Mapping[str, str], performance: Performance, name: str
) -> Performance:
    """The performance with one more listener: played by whom the options say, else by the character of that name, else
    by the default."""
    characters, notices = behavior.characters, performance.notices
    played = played_by.get(name, name)
    if played not in characters.by_name:
        message = f"no character is called {name!r}; this listener moves as {DEFAULT_CHARACTER!r} does"
        notices = (*notices, Notice("listener_unknown", message))
    character = characters.by_name.get(played) or characters.named(DEFAULT_CHARACTER)
    listener = Listener(replace(character, name=name), behavior.head_rates, performance.character)
    behaviors = listen(performance.behaviors, performance.utterance, listener, seed=performance.seed)
    return replace(performance, listeners=(*performance.listeners, Listening(name, behaviors)), notices=notices)


def analyze(
    understudy: Understudy,
    line: Line,
    *,
    agitation: Level | None = None,
    reference: SpeakerReference | None = None,
    progress: Progress = no_progress,
) -> Analysis:
    """What is heard, said and meant (paper §3.1 to §3.3)."""
    acoustic, language = understudy.acoustic, understudy.language
    transcript = read_transcript(line.text, max_characters=language.settings.max_text_characters)
    heard = analyze_signal(acoustic, line.audio, progress, reference=reference)
    timed, thresholds = align_words(acoustic, heard, transcript, line.timings, progress)
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
    """The memberships of a level that the caller gave."""
    return Agitation(**{name.value: float(name is level) for name in Level})
