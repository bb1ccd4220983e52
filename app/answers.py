"""The JSON shapes that leave through either door, made from the values of `app.model`.

One rule for all: a key is absent where there is nothing to say (a time when nothing was heard, the winner when no
conflict was lost). Numbers are rounded to `DECIMALS`, so that the same values give the same bytes everywhere. Most
shapes read the equally named attributes of their value: `PhraseAnswer.model_validate(phrase)`. What authors edit has
its shapes in `app.library_answers`.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Annotated, Self

from pydantic import AfterValidator, AliasPath, BaseModel, BeforeValidator, ConfigDict, Field

from app.errors import UnderstudyError
from app.model import PLAIN, Agitation, Function, Level, Notice, Performance, SyncPoints, Utterance, Word
from app.performance import Aligned, Analysis

DECIMALS = 6


def _rounded(number: float) -> float:
    return round(number, DECIMALS) + 0.0  # adding zero turns -0.0, which is written "-0.0", into 0.0


def _set_points(sync: SyncPoints) -> dict[str, float]:
    return dict(sync.in_order())


def _if_so(flag: bool) -> bool | None:
    return flag or None


Number = Annotated[float, AfterValidator(_rounded)]
Times = Annotated[dict[str, Number], BeforeValidator(_set_points)]


class Answer(BaseModel):
    """Base of every shape."""

    model_config = ConfigDict(frozen=True, extra="forbid", from_attributes=True)

    def to_json(self, indent: int | None = None) -> bytes:
        """The shape as UTF-8 JSON without a final line break; on one line unless `indent` is given."""
        return self.model_dump_json(by_alias=True, exclude_none=True, indent=indent).encode()


class WarningAnswer(Answer):
    """Something degraded, dropped or guessed."""

    code: str
    message: str


class PhoneAnswer(Answer):
    """A speech sound: ARPABET without digit, the stress beside it where it is known."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    stress: int | None = None


class WordAnswer(Answer):
    """A word of the transcript; one that is not spoken, such as a lone dash, has no times.

    `spread` is there, and true, where the times are guessed from loudness.
    """

    index: int
    text: str
    start_s: Number | None = Field(default=None, validation_alias=AliasPath("interval", "start_s"))
    end_s: Number | None = Field(default=None, validation_alias=AliasPath("interval", "end_s"))
    stressed_ratio: Number | None = None
    prominence: Number | None = None
    emphasis: Number | None = None
    spread: Annotated[bool | None, BeforeValidator(_if_so)] = None
    phones: list[PhoneAnswer]


class FillerAnswer(Answer):
    """A sound of hesitation that was heard and is no word of the transcript."""

    text: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))


class AudioAnswer(Answer):
    """The recording."""

    duration_s: Number


class StressAnswer(Answer):
    """The utterance's thresholds; a frame above either is stressed."""

    energy_db: Number
    f0_hz: Number | None = None


class MembershipsAnswer(Answer):
    """How far the voice belongs to each level of agitation; they sum to 1."""

    low: Number
    medium: Number
    high: Number


class TokenAnswer(Answer):
    """A unit of the parser: `word` is the transcript word it belongs to, `head` the token that governs it."""

    index: int
    word: int
    text: str
    lemma: str
    part_of_speech: str
    tag: str
    dependency: str
    head: int


class PhraseAnswer(Answer):
    """A noun phrase or verb group, in numbers of the transcript's words."""

    kind: str
    first: int
    last: int
    head: int


class ClauseAnswer(Answer):
    """A clause, in numbers of the transcript's words."""

    label: str
    first: int
    last: int
    head: int


class ParseAnswer(Answer):
    """The syntactic structure."""

    tokens: list[TokenAnswer]
    phrases: list[PhraseAnswer]
    clauses: list[ClauseAnswer]


class BecauseAnswer(Answer):
    """One support: a word of the transcript, or a fact with the rule that derived it."""

    word: int | None = None
    rule: str | None = None
    fact: str | None = None


class FunctionAnswer(Answer):
    """A communicative function of the words `first` to `last`."""

    id: str
    class_name: str = Field(serialization_alias="class")
    subtype: str
    first: int
    last: int
    text: str
    start_s: Number | None = None
    end_s: Number | None = None
    priority: Number
    rule: str
    because: list[BecauseAnswer]
    kept: bool
    lost_to: str | None = None

    @classmethod
    def of(cls, function: Function, words: Sequence[Word]) -> Self:
        """`words` are the whole transcript's: they give the function its text and times."""
        spanned = words[function.first : function.last + 1]
        intervals = [word.interval for word in spanned if word.interval]
        return cls(
            id=function.id,
            class_name=function.class_name,
            subtype="" if function.subtype == PLAIN else function.subtype,
            first=function.first,
            last=function.last,
            text=" ".join(word.text for word in spanned),
            start_s=intervals[0].start_s if intervals else None,
            end_s=intervals[-1].end_s if intervals else None,
            priority=function.priority,
            rule=function.rule,
            because=[BecauseAnswer.model_validate(because) for because in function.because],
            kept=function.kept,
            lost_to=function.lost_to,
        )


class BehaviorAnswer(Answer):
    """One movement; the times of `sync` are seconds from the start of the audio."""

    id: str
    kind: str
    lexeme: str
    hand: str | None = None
    amount: Number | None = None
    target: str | None = None
    direction: str | None = None
    repetitions: int | None = None
    sync: Times
    first: int
    last: int
    priority: Number
    rule: str | None = None
    function: str | None = None
    kept: bool
    lost_to: str | None = None
    reason: str | None = None


class VisemeAnswer(Answer):
    """A shape of the mouth: how much of it is reached, and how wide the jaw is open in it."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    articulation: Number
    opening: Number


class AlignAnswer(Answer):
    """Words and phones in time, and the fillers between them."""

    audio: AudioAnswer
    words: list[WordAnswer]
    fillers: list[FillerAnswer]
    warnings: list[WarningAnswer]

    @classmethod
    def of(cls, aligned: Aligned) -> Self:
        heard = {"words": aligned.words, "fillers": aligned.fillers, "warnings": aligned.notices}
        return cls.model_validate({"audio": aligned, **heard})


class AgitationAnswer(Answer):
    """The speaker's agitation in one file."""

    file: str
    agitation: Level
    memberships: MembershipsAnswer

    @classmethod
    def of(cls, file: str, agitation: Agitation) -> Self:
        return cls.model_validate({"file": file, "agitation": agitation.level, "memberships": agitation})


class FunctionsAnswer(Answer):
    """What the words alone do; `id` comes back as it was sent."""

    id: str | int | None = None
    functions: list[FunctionAnswer]

    @classmethod
    def of(cls, analysis: Analysis, line_id: str | int | None = None) -> Self:
        return cls(id=line_id, functions=_functions(analysis.functions, analysis.utterance))


class ErrorAnswer(Answer):
    """What was wrong."""

    code: str
    message: str


class MistakeAnswer(Answer):
    """The answer to one of many lines when it is wrong."""

    id: str | int | None = None
    error: ErrorAnswer

    @classmethod
    def of(cls, error: UnderstudyError, line_id: str | int | None) -> Self:
        return cls(id=line_id, error=ErrorAnswer.model_validate(error))


class AnalysisAnswer(Answer):
    """What a line says and does, before any movement is chosen."""

    audio: AudioAnswer
    words: list[WordAnswer]
    fillers: list[FillerAnswer]
    stress: StressAnswer
    agitation: Level
    memberships: MembershipsAnswer
    parse: ParseAnswer
    functions: list[FunctionAnswer]
    warnings: list[WarningAnswer]

    @classmethod
    def of(cls, analysis: Analysis) -> Self:
        return cls.model_validate(_understood(analysis.utterance, analysis.functions, analysis.notices))


class ListeningAnswer(Answer):
    """What a listener does while the line is spoken."""

    name: str
    behaviors: list[BehaviorAnswer]


class PerformanceAnswer(AnalysisAnswer):
    """The whole performance: what was heard and understood, what the body does with it, and every reason."""

    character: str
    seed: int
    behaviors: list[BehaviorAnswer]
    visemes: list[VisemeAnswer]
    listeners: list[ListeningAnswer] | None = None

    @classmethod
    def of_performance(cls, performance: Performance) -> Self:
        understood = _understood(performance.utterance, performance.functions, performance.notices)
        chosen = {name: getattr(performance, name) for name in ("character", "seed", "behaviors", "visemes")}
        return cls.model_validate(understood | chosen | {"listeners": performance.listeners or None})


class PerformAnswer(Answer):
    """What `POST /perform` answers when asked for JSON; `listeners` has each listener's BML by name."""

    bml: str
    listeners: dict[str, str] | None = None
    performance: PerformanceAnswer
    warnings: list[WarningAnswer]

    @classmethod
    def of(cls, performance: Performance, bml: bytes, listeners: Mapping[str, bytes] = MappingProxyType({})) -> Self:
        told = PerformanceAnswer.of_performance(performance)
        heard = {name: block.decode() for name, block in listeners.items()}
        return cls(bml=bml.decode(), listeners=heard or None, performance=told, warnings=told.warnings)


def _understood(utterance: Utterance, functions: Sequence[Function], notices: Sequence[Notice]) -> dict[str, object]:
    """The fields that an analysis and a performance share, for an utterance that was heard."""
    return {
        "audio": {"duration_s": utterance.duration_s},
        "words": utterance.words,
        "fillers": utterance.fillers,
        "stress": utterance.thresholds,
        "agitation": utterance.agitation and utterance.agitation.level,
        "memberships": utterance.agitation,
        "parse": utterance.parse,
        "functions": _functions(functions, utterance),
        "warnings": notices,
    }


def _functions(functions: Sequence[Function], utterance: Utterance) -> list[FunctionAnswer]:
    return [FunctionAnswer.of(function, utterance.words) for function in functions]
