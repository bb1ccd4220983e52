"""Every error is answered as `application/problem+json` (RFC 9457) with a stable type and code."""

import logging
import math
from collections.abc import Sequence
from functools import partial
from http import HTTPStatus

from fastapi import FastAPI
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

MEDIA_TYPE = "application/problem+json"
LONGEST_DETAIL = 2000
OUR_MISTAKE = "the service failed at this request; what happened has been logged"

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
