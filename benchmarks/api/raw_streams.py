"""WebSockets of `/live` by hand, on sockets that a test may fill, reset and leave half-open; no library would."""

import base64
import json
import os
import socket
import struct
from collections.abc import Mapping
from contextlib import suppress

from .watching import HOST

KEY = base64.b64encode(b"understudy-drill").decode()
HEAD = (
    "GET /live HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
    f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {KEY}\r\n"
)
_TEXT, _BINARY = 0x81, 0x82
LARGEST_RECEIVED = 1 << 16


def upgrade(port: int, more: str = "\r\n", timeout_s: float = 5.0) -> socket.socket:
    """A connection on which an upgrade was asked for, with further headers or whatever else."""
    connection = socket.create_connection((HOST, port), timeout=timeout_s)
    connection.sendall((HEAD.format(port=port) + more).encode())
    return connection


def opened(port: int, start: Mapping[str, object] | None = None) -> socket.socket:
    """A stream that was accepted and started. Raises OSError where it was not."""
    connection = upgrade(port)
    if b" 101 " not in connection.recv(LARGEST_RECEIVED):
        connection.close()
        raise OSError("no WebSocket")
    say(connection, {"type": "start"} | dict(start or {}))
    return connection


def say(connection: socket.socket, message: Mapping[str, object] | bytes) -> None:
    """Sends a message: JSON, or sound."""
    is_sound = isinstance(message, bytes)
    content = message if isinstance(message, bytes) else json.dumps(message).encode()
    mask = os.urandom(4)
    connection.sendall(bytes([_BINARY if is_sound else _TEXT]) + _length(len(content)) + mask + _masked(content, mask))


def fill(connection: socket.socket, message: Mapping[str, object] | bytes, most: int = 10_000) -> None:
    """Sends the same message until nobody takes it for half a second."""
    connection.settimeout(0.5)
    with suppress(OSError):
        for _ in range(most):
            say(connection, message)


def reset(connection: socket.socket) -> None:
    """Breaks the connection off without a word."""
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    connection.close()


def _length(size: int) -> bytes:
    if size < 126:
        return bytes([0x80 | size])
    return b"\xfe" + struct.pack("!H", size) if size < 1 << 16 else b"\xff" + struct.pack("!Q", size)


def _masked(content: bytes, mask: bytes) -> bytes:
    whole = int.from_bytes(content, "big") ^ int.from_bytes((mask * (len(content) // 4 + 1))[: len(content)], "big")
    return whole.to_bytes(len(content), "big")
