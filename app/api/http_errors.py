"""Answers below the application, to what is no request that it could answer, as bytes to be written to a connection."""

from http import HTTPStatus

from starlette.responses import Response

from .problems import MEDIA_TYPE, problem


def bad_request(detail: str) -> bytes:
    """What is no HTTP, or not here; the connection is to be closed."""
    return _written(problem(400, "http_error", detail))


def connections_full() -> bytes:
    """No more connections are taken; the connection is to be closed."""
    return _written(
        problem(503, "connections_full", "too many connections are open; try again in a moment"), "retry-after: 1"
    )


def _written(answer: Response, *headers: str) -> bytes:
    body = bytes(answer.body)
    first = f"HTTP/1.1 {answer.status_code} {HTTPStatus(answer.status_code).phrase}"
    told = (first, f"content-type: {MEDIA_TYPE}", *headers, "connection: close", f"content-length: {len(body)}")
    return "\r\n".join((*told, "", "")).encode() + body
