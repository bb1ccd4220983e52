"""Every error leaves as `application/problem+json` (RFC 9457) with a stable type and code."""

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
)
from .unknown_paths import unknown_method, unknown_path

MEDIA_TYPE = "application/problem+json"
LONGEST_DETAIL = 2000
OUR_MISTAKE = "the service failed at this request; what happened has been logged"

_LOGGER = logging.getLogger(__name__)

_STATUS_OF_CLASS: tuple[tuple[type[UnderstudyError], int], ...] = (
    (UndecodableError, 400),
    (ForbiddenError, 403),
    (NotAcceptableError, 406),
    (SlowClientError, 408),
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
    """Installs the handlers of every error that can leave `app`, whose paths are `known`."""
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
    """When to come again, in whole seconds, where the error says so."""
    after_s = error.retry_after_s if isinstance(error, ServiceError | TooManyError) else None
    return None if after_s is None else {"Retry-After": str(max(1, math.ceil(after_s)))}


async def _refused(request: Request, error: Exception, *, known: Sequence[str]) -> Response:
    """What the framework or an endpoint refuses: no such path (but those known), method or representation."""
    assert isinstance(error, HTTPException)
    code = _CODE_OF_STATUS.get(error.status_code, "http_error")
    detail = error.detail
    if detail == HTTPStatus.NOT_FOUND.phrase:
        detail = unknown_path(request.url.path, known)
    elif detail == HTTPStatus.METHOD_NOT_ALLOWED.phrase:
        detail = unknown_method(request, error)
    return problem(error.status_code, code, detail, headers=dict(error.headers or {}))


async def _gone(_request: Request, _error: Exception) -> Response:
    """The client went away while it sent; nobody reads this answer."""
    return problem(400, "client_disconnected", "the connection closed before the request was complete")


async def unexpected(_request: Request, _error: Exception) -> Response:
    """A mistake of ours; the server logs its traceback, the answer tells nothing of the inside."""
    return problem(500, "internal_error", OUR_MISTAKE)
