"""The names that the service may be called by, and the pages that may call it, so that no web page can reach it under a
name of its own (DNS rebinding) or from elsewhere."""

from collections.abc import Collection, Sequence
from ipaddress import ip_address
from urllib.parse import urlsplit

_USUAL_PORTS = {"http": 80, "https": 443}


def is_allowed(host: str | None, allowed: Sequence[str]) -> bool:
    """Whether a Host header has one of the names, ".example.org" for all below example.org; without names, any has."""
    if not allowed:
        return True
    name = _name(host)
    return any(name == each or (each.startswith(".") and name.endswith(each)) for each in allowed)


def is_loopback(name: str | None) -> bool:
    """Whether a Host header, or an address, is this machine's own: nobody else can have such a name."""
    found = _name(name)
    try:
        return found == "localhost" or found.endswith(".localhost") or ip_address(found.strip("[]")).is_loopback
    except ValueError:  # another name
        return False


def is_own_page(origin: str, host: str | None, allowed: Collection[str]) -> bool:
    """Whether an Origin header is that of the service's own pages, or one of those that are allowed. Proxies speak
    HTTP to a service whose pages are HTTPS, so schemes are not compared but for the port that they mean."""
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
