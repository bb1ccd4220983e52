"""The requests and responses of each operation, in OpenAPI.

OpenAPI cannot describe WebSockets: for `/live` the document has the request that opens a stream, and the schemas of the
client's messages.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from pydantic import BaseModel

from ...schemas.live import CommandMessage, ListenMessage, SilenceMessage, StartMessage, WordsMessage
from ..negotiation import MOTION_TYPES
from .answers import JSON, Json, answer, errors, reference

XML = "application/xml"
FORM = "multipart/form-data"

FILE: Json = {"type": "string", "format": "binary"}
_BML: Json = {"type": "string", "description": "BML 1.0 core, or SmartBody's."}
_TEXT: Json = {
    "type": "string",
    "minLength": 1,
    "description": "The words that are spoken.",
    "examples": ["No, I have never seen those."],
}
_BML_EXAMPLE = (
    '<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="line" characterId="default">'
    '<head id="b1" lexeme="SHAKE" start="0.1" stroke="0.4" end="0.9"/></bml>'
)
_FUNCTIONS: Json = {
    "type": "array",
    "items": reference("GivenFunctionRequest"),
    "description": "Communicative functions that are known already.",
}

LINES = "Lines"

_EVERYWHERE = {401, 421, 429, 500}
WORK = {400, 403, 406, 408, 413, 415, 422, 429, 503, 504} | _EVERYWHERE


@dataclass(frozen=True, slots=True)
class Operation:
    """`answers` are the responses when all is well; `is_open` where no key is asked."""

    id: str
    tag: str
    summary: str
    answers: Json
    statuses: frozenset[int] = frozenset(_EVERYWHERE)
    body: Json = field(default_factory=dict)
    is_open: bool = False

    def described(self) -> Json:
        """The operation's object in an OpenAPI document."""
        body = {"requestBody": {"required": True, "content": self.body}} if self.body else {}
        responses = self.answers | errors(self.statuses)
        security: Json = {"security": []} if self.is_open else {}
        named = {"operationId": self.id, "tags": [self.tag], "summary": self.summary}
        return {**named, **body, "responses": responses, **security}


def form(required: list[str], parts: dict[str, Json], example: Json) -> Json:
    """The body of a form with these parts."""
    schema = {"type": "object", "required": required, "additionalProperties": False, "properties": parts}
    in_json = {"options", "functions", "direction", "edits", "rules"}
    as_json = {name: {"contentType": JSON} for name in parts if name in in_json}
    return {FORM: {"schema": schema, "encoding": as_json, "example": example}}


def _of_file(media_type: str) -> Json:
    """Binary, or text."""
    return FILE if media_type.startswith("model/") else {"type": "string"}


def named(name: str) -> Json:
    """A JSON body of this schema."""
    return {JSON: {"schema": reference(name)}}


_PERFORM = Operation(
    "perform",
    LINES,
    "Perform a line",
    answer(
        "The performance: BML, or JSON by `Accept`.",
        {XML: {"schema": _BML, "example": _BML_EXAMPLE}, **named("PerformResponse")},
        warned=True,
    ),
    frozenset(WORK),
    form(
        ["text"],
        {
            "audio": {
                **FILE,
                "description": "WAV, FLAC or OGG; without it the text is timed by `words`, or at an average rate.",
            },
            "text": _TEXT,
            "options": reference("PerformOptions"),
            "words": {**FILE, "description": "Word times from another aligner: a .json, .TextGrid or .ctm file."},
            "functions": _FUNCTIONS,
            "direction": reference("DirectionRequest"),
            "rules": reference("RuleEditsRequest"),
            "reference": {**FILE, "description": "What `understudy reference` writes (.json), or a recording."},
            "edits": reference("EditsForm"),
            "profile": {**FILE, "description": "The gesture profile to use, as a file (.yaml)."},
        },
        {"text": "No, I have never seen those.", "options": {"agitation": "high", "seed": 7}},
    ),
)
_REALIZE = Operation(
    "realize",
    LINES,
    "Play BML",
    answer(
        "The motion, by `Accept`: a clip as JSON, GLB, BVH, VRMA, USD, FBX, MPEG-4's parameters, the face's CSV or a "
        "list of visemes; or a timeline of what happens, for OpenTimelineIO, Praat, ELAN or as CSV.",
        {
            **named("ClipResponse"),
            **{media_type: {"schema": _of_file(media_type)} for media_type in MOTION_TYPES if media_type != JSON},
        },
        warned=True,
    ),
    frozenset(WORK | {501}),
    {
        **form(
            ["bml"],
            {
                "bml": {**FILE, "description": _BML["description"]},
                "audio": {**FILE, "description": "The recording of the speech, for lips and words."},
                "avatar": {**FILE, "description": "Your own GLB or VRM, to wear the motion in GLB."},
                "motion_model": {
                    "type": "string",
                    "description": "The motion model that moves arms, trunk and head to the recording, by name: "
                    "`default`, or the NAME of a `motion/NAME.npz` in the service's own lexicon.",
                },
                "scenario": {
                    "type": "string",
                    "description": "What drives the motion model: `S1` to `S6`, or `RTS`. Omitted: `S1`.",
                },
                "options": reference("RealizeOptions"),
            },
            {"bml": _BML_EXAMPLE, "options": {"fps": 30}},
        ),
        XML: {"schema": _BML, "example": _BML_EXAMPLE},
    },
)
_FIND_FUNCTIONS = Operation(
    "find_functions",
    LINES,
    "Find the functions of a text",
    answer("The communicative functions of the text.", named("FunctionsResponse")),
    frozenset(WORK - {406}),
    named("FunctionsRequest"),
)


def _listing(operation_id: str, summary: str, response: str) -> Operation:
    return Operation(operation_id, "Library", summary, answer(summary, named(response)))


def _probe(operation_id: str, summary: str, statuses: frozenset[int]) -> Operation:
    answers = answer(f"{summary}.", named("StatusResponse"))
    return Operation(operation_id, "Operations", summary, answers, statuses, is_open=True)


OPERATIONS: Mapping[tuple[str, str], Operation] = MappingProxyType(
    {
        ("post", "/perform"): _PERFORM,
        ("post", "/realize"): _REALIZE,
        ("post", "/functions"): _FIND_FUNCTIONS,
        ("get", "/characters"): _listing("list_characters", "Who can perform", "CharactersResponse"),
        ("get", "/gestures"): _listing("list_gestures", "The library of gestures", "GesturesResponse"),
        ("get", "/rules"): _listing("list_rules", "Rules, mappings and table entries", "RulesResponse"),
        ("get", "/lexicon"): _listing("list_words", "Words and phrases", "RulesResponse"),
        ("get", "/healthz"): _probe("is_alive", "The process answers", frozenset({500})),
        ("get", "/readyz"): _probe("is_ready", "Lines can be performed", frozenset({500, 503})),
        ("get", "/metrics"): Operation(
            "read_metrics",
            "Operations",
            "Figures for Prometheus",
            answer("The figures.", {"text/plain": {"schema": {"type": "string"}}}),
        ),
    }
)
"""By method and path."""

LIVE = "/live"
LIVE_MESSAGES: tuple[type[BaseModel], ...] = (
    StartMessage,
    WordsMessage,
    SilenceMessage,
    ListenMessage,
    CommandMessage,
)
"""The text messages of a client; its binary messages are sound."""

_TOLD = (
    "A WebSocket: speech in, movements out, as it goes on. The client sends `StartMessage` first, then binary messages "
    "of 16-bit little-endian samples, and `WordsMessage`, `SilenceMessage`, `ListenMessage` and `CommandMessage` as "
    "JSON in text. The service answers JSON in text, each with a `type`: `ready`, the behaviours (`gesture`, `head`, "
    "`face`, `gaze`, `eyes`, `posture`), `withdrawn`, `mouth`, `frame`, `frames_skipped`, `error`, `done`. A browser "
    "offers its key as the protocol `understudy.key.` and the key as base64url, beside `understudy`. docs/live.md has "
    "all of it."
)


def live_operation() -> Json:
    """The operation's object in an OpenAPI document."""
    switched = {"101": {"description": "The connection is a WebSocket from now on."}}
    named = {"operationId": "live", "tags": ["Live"], "summary": "Speech in, movements out, while it is spoken"}
    return {**named, "description": _TOLD, "responses": switched | errors({401, 403, 421, 429})}


AUTHORING = "Authoring"

_MOTION: Json = {
    **named("ClipResponse"),
    "model/gltf-binary": {"schema": FILE},
    "text/x-bvh": {"schema": {"type": "string"}},
}
_WITHOUT_FORM = frozenset(WORK - {406})


def _worked(operation_id: str, summary: str, request: str, response: str) -> Operation:
    return Operation(
        operation_id, AUTHORING, summary, answer(f"{summary}.", named(response)), _WITHOUT_FORM, named(request)
    )


def _known(operation_id: str, summary: str, response: str, statuses: frozenset[int] = frozenset()) -> Operation:
    answers = answer(f"{summary}.", named(response))
    return Operation(operation_id, AUTHORING, summary, answers, frozenset({401, 421, 500}) | statuses)


def _saved(operation_id: str, summary: str) -> Operation:
    return Operation(
        operation_id,
        AUTHORING,
        summary,
        answer("The file as it is saved.", named("RuleFileResponse")),
        frozenset({400, 401, 403, 404, 408, 412, 413, 421, 422, 429, 500, 503, 504}),
        {"text/plain": {"schema": {"type": "string"}}},
    )


AUTHORING_OPERATIONS: Mapping[tuple[str, str], Operation] = MappingProxyType(
    {
        ("get", "/gestures/language"): _known(
            "read_gesture_language", "The words of the gesture language", "GestureLanguageResponse"
        ),
        ("post", "/gestures/check"): _worked(
            "check_gestures",
            "Gestures as text and values, with every mistake",
            "GestureCheckRequest",
            "GestureCheckResponse",
        ),
        ("post", "/gestures/motion"): Operation(
            "play_gesture",
            AUTHORING,
            "Play one gesture",
            answer("The motion, by `Accept`.", _MOTION),
            frozenset(WORK),
            named("GestureMotionRequest"),
        ),
        ("post", "/gestures/pose"): Operation(
            "take_pose",
            AUTHORING,
            "A pose as angles of joints",
            answer("The angles of each arm's joints.", named("AvatarPoseResponse")),
            _WITHOUT_FORM,
            form(
                ["avatar"],
                {
                    "avatar": {**FILE, "description": "A GLB or VRM file, left in the pose or with an animation."},
                    "options": {"$ref": "#/components/schemas/AvatarPoseOptions"},
                },
                {"options": {"time_s": 0.5}},
            ),
        ),
        ("get", "/rules/files"): _known("list_rule_files", "The files of rules and words", "RuleFilesResponse"),
        ("get", "/rules/files/{name}"): _known(
            "read_rule_file", "A file of rules or words", "RuleFileResponse", frozenset({404, 422})
        ),
        ("put", "/rules/files/{name}"): _saved("save_rule_file", "Save a file of rules or words"),
        ("get", "/lexicon/files"): _known(
            "list_lexicon_files", "The files of gestures, characters, profiles and weights", "RuleFilesResponse"
        ),
        ("get", "/lexicon/files/{name}"): _known(
            "read_lexicon_file",
            "A file of gestures, a character, a profile or weights",
            "RuleFileResponse",
            frozenset({404, 422}),
        ),
        ("put", "/lexicon/files/{name}"): _saved(
            "save_lexicon_file", "Save a file of gestures, a character, a profile or weights"
        ),
        ("post", "/rules/check"): _worked(
            "check_rules", "The mistakes of edited rules", "RuleEditsRequest", "RuleCheckResponse"
        ),
        ("post", "/rules/explain"): _worked(
            "explain_rule", "What a rule takes part in", "RuleExplanationRequest", "RuleExplanationsResponse"
        ),
        ("post", "/rules/compare"): _worked(
            "compare_rules", "What edited rules change", "RuleComparisonRequest", "RuleComparisonResponse"
        ),
    }
)
"""By method and path."""
