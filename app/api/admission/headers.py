"""HTTP headers: the checks of Host and Origin, against DNS rebinding and requests from other pages, and the headers of
every answer: what browsers may do with it, its id, and which pages of other origins may read it.

The id is the client's if it is well-formed, otherwise a new one; it is on the answer and in the log.
"""

import logging
import re
from collections.abc import Collection, Sequence
from contextvars import ContextVar
from ipaddress import ip_address
from urllib.parse import urlsplit
from uuid import uuid4

from fastapi import FastAPI
from starlette.datastructures import MutableHeaders
from starlette.middleware.cors import CORSMiddleware

_USUAL_PORTS = {"http": 80, "https": 443}
_PORT = re.compile(r":\d{0,5}", re.ASCII)


def is_allowed(host: str | None, allowed: Sequence[str]) -> bool:
    """Whether a Host header has an allowed name; ".example.org" allows all subdomains, an empty list everything."""
    if not allowed:
        return True
    name = _name(host)
    return any(name == each or (each.startswith(".") and name.endswith(each)) for each in allowed)


def is_loopback(name: str | None) -> bool:
    """Whether a Host header or an address is loopback, which no other machine can claim."""
    found = _name(name)
    try:
        return found == "localhost" or found.endswith(".localhost") or ip_address(found.strip("[]")).is_loopback
    except ValueError:  # another name
        return False


def is_own_page(origin: str, host: str | None, allowed: Collection[str]) -> bool:
    """Whether an Origin header is the service's own or allowed. Behind a proxy that ends TLS the schemes differ, so
    only host and port are compared."""
    if origin in allowed:
        return True
    try:
        page, called = urlsplit(origin), urlsplit(f"//{host or ''}")
        usual = _USUAL_PORTS.get(page.scheme)
        is_same = page.hostname == called.hostname and (page.port or usual) == (called.port or usual)
        return is_same and usual is not None
    except ValueError:  # a port that is none
        return False


def _name(host: str | None) -> str:
    """Without its port, in lower case; IPv6 keeps its brackets. Empty if it is not a name, or the port no number."""
    host = (host or "").lower()
    if host.startswith("["):
        name, closed, port = host.partition("]")
        name += closed
    elif host.count(":") > 1:
        name, port = host, ""
    else:
        name, colon, port = host.partition(":")
        port = colon + port
    return name.rstrip(".") if not port or _PORT.fullmatch(port) else ""


_EVERY_ANSWER = {
    "x-content-type-options": "nosniff",
    "content-security-policy": "default-src 'none'; frame-ancestors 'none'",
    "cross-origin-resource-policy": "same-origin",
    "referrer-policy": "no-referrer",
}


def set_headers(headers: MutableHeaders, request_id: str) -> None:
    """Sets the headers that the answer does not have already: a page with scripts has its own policy."""
    for name, value in _EVERY_ANSWER.items():
        headers.setdefault(name, value)
    headers["X-Request-ID"] = request_id


REQUEST_ID = "x-request-id"

_SANE = re.compile(r"[A-Za-z0-9._-]{1,64}", re.ASCII)

current_id: ContextVar[str] = ContextVar("current_id", default="")
"""The id of the request that this task answers."""


def request_id(sent: str | None) -> str:
    """The id of a request with this header."""
    return sent if sent is not None and _SANE.fullmatch(sent) else uuid4().hex


class WithRequestId(logging.Filter):
    """Gives records the attribute `request_id`, and `request` to end a line with."""

    def filter(self, record: logging.LogRecord) -> bool:
        found = current_id.get()
        record.__dict__ |= {"request_id": found, "request": f" [{found}]" if found else ""}
        return True


_TAKEN = ("Accept", "Authorization", "Content-Type", "X-Request-ID")
_SHOWN = ("Retry-After", "Understudy-Warnings", "X-Request-ID")
_REMEMBERED_S = 600


def let_in_pages(app: FastAPI, origins: Sequence[str]) -> None:
    """Adds CORS outside of all other middleware, for preflight requests have no key."""
    app.add_middleware(
        CORSMiddleware,
        allow_origins=list(origins),
        allow_methods=("GET", "POST"),
        allow_headers=_TAKEN,
        expose_headers=_SHOWN,
        max_age=_REMEMBERED_S,
    )
