"""Runs the service until it is stopped.

The address is bound before anything is loaded, so that a wrong or taken one is reported at once. Everything is loaded,
and the bundled example performed once, before the first request is accepted: a mistake in rules or settings is reported
like any other, and the first caller does not wait for initialization.
"""

import signal
import socket
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from errno import EADDRNOTAVAIL, EAFNOSUPPORT
from pathlib import Path
from typing import Any

from ..api.admission.access import Admission, require_keys
from ..api.application import create_app
from ..api.serving import serve
from ..api.workers.processes import Nursery
from ..errors import InputError
from ..settings import Settings
from ..studio.pages import OpenedLine
from ..studio.scenes import OpenedScene
from .log import Log


def _nothing(_address: str) -> None:
    """The default of `when_started`: does nothing."""


def run_service(
    settings: Settings,
    log: Log,
    *,
    reload: bool = False,
    opened: OpenedLine | OpenedScene | None = None,
    author_folder: Path | None = None,
    when_started: Callable[[str], None] = _nothing,
) -> int:
    """Listens on the address in the settings; `when_started` is called with the first address, as a URL. Rules edited
    in the page can be saved in `author_folder`.

    Raises KeyboardInterrupt, after everything has ended, if that is what stopped it; InputError `address_unusable`,
    `key_missing` and `setting_wrong`.
    """
    admission = Admission.of(settings)
    ports = [settings.port, *([settings.operations_port] if settings.operations_port else [])]
    with ExitStack() as stack:
        sockets = [stack.enter_context(each) for port in ports for each in bind(settings.host, port)]
        for each in sockets:
            require_keys(admission, each.getsockname()[0], settings)
        log_config = log.service_logging()
        nursery = stack.enter_context(Nursery.start(settings, logging=log_config))
        app = create_app(settings, nursery, reload=reload, opened=opened, author_folder=author_folder)
        listen(sockets)
        addresses = [shown_address(each) for each in sockets]

        def told() -> None:
            log.note("\n".join(f"listening on {address}" for address in addresses))
            when_started(addresses[0])

        stopped_by = serve(app, settings, sockets, log_config=log_config, when_started=told)
    if stopped_by == signal.SIGINT:
        raise KeyboardInterrupt
    return 0


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
