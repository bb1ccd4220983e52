"""The JSON shapes that leave through either door, made from the values of `understudy.model`.

One rule for all: a key is absent where there is nothing to say (a time when nothing was heard, the winner when no
conflict was lost). Numbers are rounded to `DECIMALS`, so that the same values give the same bytes everywhere. Most
shapes read the equally named attributes of their value: `PhraseResponse.model_validate(phrase)`. What authors edit has
its shapes in `understudy.schemas.library`.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Annotated, Self

from pydantic import AfterValidator, AliasPath, BaseModel, BeforeValidator, ConfigDict, Field

from ..errors import UnderstudyError
from ..model import PLAIN, Agitation, Function, Level, Notice, Performance, SyncPoints, Utterance, Word
from ..performance import AlignedLine, Analysis

DECIMALS = 6


def _rounded(number: float) -> float:
    return round(number, DECIMALS) + 0.0  # adding zero turns -0.0, which is written "-0.0", into 0.0


def _set_points(sync: SyncPoints) -> dict[str, float]:
    return dict(sync.in_order())


def _if_so(flag: bool) -> bool | None:
    return flag or None


Number = Annotated[float, AfterValidator(_rounded)]
Times = Annotated[dict[str, Number], BeforeValidator(_set_points)]


class ResponseModel(BaseModel):
    """Base of every shape."""

    model_config = ConfigDict(frozen=True, extra="forbid", from_attributes=True)

    def to_json(self, indent: int | None = None) -> bytes:
        """The shape as UTF-8 JSON without a final line break; on one line unless `indent` is given."""
        return self.model_dump_json(by_alias=True, exclude_none=True, indent=indent).encode()


class WarningResponse(ResponseModel):
    """Something degraded, dropped or guessed."""

    code: str
    message: str


class PhoneResponse(ResponseModel):
    """A speech sound: ARPABET without digit, the stress beside it where it is known."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    stress: int | None = None


class WordResponse(ResponseModel):
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
    phones: list[PhoneResponse]


class FillerResponse(ResponseModel):
    """A sound of hesitation that was heard and is no word of the transcript."""

    text: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))


class AudioResponse(ResponseModel):
    """The recording."""

    duration_s: Number


class StressResponse(ResponseModel):
    """The utterance's thresholds; a frame above either is stressed."""

    energy_db: Number
    f0_hz: Number | None = None


class MembershipsResponse(ResponseModel):
    """How far the voice belongs to each level of agitation; they sum to 1."""

    low: Number
    medium: Number
    high: Number


class TokenResponse(ResponseModel):
    """A unit of the parser: `word` is the transcript word it belongs to, `head` the token that governs it."""

    index: int
    word: int
    text: str
    lemma: str
    part_of_speech: str
    tag: str
    dependency: str
    head: int


class PhraseResponse(ResponseModel):
    """A noun phrase or verb group, in numbers of the transcript's words."""

    kind: str
    first: int
    last: int
    head: int


class ClauseResponse(ResponseModel):
    """A clause, in numbers of the transcript's words."""

    label: str
    first: int
    last: int
    head: int


class ParseResponse(ResponseModel):
    """The syntactic structure."""

    tokens: list[TokenResponse]
    phrases: list[PhraseResponse]
    clauses: list[ClauseResponse]


class BecauseResponse(ResponseModel):
    """One support: a word of the transcript, or a fact with the rule that derived it."""

    word: int | None = None
    rule: str | None = None
    fact: str | None = None


class FunctionResponse(ResponseModel):
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
    because: list[BecauseResponse]
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
            because=[BecauseResponse.model_validate(because) for because in function.because],
            kept=function.kept,
            lost_to=function.lost_to,
        )


class BehaviorResponse(ResponseModel):
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


class VisemeResponse(ResponseModel):
    """A shape of the mouth: how much of it is reached, and how wide the jaw is open in it."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    articulation: Number
    opening: Number


class AlignResponse(ResponseModel):
    """Words and phones in time, and the fillers between them."""

    audio: AudioResponse
    words: list[WordResponse]
    fillers: list[FillerResponse]
    warnings: list[WarningResponse]

    @classmethod
    def of(cls, aligned: AlignedLine) -> Self:
        heard = {"words": aligned.words, "fillers": aligned.fillers, "warnings": aligned.notices}
        return cls.model_validate({"audio": aligned, **heard})


class AgitationResponse(ResponseModel):
    """The speaker's agitation in one file."""

    file: str
    agitation: Level
    memberships: MembershipsResponse

    @classmethod
    def of(cls, file: str, agitation: Agitation) -> Self:
        return cls.model_validate({"file": file, "agitation": agitation.level, "memberships": agitation})


class FunctionsResponse(ResponseModel):
    """What the words alone do; `id` comes back as it was sent."""

    id: str | int | None = None
    functions: list[FunctionResponse]

    @classmethod
    def of(cls, analysis: Analysis, line_id: str | int | None = None) -> Self:
        return cls(id=line_id, functions=_functions(analysis.functions, analysis.utterance))


class ErrorResponse(ResponseModel):
    """What was wrong."""

    code: str
    message: str


class MistakeResponse(ResponseModel):
    """The answer to one of many lines when it is wrong."""

    id: str | int | None = None
    error: ErrorResponse

    @classmethod
    def of(cls, error: UnderstudyError, line_id: str | int | None) -> Self:
        return cls(id=line_id, error=ErrorResponse.model_validate(error))


class AnalysisResponse(ResponseModel):
    """What a line says and does, before any movement is chosen."""

    audio: AudioResponse
    words: list[WordResponse]
    fillers: list[FillerResponse]
    stress: StressResponse
    agitation: Level
    memberships: MembershipsResponse
    parse: ParseResponse
    functions: list[FunctionResponse]
    warnings: list[WarningResponse]

    @classmethod
    def of(cls, analysis: Analysis) -> Self:
        return cls.model_validate(_understood(analysis.utterance, analysis.functions, analysis.notices))


class ListeningResponse(ResponseModel):
    """What a listener does while the line is spoken."""

    name: str
    behaviors: list[BehaviorResponse]


class PerformanceResponse(AnalysisResponse):
    """The whole performance: what was heard and understood, what the body does with it, and every reason.

    The recording starts at `lead_in_s`; all times are from the start of the performance.
    """

    character: str
    seed: int
    lead_in_s: Number
    stillness: Number
    behaviors: list[BehaviorResponse]
    visemes: list[VisemeResponse]
    listeners: list[ListeningResponse] | None = None

    @classmethod
    def of_performance(cls, performance: Performance) -> Self:
        understood = _understood(performance.utterance, performance.functions, performance.notices)
        chosen = {
            name: getattr(performance, name) for name in ("character", "seed", "stillness", "behaviors", "visemes")
        }
        begun = {"lead_in_s": performance.utterance.lead_in_s}
        return cls.model_validate(understood | chosen | begun | {"listeners": performance.listeners or None})


class PerformResponse(ResponseModel):
    """What `POST /perform` answers when asked for JSON; `listeners` has each listener's BML by name."""

    bml: str
    listeners: dict[str, str] | None = None
    performance: PerformanceResponse
    warnings: list[WarningResponse]

    @classmethod
    def of(cls, performance: Performance, bml: bytes, listeners: Mapping[str, bytes] = MappingProxyType({})) -> Self:
        told = PerformanceResponse.of_performance(performance)
        heard = {name: block.decode() for name, block in listeners.items()}
        return cls(bml=bml.decode(), listeners=heard or None, performance=told, warnings=told.warnings)


def _understood(utterance: Utterance, functions: Sequence[Function], notices: Sequence[Notice]) -> dict[str, object]:
    """The fields that an analysis and a performance share, for an utterance that was heard."""
    return {
        "audio": {"duration_s": None if utterance.duration_s is None else utterance.duration_s - utterance.lead_in_s},
        "words": utterance.words,
        "fillers": utterance.fillers,
        "stress": utterance.thresholds,
        "agitation": utterance.agitation and utterance.agitation.level,
        "memberships": utterance.agitation,
        "parse": utterance.parse,
        "functions": _functions(functions, utterance),
        "warnings": notices,
    }


def _functions(functions: Sequence[Function], utterance: Utterance) -> list[FunctionResponse]:
    return [FunctionResponse.of(function, utterance.words) for function in functions]
