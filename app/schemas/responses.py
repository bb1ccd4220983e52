"""The JSON responses of command line and HTTP API, made from the values of `understudy.model`.

A key is absent if there is no value (a time without audio, the winner where no conflict was lost). Numbers are rounded
to `DECIMALS`, so that equal values give equal bytes on all platforms. Most models read attributes of the same name:
`PhraseResponse.model_validate(phrase)`. Responses about authored resources are in `understudy.schemas.library`.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Annotated, Self

from pydantic import AfterValidator, AliasPath, BaseModel, BeforeValidator, ConfigDict, Field
from pydantic.config import JsonDict

from ..analysis import AlignedLine, Analysis
from ..bml.writing.writer import SpeechFile
from ..errors import UnderstudyError
from ..model import PLAIN, Agitation, Function, Level, Notice, Performance, SyncPoints, Utterance, Word

DECIMALS = 6


def _rounded(number: float) -> float:
    return round(number, DECIMALS) + 0.0  # adding zero turns -0.0, which is written "-0.0", into 0.0


def _set_points(sync: SyncPoints) -> dict[str, float]:
    return dict(sync.in_order())


def _if_so(flag: bool) -> bool | None:
    return flag or None


Number = Annotated[float, AfterValidator(_rounded)]
Times = Annotated[dict[str, Number], BeforeValidator(_set_points)]


def _open(schema: JsonDict) -> None:
    """Clients are told that further fields may come, so that a new one breaks none."""
    schema.pop("additionalProperties", None)


class ResponseModel(BaseModel):
    """Base class of all responses."""

    model_config = ConfigDict(frozen=True, extra="forbid", from_attributes=True, json_schema_extra=_open)

    def to_json(self, indent: int | None = None) -> bytes:
        """The response as UTF-8 JSON without a final line break; on one line unless `indent` is given."""
        return self.model_dump_json(by_alias=True, exclude_none=True, indent=indent).encode()


class StatusResponse(ResponseModel):
    """Whether the service works; `not_reloaded` says why files that were saved since are not in use."""

    status: str
    not_reloaded: str | None = None


class WarningResponse(ResponseModel):
    """A notice about something degraded, dropped or guessed."""

    code: str
    message: str


class PhoneResponse(ResponseModel):
    """A phone: ARPABET without stress digit; the stress is separate and known only for some input formats."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    stress: int | None = None


class WordResponse(ResponseModel):
    """A word of the transcript; one that is not spoken, such as a lone dash, has no times.

    `spread` is present, and true, if the times are estimated from loudness.
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
    """A hesitation sound that is not a word of the transcript."""

    text: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))


class AudioResponse(ResponseModel):
    """The recording."""

    duration_s: Number


class StressResponse(ResponseModel):
    """The utterance's stress thresholds; a frame above either is stressed."""

    energy_db: Number
    f0_hz: Number | None = None


class MembershipsResponse(ResponseModel):
    """The fuzzy memberships of the voice in the levels of agitation; they sum to 1."""

    low: Number
    medium: Number
    high: Number


class TokenResponse(ResponseModel):
    """A token of the parser: `word` is the index of its transcript word, `head` the index of its governor."""

    index: int
    word: int
    text: str
    lemma: str
    part_of_speech: str
    tag: str
    dependency: str
    head: int


class PhraseResponse(ResponseModel):
    """A noun phrase or verb group, by word indices."""

    kind: str
    first: int
    last: int
    head: int


class ClauseResponse(ResponseModel):
    """A clause, by word indices."""

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
    """One support of a function: a word of the transcript, or a fact with the rule that derived it."""

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
        """`words` are those of the whole transcript, for the function's text and times."""
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
    """A scheduled behaviour; the times of `sync` are seconds from the start of the audio."""

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
    moment: str | None = None
    kept: bool
    lost_to: str | None = None
    reason: str | None = None
    after_strokes_s: list[Number] | None = None


class TermResponse(ResponseModel):
    """A reason for a choice, and its weight in log-odds."""

    name: str
    weight: Number


class RejectedResponse(ResponseModel):
    """Families that a moment does not show, their expected worth, and why they lost."""

    families: list[str]
    worth: Number
    reason: str


class MomentResponse(ResponseModel):
    """A stretch of words that means something to hands, head or face: the families that would be right, the likeliest
    first, the terms that made the first one win, and what lost. `note` is the number of the director's note,
    `set_against` the word of the stroke that shows the other side of a contrast."""

    id: str
    channel: str
    first: int
    last: int
    stroke: int
    families: list[str]
    shares: list[Number]
    importance: Number
    terms: list[TermResponse]
    rejected: list[RejectedResponse]
    note: int | None = None
    set_against: int | None = None


class VisemeResponse(ResponseModel):
    """A viseme: `articulation` is how far its shape is reached, `opening` how wide the jaw opens."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    articulation: Number
    opening: Number


class AlignResponse(ResponseModel):
    """Timed words and phones, and the fillers between them."""

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
    """The communicative functions of a text; `id` is returned as it was sent."""

    id: str | int | None = None
    functions: list[FunctionResponse]

    @classmethod
    def of(cls, analysis: Analysis, line_id: str | int | None = None) -> Self:
        return cls(id=line_id, functions=_functions(analysis.functions, analysis.utterance))


class ErrorResponse(ResponseModel):
    """An error's code and message."""

    code: str
    message: str


class MistakeResponse(ResponseModel):
    """The response to an invalid line among many."""

    id: str | int | None = None
    error: ErrorResponse

    @classmethod
    def of(cls, error: UnderstudyError, line_id: str | int | None) -> Self:
        return cls(id=line_id, error=ErrorResponse.model_validate(error))


class AnalysisResponse(ResponseModel):
    """The analysis of a line, before behaviours are chosen."""

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
    """A listener's behaviours during the line."""

    name: str
    behaviors: list[BehaviorResponse]


class PerformanceResponse(AnalysisResponse):
    """The complete performance: the analysis, and the chosen behaviours with their reasons.

    The recording starts at `lead_in_s`; all times are from the start of the performance. `targets` are where things and
    listeners are, metres, Y up, the performer at the origin facing +Z.
    """

    character: str
    seed: int
    lead_in_s: Number
    stillness: Number
    moments: list[MomentResponse]
    behaviors: list[BehaviorResponse]
    visemes: list[VisemeResponse]
    listeners: list[ListeningResponse] | None = None
    targets: dict[str, tuple[float, float, float]] | None = None

    @classmethod
    def of_performance(cls, performance: Performance) -> Self:
        understood = _understood(performance.utterance, performance.functions, performance.notices)
        names = ("character", "seed", "stillness", "moments", "behaviors", "visemes")
        chosen = {name: getattr(performance, name) for name in names}
        begun = {"lead_in_s": performance.utterance.lead_in_s}
        targets = {target.name: target.position_m for target in performance.targets}
        others = {"listeners": performance.listeners or None, "targets": targets or None}
        return cls.model_validate(understood | chosen | begun | others)


class SpeechFileResponse(ResponseModel):
    """The file that SmartBody wants in the folder of the recording, under this name."""

    name: str
    bml: str

    @classmethod
    def of(cls, speech_file: SpeechFile) -> Self:
        return cls(name=speech_file.name, bml=speech_file.content.decode())


class PerformResponse(ResponseModel):
    """The response to `POST /perform` if JSON is requested; `listeners` has each listener's BML by name, `speech_file`
    what SmartBody wants beside the recording."""

    bml: str
    speech_file: SpeechFileResponse | None = None
    listeners: dict[str, str] | None = None
    performance: PerformanceResponse
    warnings: list[WarningResponse]

    @classmethod
    def of(
        cls,
        performance: Performance,
        bml: bytes,
        listeners: Mapping[str, bytes] = MappingProxyType({}),
        speech_file: SpeechFile | None = None,
    ) -> Self:
        told = PerformanceResponse.of_performance(performance)
        heard = {name: block.decode() for name, block in listeners.items()}
        return cls(
            bml=bml.decode(),
            speech_file=None if speech_file is None else SpeechFileResponse.of(speech_file),
            listeners=heard or None,
            performance=told,
            warnings=told.warnings,
        )


def _understood(utterance: Utterance, functions: Sequence[Function], notices: Sequence[Notice]) -> dict[str, object]:
    """The fields common to analysis and performance, for an utterance with audio."""
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
