"""The middleware that every request and WebSocket passes: it sets the id, admits or refuses, and logs one line.

Neither content nor query is logged.
"""

import logging
import time
from dataclasses import dataclass

from fastapi import FastAPI
from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from ...errors import LONGEST_SHOWN
from ..problems import unexpected
from .admission import PROBES, Admission, Arrival
from .headers import REQUEST_ID, current_id, request_id, set_headers
from .keys import authorization

_STARTS = frozenset({"http.response.start", "websocket.http.response.start"})
_SWITCHING, _FORBIDDEN, _FAILED = 101, 403, 500

_LOGGER = logging.getLogger("understudy.requests")


def guard(app: FastAPI, admission: Admission) -> None:
    """Adds the middleware to `app`, whose errors are problem documents already."""
    app.add_middleware(AdmissionMiddleware, admission=admission)
    app.add_exception_handler(Exception, _marked_failure)


async def _marked_failure(request: Request, error: Exception) -> Response:
    """The answer to a bug, which is sent outside of all middleware."""
    answer = await unexpected(request, error)
    set_headers(answer.headers, current_id.get())
    return answer


class AdmissionMiddleware:
    """ASGI middleware that applies an `Admission`."""

    def __init__(self, app: ASGIApp, admission: Admission) -> None:
        self._app = app
        self._admission = admission

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        current_id.set(request_id(headers.get(REQUEST_ID)))
        scope.setdefault("state", {})["key"] = self._admission.keys.current.name(authorization(headers))
        refusal = self._admission.refusal(_arrival(scope, headers))
        answer = _Answer(send)
        begun_s = time.perf_counter()
        try:
            await (self._app if refusal is None else refusal)(scope, receive, answer.send)
        finally:
            _log(scope, answer.status, time.perf_counter() - begun_s)


@dataclass(slots=True)
class _Answer:
    """Adds headers to the answer and records its status; a WebSocket closed before it was accepted has status 403."""

    to: Send
    status: int = _FAILED

    async def send(self, message: Message) -> None:
        if message["type"] in _STARTS:
            self.status = message["status"]
            set_headers(MutableHeaders(scope=message), current_id.get())
        elif message["type"] == "websocket.accept":
            self.status = _SWITCHING
        elif message["type"] == "websocket.close" and self.status == _FAILED:
            self.status = _FORBIDDEN
        await self.to(message)


def _arrival(scope: Scope, headers: Headers) -> Arrival:
    server, client = scope.get("server") or ("", None), scope.get("client") or ("", None)
    is_websocket = scope["type"] == "websocket"
    method = "GET" if is_websocket else scope["method"]
    return Arrival(scope["path"], headers, method, is_websocket, str(server[0]), server[1], str(client[0]))


def _log(scope: Scope, status: int, took_s: float) -> None:
    client = scope.get("client")
    fields = {
        "method": scope.get("method", "GET"),
        "path": scope["path"][:LONGEST_SHOWN],
        "status": status,
        "took_s": round(took_s, 3),
        "client": client[0] if client else None,
        "key": scope["state"]["key"],
    }
    told = f"{fields['method']} {fields['path']!r} {status} in {took_s:.3f} s for {fields['client']}"
    level = logging.DEBUG if scope["path"] in PROBES and status == 200 else logging.INFO
    _LOGGER.log(level, told + (f" with key {fields['key']}" if fields["key"] else ""), extra={"fields": fields})
