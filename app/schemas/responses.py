"""The JSON responses of command line and HTTP API, made from the values of `understudy.model`.

Responses about authored resources are in `understudy.schemas.library`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Self

from ..errors import UnderstudyError
from ..model import AlignedLine, Analysis, Contours, Function, Level, Notice, Performance, SignalAnalysis, Utterance
from .line_parts import (
    AffectResponse,
    AudioResponse,
    BehaviorResponse,
    ContoursResponse,
    FillerResponse,
    FocusResponse,
    FunctionResponse,
    LineAffectResponse,
    MembershipsResponse,
    MomentResponse,
    ParseResponse,
    StressResponse,
    VisemeResponse,
    WarningResponse,
    WordResponse,
)
from .response_model import Number, ResponseModel

if TYPE_CHECKING:
    from ..bml.writing.writer import SpeechFile


class StatusResponse(ResponseModel):
    """Whether the service works; `not_reloaded` says why files saved since are not in use."""

    status: str
    not_reloaded: str | None = None


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
    """The speaker's agitation in one file, and how the voice sounds."""

    file: str
    agitation: Level
    memberships: MembershipsResponse
    affect: AffectResponse

    @classmethod
    def of(cls, file: str, heard: SignalAnalysis) -> Self:
        level, affect = heard.agitation.level, AffectResponse.of(heard.affect)
        return cls.model_validate({"file": file, "agitation": level, "memberships": heard.agitation, "affect": affect})


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
    """The analysis of a line, before behaviours are chosen; `stress` is absent where there is no recording."""

    audio: AudioResponse
    words: list[WordResponse]
    fillers: list[FillerResponse]
    stress: StressResponse | None = None
    agitation: Level
    memberships: MembershipsResponse
    affect: LineAffectResponse | None = None
    focus: list[FocusResponse]
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

    The recording starts at `lead_in_s`; all times are from the start of the performance. `targets` are the positions of
    things and listeners, metres, Y up, the performer at the origin facing +Z.
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
    """The file that SmartBody requires in the folder of the recording, under this name."""

    name: str
    bml: str

    @classmethod
    def of(cls, speech_file: SpeechFile) -> Self:
        return cls(name=speech_file.name, bml=speech_file.content.decode())


class PerformResponse(ResponseModel):
    """The response to `POST /perform` if JSON is requested; `listeners` has each listener's BML by name, `speech_file`
    the file SmartBody requires beside the recording, `contours` f0 and energy if the options ask for them."""

    bml: str
    speech_file: SpeechFileResponse | None = None
    listeners: dict[str, str] | None = None
    performance: PerformanceResponse
    contours: ContoursResponse | None = None
    warnings: list[WarningResponse]

    @classmethod
    def of(
        cls,
        performance: Performance,
        bml: bytes,
        listeners: Mapping[str, bytes] = MappingProxyType({}),
        speech_file: SpeechFile | None = None,
        contours: Contours | None = None,
    ) -> Self:
        response = PerformanceResponse.of_performance(performance)
        heard = {name: block.decode() for name, block in listeners.items()}
        return cls(
            bml=bml.decode(),
            speech_file=None if speech_file is None else SpeechFileResponse.of(speech_file),
            listeners=heard or None,
            performance=response,
            contours=None if contours is None else ContoursResponse.of(contours),
            warnings=response.warnings,
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
        "affect": utterance.affect and LineAffectResponse.of_line(utterance.affect),
        "focus": [word for word in utterance.words if word.focus is not None],
        "parse": utterance.parse,
        "functions": _functions(functions, utterance),
        "warnings": notices,
    }


def _functions(functions: Sequence[Function], utterance: Utterance) -> list[FunctionResponse]:
    return [FunctionResponse.of(function, utterance.words) for function in functions]
