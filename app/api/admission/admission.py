"""Every request comes in here: it gets its id, is let in or told why not, and leaves a line in the log.

In this order: the host that it names, the port it came to, its API key. `/healthz` and `/readyz` are answered to all,
for what asks them knows neither names nor keys; so are `/docs`, `/openapi.json` and the studio page, which tell nothing
that is not public. Nothing of a request's content is logged.
"""

import logging
import time
from dataclasses import dataclass
from ipaddress import ip_address
from typing import Self

from fastapi import FastAPI
from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from ...errors import LONGEST_SHOWN, InputError
from ...settings import PREFIX, Settings
from ..problems import problem, unexpected
from ..unknown_paths import unknown_path
from .headers import set_headers
from .hosts import is_allowed
from .keys import ApiKeys, authorization
from .request_ids import HEADER, current_id, request_id

PROBES = frozenset({"/healthz", "/readyz"})
DOCS = ("/docs", "/openapi.json")
STUDIO = ("", "/studio")
"""The studio page, which is at `/`, and what it loads."""
METRICS = "/metrics"

_LOGGER = logging.getLogger("understudy.requests")


@dataclass(frozen=True, slots=True)
class Admission:
    """Who may come in. `operations_port` alone answers operators' paths if there is one, and nothing else; the paths
    `closed` are answered nowhere."""

    keys: ApiKeys
    hosts: tuple[str, ...] = ()
    operations_port: int | None = None
    closed: tuple[str, ...] = ()

    @classmethod
    def of(cls, settings: Settings) -> Self:
        """Raises InputError `setting_wrong`."""
        hosts = (settings.allowed_hosts or "").lower().replace(",", " ").split()
        answered = {(METRICS,): settings.metrics, DOCS: settings.docs, STUDIO: settings.studio}
        closed = tuple(path for paths, is_open in answered.items() if not is_open for path in paths)
        return cls(ApiKeys.of(settings), tuple(hosts), settings.operations_port, closed)

    def refusal(self, path: str, port: int | None, headers: Headers) -> Response | None:
        """Why a request is not let in; None where it is."""
        if path in PROBES:
            return None
        if not is_allowed(headers.get("host"), self.hosts):
            return problem(421, "host_unknown", "this service has another name; send the Host that it is known by")
        is_operators_port = self.operations_port is not None and port == self.operations_port
        is_elsewhere = self.operations_port is not None and _is_under(path, (METRICS, *DOCS)) != is_operators_port
        if is_elsewhere or _is_under(path, self.closed):
            return problem(404, "not_found", unknown_path(path))
        if not self.keys.digests or is_operators_port or _is_under(path, (*DOCS, *STUDIO)):
            return None
        if self.keys.name(authorization(headers)) is None:
            sent = "the API key is wrong" if "authorization" in headers else "an API key is missing"
            challenge = {"WWW-Authenticate": "Bearer"}
            return problem(401, "key_wrong", f"{sent}; send it as Authorization: Bearer KEY", headers=challenge)
        return None


def require_keys(admission: Admission, address: str, settings: Settings) -> None:
    """Raises InputError `key_missing` where anybody on the network could come in who was not meant to."""
    if ip_address(address.partition("%")[0]).is_loopback or admission.keys.digests or settings.allow_anonymous:
        return
    told = f"give {PREFIX}API_KEYS or {PREFIX}API_KEYS_FILE, or {PREFIX}ALLOW_ANONYMOUS=1 behind what checks callers"
    raise InputError("key_missing", f"{address} can be reached by others, and no API key is asked of them: {told}")


def guard(app: FastAPI, admission: Admission) -> None:
    """Puts the door before `app`, whose errors are problems already."""
    app.add_middleware(Admitted, admission=admission)
    app.add_exception_handler(Exception, _marked_failure)


async def _marked_failure(request: Request, error: Exception) -> Response:
    """The answer to a mistake of ours, which is sent from outside of all middleware."""
    answer = await unexpected(request, error)
    set_headers(answer.headers, current_id.get())
    return answer


class Admitted:
    """ASGI middleware that does as an `Admission` says."""

    def __init__(self, app: ASGIApp, admission: Admission) -> None:
        self._app = app
        self._admission = admission

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        current_id.set(request_id(headers.get(HEADER)))
        server = scope.get("server")
        scope.setdefault("state", {})["key"] = self._admission.keys.name(authorization(headers))
        refusal = self._admission.refusal(scope["path"], server[1] if server else None, headers)
        if scope["type"] == "websocket":
            await (
                self._app(scope, receive, send) if refusal is None else send({"type": "websocket.close", "code": 1008})
            )
            return
        begun_s, status = time.perf_counter(), 500

        async def marked(message: Message) -> None:
            nonlocal status
            if message["type"] == "http.response.start":
                status = message["status"]
                set_headers(MutableHeaders(scope=message), current_id.get())
            await send(message)

        try:
            await (self._app if refusal is None else refusal)(scope, receive, marked)
        finally:
            self._log(scope, status, time.perf_counter() - begun_s)

    def _log(self, scope: Scope, status: int, took_s: float) -> None:
        client = scope.get("client")
        fields = {
            "method": scope["method"],
            "path": scope["path"][:LONGEST_SHOWN],
            "status": status,
            "took_s": round(took_s, 3),
            "client": client[0] if client else None,
            "key": scope["state"]["key"],
        }
        told = f"{fields['method']} {fields['path']!r} {status} in {took_s:.3f} s for {fields['client']}"
        level = logging.DEBUG if scope["path"] in PROBES and status == 200 else logging.INFO
        _LOGGER.log(level, told + (f" with key {fields['key']}" if fields["key"] else ""), extra={"fields": fields})


def _is_under(path: str, places: tuple[str, ...]) -> bool:
    """Whether a path is one of the places or below it; "" is `/` alone."""
    return any(path == (place or "/") or (place and path.startswith(f"{place}/")) for place in places)
