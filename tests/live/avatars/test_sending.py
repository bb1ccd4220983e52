"""Frames on their way: one after the other to an address that is known."""

import socket

import numpy as np
import pytest

from understudy.errors import InputError
from understudy.live.avatars.sending import FrameSender
from understudy.live.body import BodyFrame

FRAME = BodyFrame(0.5, np.zeros((1, 4)), np.zeros(3), np.zeros(52))


class _Twice:
    """Two datagrams a frame."""

    def datagrams(self, frame: BodyFrame) -> list[bytes]:
        return [f"{frame.at_s}".encode(), b"x"]


def test_frames_arrive() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(5)
        sender = FrameSender(receiver.getsockname(), _Twice())
        sender.send(FRAME)
        assert [receiver.recv(100) for _ in range(2)] == [b"0.5", b"x"]
        sender.close()
        assert sender.lost == 0


def test_what_cannot_be_sent_is_lost_and_counted() -> None:
    sender = FrameSender(("127.0.0.1", 9), _Twice())
    sender.close()
    sender.send(FRAME)
    assert sender.lost == 2


def test_an_address_that_nobody_knows_is_refused() -> None:
    with pytest.raises(InputError) as raised:
        FrameSender(("no.such.host.invalid", 39539), _Twice())
    assert raised.value.code == "address_unusable"
