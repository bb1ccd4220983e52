"""The names that the service may be called by, so that no web page can reach it under a name of its own."""

from collections.abc import Sequence


def is_allowed(host: str | None, allowed: Sequence[str]) -> bool:
    """Whether a Host header has one of the names, ".example.org" for all below example.org; without names, any has."""
    if not allowed:
        return True
    name = _without_port(host or "").lower().rstrip(".")
    return any(name == each or (each.startswith(".") and name.endswith(each)) for each in allowed)


def _without_port(host: str) -> str:
    if host.startswith("["):
        return host.partition("]")[0] + "]"
    return host.partition(":")[0]
