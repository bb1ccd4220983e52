"""The whole way of a line, in order: read it and you have read the paper's Figure 2, up to the schedule.

Every stage is a pure function over the values of `app.model`; what they need besides (models, rules, tables) is loaded
once into an `Understudy` and never changes. The doors (`app.cli`, `app.api`) call this module and know nothing of the
stages; the forms in which results leave (BML, TextGrid, CTM) are passed on from here.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial, reduce
from pathlib import Path
from typing import Self

from app.acoustic.agitation import AgitationModel
from app.acoustic.alignment import Aligner, Alignment
from app.acoustic.background import doubts
from app.acoustic.contours import contours_of
from app.acoustic.decoding import AudioLimits, decode
from app.acoustic.emphasis import Measure, with_emphasis
from app.acoustic.prominence import prominence
from app.acoustic.speaker import SpeakerReference
from app.acoustic.stress import stress
from app.acoustic.timings import read_timings, to_ctm, to_textgrid
from app.bml.characters import Characters
from app.bml.documents import DialectName, TimeForm
from app.bml.listening import listen
from app.bml.scheduling import schedule
from app.bml.visemes import visemes
from app.bml.writer import CORE_FORM, BmlForm, write_bml, write_bml_json
from app.model import (
    Agitation,
    Audio,
    Contours,
    Filler,
    Function,
    GivenFunction,
    Level,
    Listening,
    Mode,
    Notice,
    Parse,
    Performance,
    StressThresholds,
    Utterance,
    Word,
)
from app.realizer.realizing import Realizer
from app.resources import resource_folder
from app.rules.derivation import FunctionRules, derive_functions
from app.rules.mapping import MappingRules, offer_movements
from app.settings import Settings
from app.syntax.parser import Parser
from app.transcript import read_transcript

__all__ = [
    "Aligned",
    "Analysis",
    "BmlForm",
    "Body",
    "DialectName",
    "Ears",
    "Heard",
    "Line",
    "Mind",
    "Options",
    "Progress",
    "SpeakerReference",
    "TimeForm",
    "Timings",
    "Understudy",
    "align",
    "analyze",
    "hear",
    "perform",
    "refer",
    "to_ctm",
    "to_textgrid",
    "understand",
    "understand_all",
    "write_bml",
    "write_bml_json",
    "write_listener",
]

Progress = Callable[[str], None]
"""Told the name of each stage as it begins."""

DEFAULT_CHARACTER = "default"

RULES = Path(__file__).resolve().parent / "rules"


def unheard(_stage: str) -> None:
    """The progress of a performance that nobody watches."""


@dataclass(frozen=True, slots=True)
class Timings:
    """Words timed elsewhere: the file's content and its format, "json", "textgrid" or "ctm"."""

    content: bytes
    format: str


@dataclass(frozen=True, slots=True)
class Line:
    """What is sent in: the audio file's bytes, the transcript, the words' timings when they are known already, and the
    functions that the caller knows."""

    audio: bytes
    text: str
    timings: Timings | None = None
    functions: tuple[GivenFunction, ...] = ()


@dataclass(frozen=True, slots=True)
class Options:
    """How the line is to be performed, and who listens; `agitation` overrides what the voice says, `reference` is how
    it usually sounds."""

    character: str = DEFAULT_CHARACTER
    agitation: Level | None = None
    seed: int = 0
    mode: Mode = Mode.SEMANTIC
    listeners: tuple[str, ...] = ()
    form: BmlForm = CORE_FORM
    reference: SpeakerReference | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Heard:
    """What the signal alone says."""

    audio: Audio
    contours: Contours
    agitation: Agitation
    notices: tuple[Notice, ...]


@dataclass(frozen=True, slots=True)
class Aligned:
    """The words in time, and the fillers heard between them; `duration_s` is the audio's."""

    words: tuple[Word, ...]
    duration_s: float
    notices: tuple[Notice, ...]
    fillers: tuple[Filler, ...] = ()


@dataclass(frozen=True, slots=True)
class Analysis:
    """What a line says and does, before any movement is chosen; `heard` is what its signal says, if it has one."""

    utterance: Utterance
    functions: tuple[Function, ...]
    notices: tuple[Notice, ...] = ()
    heard: Heard | None = field(default=None, repr=False, compare=False)


@dataclass(frozen=True, slots=True)
class Ears:
    """What hearing needs (paper §3.1). The aligner runs in a process of its own, started by the first line and ended by
    `close` (or a `with` block)."""

    settings: Settings
    aligner: Aligner
    agitation: AgitationModel

    @classmethod
    def load(cls, settings: Settings) -> "Ears":
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
class Mind:
    """What understanding needs (paper §3.2, §3.3)."""

    settings: Settings
    parser: Parser
    rules: FunctionRules

    @classmethod
    def load(cls, settings: Settings) -> "Mind":
        """Raises AuthoringError with every mistake in words and rules, ServiceError when the parser does not load."""
        return cls(
            settings=settings,
            parser=Parser.load(settings.parser or resource_folder("models") / "parser"),
            rules=FunctionRules.load(RULES, resource_folder("lexicon") / "en"),
        )


@dataclass(frozen=True, slots=True)
class Body:
    """What moving needs (paper §3.4, §3.5)."""

    characters: Characters
    rules: MappingRules

    @classmethod
    def load(cls) -> "Body":
        """Raises AuthoringError with every mistake in characters, behaviour table and mapping rules."""
        characters = Characters.load(resource_folder("lexicon"))
        return cls(characters=characters, rules=MappingRules.load(RULES, characters.behavior_names))


@dataclass(frozen=True, slots=True)
class Understudy:
    """The whole of it, loaded once and shared by threads. `close` (or a `with` block) ends the aligner's process."""

    ears: Ears
    mind: Mind
    body: Body
    realizer: Realizer

    @classmethod
    def load(cls, settings: Settings) -> "Understudy":
        realizer = Realizer.load(resource_folder("lexicon"))
        return cls(ears=Ears.load(settings), mind=Mind.load(settings), body=Body.load(), realizer=realizer)

    def close(self) -> None:
        self.ears.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()


def perform(understudy: Understudy, line: Line, options: Options, progress: Progress = unheard) -> Performance:
    """The performance of a recorded line (paper §3, Figure 2).

    Raises InputError for audio, text, timings, functions or options that cannot be used.
    """
    character = understudy.body.characters.named(options.character)
    analysis = analyze(understudy, line, agitation=options.agitation, reference=options.reference, progress=progress)
    progress("mapping")
    wishes = offer_movements(understudy.body.rules, analysis.utterance, analysis.functions, seed=options.seed)
    progress("schedule")
    behaviors = schedule(wishes, analysis.utterance, character, seed=options.seed, mode=options.mode)
    lips, lip_notices = visemes(analysis.utterance.words, analysis.utterance.duration_s or 0.0)
    performance = Performance(
        utterance=analysis.utterance,
        functions=analysis.functions,
        behaviors=behaviors,
        character=character.name,
        seed=options.seed,
        notices=analysis.notices + lip_notices,
        visemes=lips,
    )
    return reduce(partial(_heard_by, understudy.body.characters), options.listeners, performance)


def listener_part(performance: Performance, listening: Listening) -> Performance:
    """What a listener does as a performance of his own, in which nothing is said."""
    silent = replace(performance.utterance, words=(), parse=Parse((), (), ()))
    return Performance(silent, (), listening.behaviors, listening.name, performance.seed)


def write_listener(performance: Performance, listening: Listening, form: BmlForm) -> bytes:
    """A listener's BML. Its times are absolute in either form: he has no speech with marks to tell them by."""
    return write_bml(listener_part(performance, listening), replace(form, timing=TimeForm.ABSOLUTE, audio_name=None))


def _heard_by(characters: Characters, performance: Performance, name: str) -> Performance:
    """The performance with one more listener: the character of that name, or one who moves as the default does."""
    notices = performance.notices
    if name not in characters.by_name:
        message = f"no character is called {name!r}; this listener moves as {DEFAULT_CHARACTER!r} does"
        notices = (*notices, Notice("listener_unknown", message))
    character = characters.by_name.get(name) or characters.named(DEFAULT_CHARACTER)
    behaviors = listen(
        performance.behaviors,
        performance.utterance,
        replace(character, name=name),
        speaker=performance.character,
        seed=performance.seed,
    )
    return replace(performance, listeners=(*performance.listeners, Listening(name, behaviors)), notices=notices)


def analyze(
    understudy: Understudy,
    line: Line,
    *,
    agitation: Level | None = None,
    reference: SpeakerReference | None = None,
    progress: Progress = unheard,
) -> Analysis:
    """What is heard, said and meant (paper §3.1 to §3.3)."""
    ears, mind = understudy.ears, understudy.mind
    transcript = read_transcript(line.text, max_characters=mind.settings.max_text_characters)
    heard = hear(ears, line.audio, progress, reference=reference)
    timed, thresholds = hear_words(ears, heard, transcript, line.timings, progress)
    progress("parse")
    utterance = Utterance(
        words=timed.words,
        parse=mind.parser.parse(timed.words),
        agitation=_certain(agitation) if agitation else heard.agitation,
        thresholds=thresholds,
        duration_s=heard.audio.duration_s,
        fillers=timed.fillers,
    )
    progress("functions")
    functions = derive_functions(mind.rules, utterance, given=line.functions)
    return Analysis(utterance, functions, heard.notices + timed.notices, heard)


def understand(mind: Mind, text: str) -> Analysis:
    """What the words alone say and mean: nothing is heard, so nothing has a time (paper §3.2, §3.3)."""
    [analysis] = understand_all(mind, [read_transcript(text, max_characters=mind.settings.max_text_characters)])
    return analysis


def understand_all(mind: Mind, lines: Sequence[tuple[Word, ...]]) -> Iterator[Analysis]:
    """The same for the words of several lines, which are parsed together: that takes half the time."""
    for words, parse in zip(lines, mind.parser.parse_all(lines), strict=True):
        utterance = Utterance(words=words, parse=parse)
        yield Analysis(utterance, derive_functions(mind.rules, utterance))


def hear(ears: Ears, audio: bytes, progress: Progress = unheard, *, reference: SpeakerReference | None = None) -> Heard:
    """What the signal alone says: its contours and the speaker's agitation (paper §3.1.1 to §3.1.4)."""
    progress("decode")
    signal, notices = decode(audio, _limits(ears.settings))
    progress("contours")
    contours = contours_of(signal)
    progress("agitation")
    agitation = ears.agitation.agitation(signal, contours, reference)
    return Heard(signal, contours, agitation, notices + doubts(contours.energy_db))


def hear_words(
    ears: Ears,
    heard: Heard,
    transcript: tuple[Word, ...],
    timings: Timings | None = None,
    progress: Progress = unheard,
) -> tuple[Alignment, StressThresholds]:
    """The words in time with how they stand out, and the utterance's own thresholds (paper §3.1.5)."""
    progress("align")
    timed = _timed(ears, heard.audio, transcript, timings)
    progress("stress")
    words, thresholds = stress(prominence(timed.words, heard.contours), heard.contours)
    settings = ears.settings
    measure = Measure(settings.emphasis, settings.emphasis_prominence, settings.emphasis_ratio)
    return replace(timed, words=with_emphasis(words, measure)), thresholds


def refer(ears: Ears, recordings: Sequence[Heard]) -> SpeakerReference:
    """How the speaker of these recordings, one or more, usually sounds."""
    features = [ears.agitation.describe(heard.audio, heard.contours) for heard in recordings]
    return SpeakerReference.of(ears.agitation.feature_set, features)


def align(ears: Ears, line: Line) -> Aligned:
    """The words and phones of a line in time."""
    transcript = read_transcript(line.text, max_characters=ears.settings.max_text_characters)
    signal, notices = decode(line.audio, _limits(ears.settings))
    timed = _timed(ears, signal, transcript, line.timings)
    return Aligned(timed.words, signal.duration_s, notices + timed.notices, timed.fillers)


def _timed(ears: Ears, audio: Audio, transcript: tuple[Word, ...], timings: Timings | None) -> Alignment:
    """The words in time: as the caller timed them, else as the aligner hears them."""
    if timings is None:
        return ears.aligner.listen(audio, transcript)
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
