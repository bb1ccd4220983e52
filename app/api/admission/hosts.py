"""Checks of the Host and Origin headers, against DNS rebinding and requests from other pages."""

from collections.abc import Collection, Sequence
from ipaddress import ip_address
from urllib.parse import urlsplit

_USUAL_PORTS = {"http": 80, "https": 443}


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
    """Without its port, in lower case; IPv6 keeps its brackets."""
    host = (host or "").lower()
    if host.startswith("["):
        return host.partition("]")[0] + "]"
    return (host if host.count(":") > 1 else host.partition(":")[0]).rstrip(".")
