"""The whole way of a line, in order: read it and you have read the paper's Figure 2, up to the schedule.

Every stage is a pure function over the values of `understudy.model`; what they need besides (models, rules, tables) is
loaded once into an `Understudy` and never changes. The doors (`understudy.cli`, `understudy.api`) call this module and
know nothing of the stages; the forms in which results leave (BML, TextGrid, CTM) are passed on from here.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial, reduce
from types import MappingProxyType
from typing import Self

from .acoustic.agitation.agitation import AgitationModel
from .acoustic.agitation.speaker import SpeakerReference
from .acoustic.alignment.alignment import Aligner, Alignment
from .acoustic.alignment.timings import read_timings, to_ctm, to_textgrid
from .acoustic.contours import contours_of
from .acoustic.signal.background import doubts
from .acoustic.signal.decoding import AudioLimits, decode
from .acoustic.stress.emphasis import Measure, with_emphasis
from .acoustic.stress.prominence import prominence
from .acoustic.stress.stress import stress
from .acting.candidates import Stage, candidates_of
from .acting.families import Families, load_families
from .acting.notes import check_direction, conflicts, directed, unplayed_notes
from .acting.planning import Planner, plan
from .bml.choice.characters import Character, Characters
from .bml.choice.head_rates import HeadRates
from .bml.choice.lead_in import LONGEST_LEAD_IN_S, with_lead_in
from .bml.choice.listening import Listener, listen
from .bml.choice.scheduling import schedule
from .bml.choice.stillness import check_stillness, with_stillness
from .bml.choice.visemes import visemes
from .bml.markup.documents import DialectName, TimeForm
from .bml.writing.writer import CORE_FORM, BmlForm, write_bml, write_bml_json
from .errors import InputError
from .model import (
    Agitation,
    Audio,
    BehaviorCandidates,
    Contours,
    Direction,
    Filler,
    Function,
    GivenFunction,
    Level,
    Listening,
    Mode,
    Moment,
    Notice,
    Parse,
    Performance,
    StressThresholds,
    Utterance,
    Word,
)
from .realizer.realizing import Realizer
from .resources import RULES, resource_folder
from .rules.derivation import FunctionRules, understand
from .rules.knowledge import Fact
from .rules.mapping import MappingRules, offer_movements
from .settings import Settings
from .syntax.parser import Parser
from .transcript import read_transcript

__all__ = [
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
    "to_ctm",
    "to_textgrid",
    "write_bml",
    "write_bml_json",
    "write_listener",
]

Progress = Callable[[str], None]
"""Told the name of each stage as it begins."""

DEFAULT_CHARACTER = "default"

QUANTITY = MappingProxyType({Level.LOW: 0.9, Level.MEDIUM: 1.0, Level.HIGH: 1.15})
"""How much the body does at each level of agitation (paper §1), beside how much it does by itself."""


def no_progress(_stage: str) -> None:
    """The progress of a performance that nobody watches."""


@dataclass(frozen=True, slots=True)
class Timings:
    """Words timed elsewhere: the file's content and its format, "json", "textgrid" or "ctm"."""

    content: bytes
    format: str


@dataclass(frozen=True, slots=True)
class Line:
    """What is sent in: the audio file's bytes, the transcript, the words' timings when they are known already, the
    functions that the caller knows, and a director's notes."""

    audio: bytes
    text: str
    timings: Timings | None = None
    functions: tuple[GivenFunction, ...] = ()
    direction: Direction | None = None


@dataclass(frozen=True, slots=True)
class Options:
    """How the line is to be performed, and who listens; `agitation` overrides what the voice says, `reference` is how
    it usually sounds. `lead_in_s` is how long before the recording the performance begins,
    `stillness` (0 to 1) how much less than usual moves.

    Raises InputError `value_wrong`.
    """

    character: str = DEFAULT_CHARACTER
    agitation: Level | None = None
    seed: int = 0
    mode: Mode = Mode.SEMANTIC
    listeners: tuple[str, ...] = ()
    form: BmlForm = CORE_FORM
    reference: SpeakerReference | None = None
    lead_in_s: float = 0.0
    stillness: float = 0.0

    def __post_init__(self) -> None:
        if not 0 <= self.lead_in_s <= LONGEST_LEAD_IN_S:
            message = f"lead_in_s: {self.lead_in_s:g}; give 0 to {LONGEST_LEAD_IN_S:g} seconds"
            raise InputError("value_wrong", message, field="lead_in_s")
        check_stillness(self.stillness)


@dataclass(frozen=True, slots=True, eq=False)
class SignalAnalysis:
    """What the signal alone says."""

    audio: Audio
    contours: Contours
    agitation: Agitation
    notices: tuple[Notice, ...]


@dataclass(frozen=True, slots=True)
class AlignedLine:
    """The words in time, and the fillers heard between them; `duration_s` is the audio's."""

    words: tuple[Word, ...]
    duration_s: float
    notices: tuple[Notice, ...]
    fillers: tuple[Filler, ...] = ()


@dataclass(frozen=True, slots=True)
class Analysis:
    """What a line says and does, before any movement is chosen; `heard` is what its signal says, if it has one, `facts`
    what the rules know of it."""

    utterance: Utterance
    functions: tuple[Function, ...]
    notices: tuple[Notice, ...] = ()
    heard: SignalAnalysis | None = field(default=None, repr=False, compare=False)
    facts: tuple[Fact, ...] = field(default=(), repr=False, compare=False)


@dataclass(frozen=True, slots=True)
class AcousticModels:
    """What hearing needs (paper §3.1). The aligner runs in a process of its own, started by the first line and ended by
    `close` (or a `with` block)."""

    settings: Settings
    aligner: Aligner
    agitation: AgitationModel

    @classmethod
    def load(cls, settings: Settings) -> "AcousticModels":
        """Raises ServiceError when a model is missing or broken."""
        models, lexicon = resource_folder("models"), resource_folder("lexicon")
        return cls(
            settings=settings,
            aligner=Aligner(models, lexicon / "en"),
            agitation=AgitationModel.load(models / "agitation", settings.agitation_features),
        )

    def close(self) -> None:
        self.aligner.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()


@dataclass(frozen=True, slots=True)
class LanguageModels:
    """What understanding needs (paper §3.2, §3.3)."""

    settings: Settings
    parser: Parser
    rules: FunctionRules

    @classmethod
    def load(cls, settings: Settings) -> "LanguageModels":
        """Raises AuthoringError with every mistake in words and rules, ServiceError when the parser does not load."""
        return cls(
            settings=settings,
            parser=Parser.load(settings.parser or resource_folder("models") / "parser"),
            rules=FunctionRules.load(RULES, resource_folder("lexicon") / "en"),
        )


@dataclass(frozen=True, slots=True)
class BehaviorModels:
    """What moving needs (paper §3.4, §3.5)."""

    settings: Settings
    characters: Characters
    rules: MappingRules
    families: Families
    planner: Planner
    head_rates: HeadRates

    @classmethod
    def load(cls, settings: Settings) -> "BehaviorModels":
        """Raises AuthoringError with every mistake in characters, behaviour table, families and mapping rules,
        ServiceError when a model is missing or broken."""
        lexicon = resource_folder("lexicon")
        characters = Characters.load(lexicon)
        families = load_families(lexicon / "acting" / "families.yaml", characters.named(DEFAULT_CHARACTER).entries)
        return cls(
            settings=settings,
            characters=characters,
            rules=MappingRules.load(RULES, characters.behavior_names),
            families=families,
            planner=Planner.load(resource_folder("models") / "acting", lexicon / "acting", families),
            head_rates=HeadRates.load(lexicon / "acting" / "head_rates.yaml"),
        )


@dataclass(frozen=True, slots=True)
class Understudy:
    """The whole of it, loaded once and shared by threads. `close` (or a `with` block) ends the aligner's process."""

    acoustic: AcousticModels
    language: LanguageModels
    behavior: BehaviorModels
    realizer: Realizer

    @classmethod
    def load(cls, settings: Settings) -> "Understudy":
        realizer = Realizer.load(resource_folder("lexicon"))
        return cls(
            acoustic=AcousticModels.load(settings),
            language=LanguageModels.load(settings),
            behavior=BehaviorModels.load(settings),
            realizer=realizer,
        )

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
    understudy.behavior.characters.named(options.character)
    direction_notices = _checked_direction(understudy, line)
    analysis = analyze(understudy, line, agitation=options.agitation, reference=options.reference, progress=progress)
    performance = perform_analysis(understudy, analysis, options, line.direction, progress)
    return replace(performance, notices=direction_notices + performance.notices)


def perform_analysis(
    understudy: Understudy,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
) -> Performance:
    """The performance of a line that was heard and understood (paper §3.4, §3.5), with a director's notes on it."""
    behavior, character = understudy.behavior, understudy.behavior.characters.named(options.character)
    progress("plan")
    moments = plan_moments(behavior, analysis, character, direction)
    utterance = with_lead_in(analysis.utterance, options.lead_in_s)
    progress("mapping")
    candidates = _candidates(behavior, replace(analysis, utterance=utterance), moments, character, seed=options.seed)
    progress("schedule")
    behaviors = schedule(candidates, utterance, character, seed=options.seed, mode=options.mode)
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
    )
    performance = reduce(partial(_heard_by, behavior), options.listeners, performance)
    return with_stillness(performance, options.stillness)


def _candidates(
    behavior: BehaviorModels, analysis: Analysis, moments: tuple[Moment, ...], character: Character, *, seed: int
) -> tuple[BehaviorCandidates, ...]:
    """What could show the functions, or the moments of a line that is planned."""
    candidates = offer_movements(
        behavior.rules, analysis.utterance, analysis.functions, seed=seed, facts=analysis.facts
    )
    if not moments and behavior.settings.choice != "terms":
        return candidates
    return candidates_of(Stage(behavior.families, character.lexemes, seed), analysis.utterance, moments, candidates)


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
    return write_bml(listener_part(performance, listening), replace(form, timing=TimeForm.ABSOLUTE, audio_name=None))


def _heard_by(behavior: BehaviorModels, performance: Performance, name: str) -> Performance:
    """The performance with one more listener: the character of that name, or one who moves as the default does."""
    characters, notices = behavior.characters, performance.notices
    if name not in characters.by_name:
        message = f"no character is called {name!r}; this listener moves as {DEFAULT_CHARACTER!r} does"
        notices = (*notices, Notice("listener_unknown", message))
    character = characters.by_name.get(name) or characters.named(DEFAULT_CHARACTER)
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


def find_functions(language: LanguageModels, text: str) -> Analysis:
    """What the words alone say and mean: nothing is heard, so nothing has a time (paper §3.2, §3.3)."""
    [analysis] = find_functions_in_all(
        language, [read_transcript(text, max_characters=language.settings.max_text_characters)]
    )
    return analysis


def find_functions_in_all(language: LanguageModels, lines: Sequence[tuple[Word, ...]]) -> Iterator[Analysis]:
    """The same for the words of several lines, which are parsed together: that takes half the time."""
    for words, parse in zip(lines, language.parser.parse_all(lines), strict=True):
        utterance = Utterance(words=words, parse=parse)
        known = understand(language.rules, utterance)
        yield Analysis(utterance, known.functions, facts=known.facts)


def analyze_signal(
    acoustic: AcousticModels,
    audio: bytes,
    progress: Progress = no_progress,
    *,
    reference: SpeakerReference | None = None,
) -> SignalAnalysis:
    """What the signal alone says: its contours and the speaker's agitation (paper §3.1.1 to §3.1.4)."""
    progress("decode")
    signal, notices = decode(audio, _limits(acoustic.settings))
    progress("contours")
    contours = contours_of(signal)
    progress("agitation")
    agitation = acoustic.agitation.agitation(signal, contours, reference)
    return SignalAnalysis(signal, contours, agitation, notices + doubts(contours.energy_db))


def align_words(
    acoustic: AcousticModels,
    heard: SignalAnalysis,
    transcript: tuple[Word, ...],
    timings: Timings | None = None,
    progress: Progress = no_progress,
) -> tuple[Alignment, StressThresholds]:
    """The words in time with how they stand out, and the utterance's own thresholds (paper §3.1.5)."""
    progress("align")
    timed = _timed(acoustic, heard.audio, transcript, timings)
    progress("stress")
    words, thresholds = stress(prominence(timed.words, heard.contours), heard.contours)
    settings = acoustic.settings
    measure = Measure(settings.emphasis, settings.emphasis_prominence, settings.emphasis_ratio)
    return replace(timed, words=with_emphasis(words, measure)), thresholds


def make_reference(acoustic: AcousticModels, recordings: Sequence[SignalAnalysis]) -> SpeakerReference:
    """How the speaker of these recordings, one or more, usually sounds."""
    features = [acoustic.agitation.describe(heard.audio, heard.contours) for heard in recordings]
    return SpeakerReference.of(acoustic.agitation.feature_set, features)


def align(acoustic: AcousticModels, line: Line) -> AlignedLine:
    """The words and phones of a line in time."""
    transcript = read_transcript(line.text, max_characters=acoustic.settings.max_text_characters)
    signal, notices = decode(line.audio, _limits(acoustic.settings))
    timed = _timed(acoustic, signal, transcript, line.timings)
    return AlignedLine(timed.words, signal.duration_s, notices + timed.notices, timed.fillers)


def _timed(acoustic: AcousticModels, audio: Audio, transcript: tuple[Word, ...], timings: Timings | None) -> Alignment:
    """The words in time: as the caller timed them, else as the aligner hears them."""
    if timings is None:
        return acoustic.aligner.listen(audio, transcript)
    return Alignment(read_timings(timings.content, timings.format, transcript, duration_s=audio.duration_s), ())


def _limits(settings: Settings) -> AudioLimits:
    return AudioLimits(
        max_duration_s=settings.max_audio_s,
        max_bytes=settings.max_audio_bytes,
        min_sample_rate_hz=settings.min_sample_rate_hz,
        max_sample_rate_hz=settings.max_sample_rate_hz,
        max_channels=settings.max_channels,
    )


def _certain(level: Level) -> Agitation:
    """The memberships of a level that the caller gave."""
    return Agitation(**{name.value: float(name is level) for name in Level})
