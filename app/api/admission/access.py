"""Access control: which requests are admitted, the answers to all others, and the middleware that every request and
WebSocket passes: it sets the id, admits or refuses, and logs one line, with neither content nor query.

Checked in this order: the host, the origin, the port, the API key. `/healthz` and `/readyz` are open to all, for probes
know neither names nor keys; `/docs`, `/openapi.json` and the studio page need no key, for they are public.
"""

import logging
import time
from dataclasses import dataclass, field
from functools import partial
from ipaddress import ip_address
from typing import Self

from fastapi import FastAPI
from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from ...errors import LONGEST_SHOWN, InputError
from ...settings import PREFIX, Settings
from ..problems import problem, unexpected, unknown_path
from .headers import REQUEST_ID, current_id, is_allowed, is_loopback, is_own_page, request_id, set_headers
from .keys import KeyRing, authorization
from .rates import Guesses

PROBES = frozenset({"/healthz", "/readyz"})
DOCS = ("/docs", "/openapi.json")
STUDIO = ("", "/studio")
"""The studio page, which is at `/`, and what it loads."""
METRICS = "/metrics"

_ONLY_READS = frozenset({"GET", "HEAD", "OPTIONS"})


@dataclass(frozen=True, slots=True)
class Arrival:
    """A request or WebSocket on arrival: its target, its sender and its headers."""

    path: str
    headers: Headers
    method: str = "GET"
    is_websocket: bool = False
    server: str = ""
    port: int | None = None
    address: str = ""


@dataclass(frozen=True, slots=True)
class Admission:
    """The rules of admission. `operations_port`, if any, serves operators' paths and nothing else; paths in `closed`
    are not served; pages of `origins` have the rights of the service's own."""

    keys: KeyRing
    hosts: tuple[str, ...] = ()
    origins: tuple[str, ...] = ()
    operations_port: int | None = None
    closed: tuple[str, ...] = ()
    is_anonymous: bool = False
    guesses: Guesses = field(default_factory=Guesses)

    @classmethod
    def of(cls, settings: Settings) -> Self:
        """Raises InputError `setting_wrong`."""
        pages = {"metrics": (METRICS,), "docs": DOCS, "studio": STUDIO}
        closed = tuple(path for name in settings.closed_pages for path in pages[name])
        hosts, origins = settings.host_names, settings.origins
        return cls(KeyRing(settings), hosts, origins, settings.operations_port, closed, settings.allow_anonymous)

    def refusal(self, arrival: Arrival) -> Response | None:
        """The answer that refuses the request; None if it is admitted."""
        path = arrival.path
        if path in PROBES:
            return None
        if refused := self._wrong_place(arrival):
            return refused
        is_operators_port = self.operations_port is not None and arrival.port == self.operations_port
        is_elsewhere = self.operations_port is not None and _is_under(path, (METRICS, *DOCS)) != is_operators_port
        if is_elsewhere or _is_under(path, self.closed):
            return problem(404, "not_found", unknown_path(path))
        if not self.keys.current.are_asked or is_operators_port or _is_under(path, (*DOCS, *STUDIO)):
            return None
        return self._wrong_key(arrival)

    def lets_in(self, headers: Headers) -> bool:
        """Whether the key that came with a request is still one of those in use, if any is needed."""
        keys = self.keys.current
        return not keys.are_asked or keys.name(authorization(headers)) is not None

    def _wrong_place(self, arrival: Arrival) -> Response | None:
        """Refuses an unknown host, a foreign origin, and two ways of stating the length."""
        host, origin = arrival.headers.get("host"), arrival.headers.get("origin")
        if not self._is_named(host, arrival.server):
            return problem(
                421, "host_unknown", "this service does not answer to that host name; send a Host it is known by"
            )
        does_more = arrival.is_websocket or arrival.method not in _ONLY_READS
        if does_more and origin is not None and not is_own_page(origin, host, self.origins):
            message = f"requests from other origins are refused; {PREFIX}ALLOWED_ORIGINS lists the permitted ones"
            return problem(403, "origin_refused", message)
        if {"content-length", "transfer-encoding"} <= set(arrival.headers):
            message = "send either Content-Length or Transfer-Encoding, not both"
            return problem(400, "http_error", message, headers={"Connection": "close"})
        return None

    def _is_named(self, host: str | None, server: str) -> bool:
        """Whether the host is allowed. Without a list and without keys, a service on loopback accepts loopback names
        only."""
        is_private = not self.hosts and not self.keys.current.are_asked and not self.is_anonymous
        return is_loopback(host) if is_private and is_loopback(server) else is_allowed(host, self.hosts)

    def _wrong_key(self, arrival: Arrival) -> Response | None:
        sent = authorization(arrival.headers)
        name = self.keys.current.name(sent)
        if sent is not None and (wait_s := self.guesses.wait_s(arrival.address, name)) is not None:
            headers = {"Retry-After": str(int(wait_s) + 1)}
            return problem(429, "too_many_wrong_keys", "too many wrong API keys came from here", headers=headers)
        if name is not None:
            return None
        told = "an API key is missing" if sent is None else "the API key is wrong, or has expired"
        challenge = {"WWW-Authenticate": "Bearer"}
        return problem(401, "key_wrong", f"{told}; send it as Authorization: Bearer KEY", headers=challenge)


def require_keys(admission: Admission, address: str, settings: Settings) -> None:
    """Raises InputError `key_missing` if a service without keys could be reached from the network."""
    if ip_address(address.partition("%")[0]).is_loopback or admission.keys.current.are_asked:
        return
    if settings.allow_anonymous:
        return
    told = (
        f"give {PREFIX}API_KEYS or {PREFIX}API_KEYS_FILE, or {PREFIX}ALLOW_ANONYMOUS=1 behind a proxy that checks "
        "callers"
    )
    raise InputError("key_missing", f"{address} can be reached by others, and no API key is required of them: {told}")


def _is_under(path: str, places: tuple[str, ...]) -> bool:
    """Whether a path is one of the places or below it; "" is `/` alone."""
    return any(path == (place or "/") or (place and path.startswith(f"{place}/")) for place in places)


LETS_IN = "lets_in"
"""The name in a request's state of what says whether its key is still in use."""

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
        scope["state"][LETS_IN] = partial(self._admission.lets_in, headers)
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
