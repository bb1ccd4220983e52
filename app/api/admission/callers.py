"""Who asks, so far as the service can tell callers apart: by their key, else by their address."""

from starlette.requests import HTTPConnection


def caller_of(connection: HTTPConnection) -> str:
    """The name of the key that a request or WebSocket was let in with, else the address that it comes from."""
    address = connection.client.host if connection.client else ""
    return str(getattr(connection.state, "key", None) or address)
