"""Binds the service's address before anything is loaded, so that a wrong or taken one is reported at once."""

import socket
from collections.abc import Sequence
from contextlib import ExitStack
from errno import EADDRNOTAVAIL, EAFNOSUPPORT
from typing import Any

from ..errors import InputError

BACKLOG = 2048

Address = tuple[Any, ...]
"""The address in the form of the socket's family: host, port and further fields."""


def bind(host: str, port: int) -> tuple[socket.socket, ...]:
    """A socket for every address of `host`, all on one port; nobody can connect before `listen`.

    Raises InputError `address_unusable`.
    """
    with ExitStack() as undo:
        bound: list[socket.socket] = []
        try:
            for family, address in _addresses(host, port):
                if found := _bound(family, _on_port(address, bound)):
                    bound.append(undo.enter_context(found))
            if not bound:
                raise OSError(EADDRNOTAVAIL, "no such address on this machine")
        except (OSError, UnicodeError) as error:
            raise _unusable(host, port, error) from None
        undo.pop_all()
    return tuple(bound)


def listen(bound: Sequence[socket.socket]) -> None:
    """Lets clients connect. Raises InputError `address_unusable` if another process has begun to listen in the
    meantime."""
    for each in bound:
        try:
            each.listen(BACKLOG)
        except OSError as error:
            host, port = each.getsockname()[:2]
            raise _unusable(host, port, error) from None


def shown_address(bound: socket.socket) -> str:
    """The address as a URL."""
    host, port = bound.getsockname()[:2]
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def _addresses(host: str, port: int) -> list[tuple[socket.AddressFamily, Address]]:
    found = socket.getaddrinfo(host or None, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
    return list(dict.fromkeys((family, address) for family, _, _, _, address in found))


def _on_port(address: Address, bound: Sequence[socket.socket]) -> Address:
    """The address with the port of the first socket, if the system was to choose one."""
    return (address[0], bound[0].getsockname()[1], *address[2:]) if bound else address


def _bound(family: socket.AddressFamily, address: Address) -> socket.socket | None:
    """None where the machine has no such address, for example ::1 where IPv6 is off. Raises OSError."""
    try:
        made = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)  # named, so that asyncio sets TCP_NODELAY
        made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        if family == socket.AF_INET6:
            made.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
    except OSError as error:
        if error.errno == EAFNOSUPPORT:
            return None
        raise
    try:
        made.bind(address)
    except OSError as error:
        made.close()
        if error.errno == EADDRNOTAVAIL:
            return None
        raise
    return made


def _unusable(host: str, port: int, error: OSError | UnicodeError) -> InputError:
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    message = f"{host}:{port}: cannot be listened on: {reason}; choose another with --host and --port"
    return InputError("address_unusable", message, field="port")
