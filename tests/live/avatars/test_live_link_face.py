"""Datagrams as Live Link Face sends them, read by the layout that other readers document."""

import struct
from dataclasses import dataclass
from typing import Self

import numpy as np
import pytest

from understudy.live.avatars.live_link_face import ORDER, LiveLinkFaceWriter
from understudy.live.body import BodyFrame
from understudy.realizer.body.motion import SHAPES

LAYOUT_NUMBERS = {
    "eyeBlinkLeft": 0,
    "eyeWideLeft": 6,
    "eyeBlinkRight": 7,
    "eyeLookOutRight": 10,
    "jawForward": 14,
    "jawLeft": 15,
    "jawRight": 16,
    "jawOpen": 17,
    "mouthClose": 18,
    "mouthPucker": 20,
    "mouthLeft": 21,
    "mouthSmileLeft": 23,
    "mouthStretchRight": 30,
    "mouthRollLower": 31,
    "mouthPressLeft": 35,
    "mouthUpperUpRight": 40,
    "browDownLeft": 41,
    "browInnerUp": 43,
    "cheekPuff": 46,
    "noseSneerLeft": 49,
    "tongueOut": 51,
}
"""Of Unreal's EARFaceBlendShape."""


@dataclass
class _Reader:
    content: bytes
    place: int = 0

    def numbers(self, form: str) -> tuple[float, ...]:
        found = struct.unpack_from(f">{form}", self.content, self.place)
        self.place += struct.calcsize(f">{form}")
        return found

    def text(self) -> str:
        (length,) = self.numbers("i")
        self.place += int(length)
        return self.content[self.place - int(length) : self.place].decode()

    @classmethod
    def of(cls, frame: BodyFrame, rate_hz: int) -> Self:
        (datagram,) = LiveLinkFaceWriter(rate_hz, subject="Ada").datagrams(frame)
        return cls(datagram)


def frame(at_s: float = 0.0, **shapes: float) -> BodyFrame:
    weights = np.zeros(len(SHAPES))
    for name, weight in shapes.items():
        weights[SHAPES.index(name)] = weight
    return BodyFrame(at_s, np.zeros((1, 4)), np.zeros(3), weights)


def test_the_head_of_a_datagram() -> None:
    read = _Reader.of(frame(at_s=2.5), 60)
    assert read.numbers("B") == (6,)
    assert len(read.text()) == 36
    assert read.text() == "Ada"
    assert read.numbers("ifiiB") == (150, 0.0, 60, 1, 61)
    assert len(read.content) - read.place == 61 * 4


@pytest.mark.parametrize(("name", "number"), LAYOUT_NUMBERS.items())
def test_shapes_stand_where_readers_look_for_them(name: str, number: int) -> None:
    read = _Reader.of(frame(**{name: 0.25}), 30)
    values = struct.unpack(">61f", read.content[-61 * 4 :])
    assert [place for place, value in enumerate(values) if value] == [number]
    assert values[number] == 0.25


def test_every_shape_is_sent_once() -> None:
    assert sorted(ORDER) == sorted(SHAPES)
