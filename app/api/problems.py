"""Every error is answered as `application/problem+json` (RFC 9457) with a stable type and code."""

import logging
import math
from collections.abc import Sequence
from enum import StrEnum
from functools import partial
from http import HTTPStatus
from types import MappingProxyType
from typing import Annotated

from fastapi import FastAPI
from pydantic import BaseModel, Field
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response

from ..errors import (
    LONGEST_SHOWN,
    ChangedError,
    ForbiddenError,
    InputError,
    NotAcceptableError,
    ServiceError,
    SlowClientError,
    TooLargeError,
    TooManyError,
    UndecodableError,
    UnderstudyError,
    UnsupportedFormatError,
    nearest_names,
)

CODES = MappingProxyType(
    {
        400: (
            *("audio_undecodable", "audio_truncated", "audio_length_unstated", "text_not_utf8", "timings_unreadable"),
            *("avatar_undecodable", "not_json", "form_broken", "client_disconnected"),
        ),
        401: ("key_wrong",),
        403: ("rules_read_only", "origin_refused"),
        404: ("not_found",),
        405: ("method_not_allowed",),
        406: ("not_acceptable",),
        408: ("upload_slow",),
        412: ("file_changed",),
        413: (
            *("audio_too_large", "audio_too_long", "text_too_long", "bml_too_large", "body_too_large"),
            *("field_too_large", "work_too_large"),
        ),
        415: ("audio_format_unsupported", "audio_codec_unsupported", "timings_format", "media_type"),
        421: ("host_unknown",),
        422: (
            *("audio_empty", "audio_too_short", "audio_sample_rate", "audio_channels", "audio_bad_sample"),
            *("audio_silent", "text_empty", "text_word_too_long", "text_control_character", "text_surrogate"),
            "affect_wrong",
            *("transcript_unspoken", "transcript_mismatch", "timings_words_differ", "timings_not_a_time"),
            *("timings_out_of_order", "timings_beyond_audio", "bml_wrong", "unknown_character", "unknown_avatar"),
            *("unknown_skeleton", "value_wrong", "functions_wrong", "functions_class", "functions_span"),
            *("reference_unreadable", "reference_other_features", "direction_wrong", "direction_family"),
            *("direction_importance", "direction_span", "not_an_object", "field_missing", "field_unknown"),
            *("field_repeated", "motion_too_large", "target_wrong", "unknown_target", "unknown_profile"),
            *("gesture_wrong", "unfit_gesture", "unknown_name", "rules_wrong", "rules_unreadable", "unknown_file"),
            *("edits_wrong", "profile_wrong", "tags_wrong", "lexicon_wrong", "agitation_model"),
            "file_wrong",
            *("bvh_wrong", "pairs_wrong", "motion_model"),
        ),
        429: ("too_many_requests", "too_many_wrong_keys"),
        500: (
            *("aligner_crashed", "model_unreadable", "model_damaged", "affect_model_failed", "plot_unavailable"),
            "parser_missing",
            *(
                "parser_incomplete",
                "parser_labels",
                "physics_missing",
                "lexicon_unlinked",
                "installation_incomplete",
                "nursery_ended",
                "internal_error",
            ),
        ),
        501: ("usd_missing", "blender_missing"),
        503: (*("service_full", "service_stopping", "uploads_full", "connections_full", "worker_lost", "not_ready"),),
        504: ("deadline_passed",),
    }
)
"""The codes of each status, as in docs/errors.md."""

ErrorCode = StrEnum("ErrorCode", [(code, code) for codes in CODES.values() for code in codes])  # type: ignore[misc]


class Problem(BaseModel):
    """What went wrong: `code` is stable, `detail` is for people, `field` names the part of the request at fault. Later
    versions may have further codes and further members."""

    type: Annotated[str, Field(examples=["urn:understudy:error:text_empty"])]
    title: Annotated[str, Field(examples=["Unprocessable Entity"])]
    status: Annotated[int, Field(examples=[422])]
    code: Annotated[ErrorCode | str, Field(examples=["text_empty"])]
    detail: Annotated[str, Field(examples=["the text has no words; send the words that are spoken"])]
    field: Annotated[str | None, Field(examples=["text"])] = None


MEDIA_TYPE = "application/problem+json"
LONGEST_DETAIL = 2000
OUR_MISTAKE = "the service failed on this request; the error has been logged"

_LOGGER = logging.getLogger(__name__)

_STATUS_OF_CLASS: tuple[tuple[type[UnderstudyError], int], ...] = (
    (UndecodableError, 400),
    (ForbiddenError, 403),
    (NotAcceptableError, 406),
    (SlowClientError, 408),
    (ChangedError, 412),
    (TooLargeError, 413),
    (UnsupportedFormatError, 415),
    (TooManyError, 429),
    (InputError, 422),
)
_STATUS_OF_SERVICE_CODE = {
    "service_full": 503,
    "uploads_full": 503,
    "service_stopping": 503,
    "worker_lost": 503,
    "not_ready": 503,
    "deadline_passed": 504,
    "usd_missing": 501,
    "blender_missing": 501,
}
_CODE_OF_STATUS = {404: "not_found", 405: "method_not_allowed", 406: "not_acceptable"}


def answer_errors_as_problems(app: FastAPI, known: Sequence[str] = ()) -> None:
    """Installs the error handlers of `app`, whose paths are `known`."""
    app.add_exception_handler(UnderstudyError, _known)
    app.add_exception_handler(HTTPException, partial(_refused, known=known))
    app.add_exception_handler(ClientDisconnect, _gone)
    app.add_exception_handler(Exception, unexpected)


def problem(
    status: int, code: str, detail: str, *, field: str | None = None, headers: dict[str, str] | None = None
) -> Response:
    """`field` names the part of the request at fault. Neither it nor `detail` is ever long, whatever was sent."""
    content = {
        "type": f"urn:understudy:error:{code}",
        "title": HTTPStatus(status).phrase,
        "status": status,
        "code": code,
        "detail": detail if len(detail) <= LONGEST_DETAIL else detail[:LONGEST_DETAIL] + "…",
    }
    if field is not None:
        content["field"] = field[:LONGEST_SHOWN]
    return JSONResponse(content, status, headers=headers, media_type=MEDIA_TYPE)


def status_of(error: UnderstudyError) -> int:
    """The HTTP status that tells `error`."""
    if isinstance(error, ServiceError):
        return _STATUS_OF_SERVICE_CODE.get(error.code, 500)
    return next((status for of_class, status in _STATUS_OF_CLASS if isinstance(error, of_class)), 500)


async def _known(_request: Request, error: Exception) -> Response:
    assert isinstance(error, UnderstudyError)
    status = status_of(error)
    if status == HTTPStatus.INTERNAL_SERVER_ERROR:
        _LOGGER.error("%s: %s", error.code, error.message)
        return problem(status, error.code, OUR_MISTAKE)
    field = error.field if isinstance(error, InputError) else None
    return problem(status, error.code, error.message, field=field, headers=_retry_after(error))


def _retry_after(error: UnderstudyError) -> dict[str, str] | None:
    """The Retry-After header in whole seconds, if the error has one."""
    after_s = error.retry_after_s if isinstance(error, ServiceError | TooManyError) else None
    return None if after_s is None else {"Retry-After": str(max(1, math.ceil(after_s)))}


async def _refused(request: Request, error: Exception, *, known: Sequence[str]) -> Response:
    """Errors of the framework: unknown path, method or representation."""
    assert isinstance(error, HTTPException)
    code = _CODE_OF_STATUS.get(error.status_code, "http_error")
    detail = error.detail
    if detail == HTTPStatus.NOT_FOUND.phrase:
        detail = unknown_path(request.url.path, known)
    elif detail == HTTPStatus.METHOD_NOT_ALLOWED.phrase:
        detail = unknown_method(request, error)
    return problem(error.status_code, code, detail, headers=dict(error.headers or {}))


async def _gone(_request: Request, _error: Exception) -> Response:
    """The client disconnected while sending; the answer is for the log."""
    return problem(400, "client_disconnected", "the connection closed before the request was complete")


async def unexpected(_request: Request, _error: Exception) -> Response:
    """A bug: the traceback is logged, the answer has no internals."""
    return problem(500, "internal_error", OUR_MISTAKE)


def unknown_path(path: str, known: Sequence[str] = ()) -> str:
    """The message for an unknown path, with the nearest known one."""
    near = nearest_names(path, known)
    return f"no such path: {path[:LONGEST_SHOWN]!r}{f'; did you mean {near[0]}?' if near else ''}"


def unknown_method(request: Request, error: HTTPException) -> str:
    """The message for a method that a path does not support, with those it does."""
    supported = (error.headers or {}).get("Allow", "")
    return f"{request.url.path[:LONGEST_SHOWN]!r} does not support {request.method[:LONGEST_SHOWN]!r}; send {supported}"


def bad_request(detail: str) -> bytes:
    """The bytes that answer malformed HTTP below the application; close the connection afterwards."""
    return _written(problem(400, "http_error", detail))


def connections_full() -> bytes:
    """The bytes that answer one connection too many; close the connection afterwards."""
    return _written(
        problem(503, "connections_full", "too many connections are open; try again in a moment"), "retry-after: 1"
    )


def _written(answer: Response, *headers: str) -> bytes:
    body = bytes(answer.body)
    first = f"HTTP/1.1 {answer.status_code} {HTTPStatus(answer.status_code).phrase}"
    told = (first, f"content-type: {MEDIA_TYPE}", *headers, "connection: close", f"content-length: {len(body)}")
    return "\r\n".join((*told, "", "")).encode() + body
