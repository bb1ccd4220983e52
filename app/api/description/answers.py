"""The responses of the OpenAPI document: a shared error for each status, and the success of each operation."""

from collections.abc import Iterable
from http import HTTPStatus
from typing import Any

from ..problems import CODES

Json = dict[str, Any]

JSON = "application/json"
PROBLEM = "application/problem+json"
REQUEST_ID_HEADER = "X-Request-ID"

_REASONS = {
    400: "Not decodable: broken audio, JSON, timed words or form.",
    401: "An API key is missing or wrong.",
    403: "The request is not allowed here, or not from this page.",
    404: "No such path.",
    405: "The path does not support this method; `Allow` lists those that it does.",
    406: "`Accept` allows none of the offered types.",
    408: "The body arrived too slowly.",
    412: "The file is no longer what was read.",
    413: "Too large or too long.",
    415: "A type or format that is not supported.",
    421: "The request names another host.",
    422: "The content is wrong; `field` and `detail` say where and why.",
    429: "Too many requests, or wrong API keys, from one address; try again after `Retry-After`.",
    500: "A fault of the service.",
    501: "The format needs something that is not installed with the service.",
    503: "The service is full or stopping; try again after `Retry-After`.",
    504: "Not done within the deadline.",
}
_RETRIED = {429, 503}

SHARED_HEADERS: Json = {
    "RequestId": {
        "description": "The request's id: the one that was sent, or a new one.",
        "schema": {"type": "string"},
    },
    "RetryAfter": {"description": "Seconds after which to try again.", "schema": {"type": "integer", "minimum": 1}},
    "Warnings": {
        "description": "The codes of what was degraded, dropped or guessed.",
        "schema": {"type": "string"},
        "example": "audio_clipped, pronunciation_guessed",
    },
}
_ANSWERED = {REQUEST_ID_HEADER: {"$ref": "#/components/headers/RequestId"}}
_WARNED = {**_ANSWERED, "Understudy-Warnings": {"$ref": "#/components/headers/Warnings"}}


def shared_errors() -> Json:
    """The error of each status, by the name that `errors` refers to."""
    return {_name(status): _error(status) for status in CODES}


def errors(statuses: Iterable[int]) -> Json:
    """The responses of an operation that can end in these statuses."""
    return {str(status): {"$ref": f"#/components/responses/{_name(status)}"} for status in sorted(statuses)}


def answer(description: str, content: Json, *, warned: bool = False) -> Json:
    """The response of an operation that succeeds."""
    return {"200": {"description": description, "headers": _WARNED if warned else _ANSWERED, "content": content}}


def reference(name: str) -> Json:
    """A reference to a schema."""
    return {"$ref": f"#/components/schemas/{name}"}


def _error(status: int) -> Json:
    code = CODES[status][0]
    example = {
        "type": f"urn:understudy:error:{code}",
        "title": HTTPStatus(status).phrase,
        "status": status,
        "code": code,
        "detail": "what, where, and what would be right",
    }
    retry = {"Retry-After": {"$ref": "#/components/headers/RetryAfter"}} if status in _RETRIED else {}
    codes = ", ".join(f"`{code}`" for code in CODES[status])
    return {
        "description": f"{_REASONS[status]} Codes: {codes}.",
        "headers": _ANSWERED | retry,
        "content": {PROBLEM: {"schema": reference("Problem"), "example": example}},
    }


def _name(status: int) -> str:
    return "".join(word.capitalize() for word in HTTPStatus(status).phrase.split())
