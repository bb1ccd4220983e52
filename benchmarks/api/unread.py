"""Clients that never read, and that read a byte now and then, of HTTP and of a live stream: how long it takes until the
service has cut them off, its kernel included, which would keep for minutes what nobody reads.

They have as little room for what comes as a kernel allows, ask for more than fits, and stay connected.
"""

import socket
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from threading import Event, Thread
from types import MappingProxyType

import psutil

from .bars import Bar
from .raw_streams import HEAD, LARGEST_RECEIVED, say
from .watching import HOST, Running, serving

CUT_OFF_WITHIN_S = 20.0
"""Twice `UNDERSTUDY_IDLE_S` of not reading, looked at as often as that lasts; a live stream has frames of some seconds
to fill first, and then as long."""

PATIENCE_S = 90.0
LEAST_BYTES = 4096
REQUEST = b"GET /openapi.json HTTP/1.1\r\nHost: localhost\r\n\r\n"
REQUESTS = 300
CHUNK_S, CHUNK = 0.1, bytes(3200)
NOW_AND_THEN_S = 0.5


def unread() -> Iterator[Bar]:
    """Each client alone with what it does, all at the same time, on one service."""
    with serving() as service, ExitStack() as stack:
        began_s = time.monotonic()
        clients = {name: stack.enter_context(begin(service.port)) for name, begin in BEGUN.items()}
        took_s = dict.fromkeys(clients, PATIENCE_S)
        while any(took == PATIENCE_S for took in took_s.values()) and time.monotonic() < began_s + PATIENCE_S:
            held = _held(service)
            for name, client in clients.items():
                if client.getsockname() not in held:
                    took_s[name] = min(took_s[name], time.monotonic() - began_s)
                elif name.endswith(NOW_AND_THEN):
                    with suppress(OSError):
                        client.recv(1)
            time.sleep(NOW_AND_THEN_S)
    for name, took in took_s.items():
        yield Bar(f"{name}: cut off", f"{took:.1f} s", f"{CUT_OFF_WITHIN_S:g} s", took <= CUT_OFF_WITHIN_S)


def _held(service: Running) -> set[tuple[object, ...]]:
    """The other ends of all connections that the kernel keeps for the service."""
    found = psutil.net_connections("tcp")
    return {tuple(each.raddr) for each in found if each.raddr and each.laddr[1:] == (service.port,)}


def _connected(port: int) -> socket.socket:
    connection = socket.socket()
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, LEAST_BYTES)
    connection.settimeout(NOW_AND_THEN_S)
    connection.connect((HOST, port))
    return connection


@contextmanager
def _asking(port: int) -> Iterator[socket.socket]:
    with _connected(port) as connection:
        with suppress(OSError):
            for _ in range(REQUESTS):
                connection.sendall(REQUEST)
        yield connection


@contextmanager
def _speaking(port: int) -> Iterator[socket.socket]:
    """A stream that asks for frames, and is spoken to in real time."""
    enough = Event()
    with _connected(port) as connection:
        connection.settimeout(PATIENCE_S)
        connection.sendall((HEAD.format(port=port) + "\r\n").encode())
        connection.recv(LARGEST_RECEIVED)
        connection.settimeout(NOW_AND_THEN_S)
        say(connection, {"type": "start", "frames": 60})

        def speak() -> None:
            with suppress(OSError):
                while not enough.wait(CHUNK_S):
                    say(connection, CHUNK)

        speaker = Thread(target=speak)
        speaker.start()
        yield connection
        enough.set()
        speaker.join()


NOW_AND_THEN = "reads a byte now and then"

BEGUN: Mapping[str, Callable[[int], AbstractContextManager[socket.socket]]] = MappingProxyType(
    {
        "a client that never reads": _asking,
        f"a client that {NOW_AND_THEN}": _asking,
        "a stream that never reads": _speaking,
        f"a stream that {NOW_AND_THEN}": _speaking,
    }
)
