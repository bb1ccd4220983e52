"""Sends frames to a program as datagrams. One that cannot be sent is lost, as others are on their way."""

import socket
from typing import Protocol

from ...errors import InputError
from ..body import BodyFrame


class FrameWriter(Protocol):
    """A protocol's datagrams."""

    def datagrams(self, frame: BodyFrame) -> list[bytes]: ...


class FrameSender:
    """Sends each frame at once to (host, port)."""

    def __init__(self, address: tuple[str, int], writer: FrameWriter) -> None:
        """Raises InputError `address_unusable` for a host that is not known."""
        try:
            found = socket.getaddrinfo(*address, type=socket.SOCK_DGRAM)[0]
        except OSError as error:
            host, port = address
            raise InputError("address_unusable", f"{host}:{port}: {error.strerror}; give HOST:PORT") from None
        self._address, self._writer = found[4], writer
        self._socket = socket.socket(found[0], socket.SOCK_DGRAM)
        self._socket.setblocking(False)
        self.lost = 0
        """How many datagrams could not be sent."""

    def send(self, frame: BodyFrame) -> None:
        for datagram in self._writer.datagrams(frame):
            try:
                self._socket.sendto(datagram, self._address)
            except OSError:
                self.lost += 1

    def close(self) -> None:
        self._socket.close()
