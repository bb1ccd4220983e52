"""What every answer says to browsers: it is what it claims to be, and no page may do anything with it."""

from starlette.datastructures import MutableHeaders

_EVERY_ANSWER = {
    "x-content-type-options": "nosniff",
    "content-security-policy": "default-src 'none'; frame-ancestors 'none'",
    "cross-origin-resource-policy": "same-origin",
    "referrer-policy": "no-referrer",
}


def set_headers(headers: MutableHeaders, request_id: str) -> None:
    """Adds them, but where an answer has its own, as a page that loads scripts has its own policy."""
    for name, value in _EVERY_ANSWER.items():
        headers.setdefault(name, value)
    headers["X-Request-ID"] = request_id
