"""The requests and responses of the operations for authors, in OpenAPI."""

from collections.abc import Mapping
from types import MappingProxyType

from .answers import Json, answer
from .operations import FILE, WORK, Operation, form, named

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
